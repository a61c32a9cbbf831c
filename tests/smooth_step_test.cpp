// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth CAD solids of models whose volumes and faces are known.
#include "io/write_step.h"

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "boreholes/errors.h"
#include "io/coarse_facets.h"
#include "io/smooth_bodies.h"
#include "io/write_brep.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::grid_model;
using test::GridModel;

void expect_sound(const SmoothBodies& made, std::size_t bodies) {
    ASSERT_EQ(made.bodies.size(), bodies);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    for (std::size_t b = 0; b < bodies; ++b) {
        SCOPED_TRACE(made.reports[b].name);
        const TopoDS_Shape& solid = *made.bodies[b].solid;
        EXPECT_TRUE(made.reports[b].smooth);
        EXPECT_EQ(solid.ShapeType(), TopAbs_SOLID);
        EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
        for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next())
            EXPECT_TRUE(BRep_Tool::IsClosed(it.Current()));
        EXPECT_GT(made.reports[b].volume, 0);
    }
}

std::size_t shared_faces(const CadBody& a, const CadBody& b) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(*a.solid, TopAbs_FACE, faces);
    std::size_t shared = 0;
    for (TopExp_Explorer it(*b.solid, TopAbs_FACE); it.More(); it.Next())
        shared += faces.Contains(it.Current());
    return shared;
}

TEST(SmoothStep, level_layers_are_boxes) {
    const auto made = smooth_bodies(grid_model({.thickness = {test::constant(2), test::constant(3)}}));
    expect_sound(made, 2);
    for (std::size_t b = 0; b < 2; ++b) EXPECT_EQ(made.reports[b].faces, 6u);
    EXPECT_NEAR(made.reports[0].volume, 2e4, 1e-6 * 2e4);
    EXPECT_NEAR(made.reports[1].volume, 3e4, 1e-6 * 3e4);
    EXPECT_EQ(shared_faces(made.bodies[0], made.bodies[1]), 1u);
}

TEST(SmoothStep, a_tilted_plane_stays_one) {
    const auto made = smooth_bodies(grid_model(
        {.ground = [](double x, double y) { return 0.2 * x - 0.1 * y; }, .thickness = {test::constant(4)}}));
    expect_sound(made, 1);
    EXPECT_EQ(made.reports[0].faces, 6u);
    EXPECT_LT(made.reports[0].off, 1e-6 * 100);
    EXPECT_NEAR(made.reports[0].volume, 4e4, 1e-6 * 4e4);
}

TEST(SmoothStep, a_paraboloid_has_its_volume) {
    // Ground 10 - r^2 / 1000 about the middle over a level base at 0.
    const auto height = [](double x, double y) {
        return 10 - ((x - 50) * (x - 50) + (y - 50) * (y - 50)) / 1000;
    };
    const auto made = smooth_bodies(grid_model({.ground = height, .thickness = {height}}));
    expect_sound(made, 1);
    EXPECT_EQ(made.reports[0].faces, 6u);
    const double exact = 1e5 - 1e8 / 6 / 1000;
    EXPECT_NEAR(made.reports[0].volume, exact, 2e-3 * exact);
}

double lens(double x, double y, double cx, double cy, double radius, double height) {
    const double r = std::hypot(x - cx, y - cy) / radius;
    return r < 1 - 1e-9 ? height * (1 - r * r) : 0;
}

TEST(SmoothStep, a_lens_ends_in_an_edge_that_three_faces_share) {
    const auto made = smooth_bodies(grid_model(
        {.cells = 48,
         .thickness = {test::constant(5), [](double x, double y) { return lens(x, y, 50, 50, 30, 6); },
                       test::constant(5)},
         .rounds = {{50, 50, 30}}}));
    expect_sound(made, 3);
    EXPECT_EQ(made.reports[0].faces, 7u);   // top, four walls, on the lens, on what is below it
    EXPECT_LE(made.reports[1].faces, 8u);   // top and base, the base in strips
    EXPECT_LE(made.reports[2].faces, 20u);  // strips too: its base has the kink of the lens above
    EXPECT_EQ(shared_faces(made.bodies[0], made.bodies[1]), 1u);
    EXPECT_GE(shared_faces(made.bodies[1], made.bodies[2]), 1u);
    EXPECT_EQ(made.reports[1].faces,
              shared_faces(made.bodies[0], made.bodies[1]) + shared_faces(made.bodies[1], made.bodies[2]));
    EXPECT_EQ(shared_faces(made.bodies[0], made.bodies[2]), 1u);
    const double exact = std::numbers::pi * 30 * 30 * 6 / 2;
    EXPECT_NEAR(made.reports[1].volume, exact, 0.02 * exact);
    EXPECT_NEAR(made.reports[1].volume, made.reports[1].mesh_volume, 2e-3 * exact);
}

TEST(SmoothStep, layers_with_a_window_and_of_two_bodies) {
    const auto away_from = [](double radius) {
        return [radius](double x, double y) {
            const double r = std::hypot(x - 50, y - 50);
            return r > radius + 1e-9 ? 0.1 * (r - radius) : 0;
        };
    };
    const auto window =
        smooth_bodies(grid_model({.cells = 48,
                                  .thickness = {test::constant(5), away_from(20), test::constant(5)},
                                  .rounds = {{50, 50, 20}}}));
    expect_sound(window, 3);
    EXPECT_LE(window.reports[1].faces, 20u);
    const auto two = smooth_bodies(grid_model({.cells = 48,
                                               .thickness = {test::constant(5),
                                                             [](double x, double y) {
                                                                 return lens(x, y, 25, 50, 18, 4) +
                                                                        lens(x, y, 75, 50, 18, 4);
                                                             },
                                                             test::constant(5)},
                                               .rounds = {{25, 50, 18}, {75, 50, 18}}}));
    expect_sound(two, 4);
    EXPECT_EQ(two.bodies[1].name, "layer 2");
    EXPECT_EQ(two.bodies[2].name, "layer 2, body 2");
}

// The outline of what lies around two lenses that touch in a point comes there twice: as one wire, programs could not tell
// which way it goes on.
TEST(SmoothStep, wires_do_not_touch_themselves) {
    const auto diamond = [](double x, double y, double cx) {
        const double inside = 1 - (std::abs(x - cx) + std::abs(y - 50)) / 20;
        return inside > 1e-9 ? 4 * inside : 0;
    };
    const auto made = smooth_bodies(
        grid_model({.cells = 20,
                    .thickness = {test::constant(5),
                                  [&](double x, double y) { return diamond(x, y, 30) + diamond(x, y, 70); },
                                  test::constant(5)}}));
    ASSERT_EQ(made.bodies.size(), 4u);
    std::size_t most_wires = 0;
    for (const auto& body : made.bodies)
        for (TopExp_Explorer face(*body.solid, TopAbs_FACE); face.More(); face.Next()) {
            std::size_t wires = 0;
            for (TopExp_Explorer wire(face.Current(), TopAbs_WIRE); wire.More(); wire.Next(), ++wires) {
                TopTools_IndexedMapOfShape vertices, edges;
                TopExp::MapShapes(wire.Current(), TopAbs_VERTEX, vertices);
                TopExp::MapShapes(wire.Current(), TopAbs_EDGE, edges);
                EXPECT_EQ(vertices.Extent(), edges.Extent()) << body.name;
            }
            most_wires = std::max(most_wires, wires);
        }
    EXPECT_GE(most_wires, 3u);
}

TEST(SmoothStep, what_cannot_be_smooth_has_facets_and_neighbours_stay) {
    SmoothBodiesOptions strict;
    strict.volume_tolerance = 1e-12;
    const auto height = [](double x, double y) { return 5 + std::sin(x / 7) * std::cos(y / 9); };
    const auto made =
        smooth_bodies(grid_model({.ground = height, .thickness = {height, test::constant(3)}}), strict);
    ASSERT_EQ(made.bodies.size(), 2u);
    EXPECT_FALSE(made.reports[0].smooth);
    ASSERT_FALSE(made.notes.empty());
    EXPECT_NE(made.notes[0].find("'layer 1' is made of facets"), std::string::npos);
    EXPECT_TRUE(BRepCheck_Analyzer(*made.bodies[0].solid).IsValid());
    EXPECT_NEAR(made.reports[0].volume, made.reports[0].mesh_volume, 1e-9 * made.reports[0].mesh_volume);
}

TEST(SmoothStep, progress_goes_forward_over_all_attempts) {
    SmoothBodiesOptions options;
    std::vector<std::string> steps;
    std::vector<double> shares;
    options.progress = [&](const char* step, double share) {
        if (steps.empty() || steps.back() != step) steps.emplace_back(step);
        shares.push_back(share);
    };
    const auto two_layers = grid_model({.thickness = {test::constant(2), test::constant(3)}});
    smooth_bodies(two_layers, options);
    EXPECT_EQ(steps, (std::vector<std::string>{"fitting smooth faces", "checking smooth faces"}));
    EXPECT_GE(shares.size(), 3U);  // a sheet each at least
    EXPECT_TRUE(std::ranges::is_sorted(shares));

    options.most_off = -1;  // nothing is close enough
    steps.clear();
    shares.clear();
    smooth_bodies(two_layers, options);
    EXPECT_NE(std::ranges::find(steps, "fitting smooth faces, attempt 2"), steps.end());
    EXPECT_EQ(steps.back(), "making facets");
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GE(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
}

TEST(SmoothStep, facets_are_few_and_keep_the_volume) {
    // A lens and what is around it, refused: their facets must fit each other.
    const auto model = grid_model(
        {.cells = 40,
         .ground = [](double x, double y) { return std::sin(x / 30) * std::cos(y / 40); },
         .thickness = {test::constant(5), [](double x, double y) { return lens(x, y, 50, 50, 30, 6); },
                       test::constant(5)},
         .rounds = {{50, 50, 30}}});
    const PlanCells cells = build_plan_cells(model);
    ASSERT_EQ(cells.bodies.size(), 3u);
    const auto expect_volumes = [&](const CoarseFacets& coarse) {
        ASSERT_EQ(coarse.solids.size(), 3u);
        for (std::size_t b = 0; b < 3; ++b) {
            double volume = 0;
            const TriMesh& plan = model.plan.surface;
            for (const auto f : cells.bodies[b].faces)
                for (const auto v : plan.fv_range(plan.face_handle(f)))
                    volume += plan.calc_face_area(plan.face_handle(f)) / 3 *
                              model.thickness(b, static_cast<std::size_t>(v.idx()));
            EXPECT_TRUE(BRepCheck_Analyzer(*coarse.solids[b]).IsValid());
            EXPECT_NEAR(cad_volume(*coarse.solids[b]), volume, 2e-3 * volume) << b;
        }
    };
    for (const double error : {0.2, 0.02}) {
        const auto coarse = coarse_facets(model, cells, {0, 1, 2}, {.max_error = error});
        expect_volumes(coarse);
        EXPECT_LE(coarse.deviation, error);
    }
    // So few that the lens would lose some per cent.
    const auto fewest = coarse_facets(model, cells, {0, 1, 2}, {.max_error = 1, .most_triangles = 200});
    expect_volumes(fewest);
    EXPECT_LE(count_faces(*fewest.solids[1]), 400u);
    const auto few = coarse_facets(model, cells, {0}, {.max_error = 1e-6, .most_triangles = 1500});
    EXPECT_LE(count_faces(*few.solids[0]), 2 * 1500u + 200);
    EXPECT_GT(few.deviation, 1e-6);
}

// What is in the file, not what was meant to be.
TEST(SmoothStep, files_come_back_valid_closed_and_of_the_same_volume) {
    const auto file = std::filesystem::temp_directory_path() / "smooth_step_test_back.step";
    const auto report = write_smooth_step(
        file, grid_model({.cells = 48,
                          .ground = [](double x, double y) { return std::sin(x / 30) * std::cos(y / 40); },
                          .thickness = {test::constant(5),
                                        [](double x, double y) { return lens(x, y, 50, 50, 30, 6); },
                                        test::constant(5)},
                          .rounds = {{50, 50, 30}}}));
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    ASSERT_EQ(reader.ReadFile(file.string().c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    const TopoDS_Shape read = reader.OneShape();
    std::size_t b = 0;
    for (TopExp_Explorer it(read, TopAbs_SOLID); it.More(); it.Next(), ++b) {
        ASSERT_LT(b, report.bodies.size());
        SCOPED_TRACE(report.bodies[b].name);
        EXPECT_TRUE(BRepCheck_Analyzer(it.Current()).IsValid());
        for (TopExp_Explorer shell(it.Current(), TopAbs_SHELL); shell.More(); shell.Next())
            EXPECT_TRUE(BRep_Tool::IsClosed(shell.Current()));
        EXPECT_EQ(count_faces(it.Current()), report.bodies[b].faces);
        EXPECT_NEAR(cad_volume(it.Current()) / 1e9, report.bodies[b].mesh_volume,
                    2e-3 * report.bodies[b].mesh_volume);
        for (TopExp_Explorer edge(it.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
            double from = 0, to = 0;
            if (BRep_Tool::Curve(TopoDS::Edge(edge.Current()), from, to)->DynamicType()->Name() ==
                std::string("Geom_BSplineCurve")) {
                EXPECT_NEAR(from, 0, 1e-12);
                EXPECT_NEAR(to, 1, 1e-12);
            }
        }
    }
    EXPECT_EQ(b, 3u);
    std::filesystem::remove(file);
}

TEST(SmoothStep, brep_files_hold_shared_faces_once) {
    const auto file = std::filesystem::temp_directory_path() / "smooth_step_test.brep";
    const auto made = smooth_bodies(grid_model({.thickness = {test::constant(2), test::constant(3)}}));
    write_brep(file, made.bodies);
    TopoDS_Shape read;
    BRep_Builder builder;
    ASSERT_TRUE(BRepTools::Read(read, file.string().c_str(), builder));
    TopTools_IndexedMapOfShape faces, solids;
    TopExp::MapShapes(read, TopAbs_FACE, faces);
    TopExp::MapShapes(read, TopAbs_SOLID, solids);
    EXPECT_EQ(solids.Extent(), 2);
    EXPECT_EQ(faces.Extent(), 11);
    EXPECT_TRUE(BRepCheck_Analyzer(read).IsValid());
    EXPECT_THROW(write_brep(file, {}), InvalidInput);
    std::filesystem::remove(file);
}

TEST(SmoothStep, files_are_small_and_repeatable) {
    const auto file = std::filesystem::temp_directory_path() / "smooth_step_test.step";
    const auto model = grid_model({.thickness = {test::constant(2), test::constant(3)}});
    const auto bytes = [&] {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    };
    write_smooth_step(file, model);
    const auto before = bytes();
    const auto report = write_smooth_step(file, model);
    EXPECT_EQ(bytes(), before);
    EXPECT_EQ(report.solids, 2u);
    EXPECT_EQ(report.faces, 12u);
    EXPECT_LT(std::filesystem::file_size(file), 20'000u * report.faces);
    std::size_t surfaces = 0;
    for (std::size_t at = 0; (at = before.find("B_SPLINE_SURFACE", at)) != std::string::npos; ++at)
        ++surfaces;
    EXPECT_EQ(surfaces, 3u);  // neighbours have the one between them in common
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace stratareeb
