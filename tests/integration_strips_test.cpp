// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/integration_strips.h"

#include <gtest/gtest.h>

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "io/cad_body.h"
#include "io/smooth_shapes.h"
#include "subdivision/cad_integration.h"
#include "subdivision/cell_integrals.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

// Thin layers over waves that need many spans.
SmoothBrep wavy_layers(double wave) {
    const auto model = test::grid_model(
        {.cells = 30,
         .ground = [=](double x, double y) { return 3 * std::sin(x / wave) * std::cos(y / (1.3 * wave)); },
         .thickness = {test::constant(0.1), test::constant(3)}});
    return build_smooth_brep(model, {.sheets = {.most_functions = 3000}});
}

// Of the volumes that OpenCASCADE finds from those between the sheets.
double worst_off(const SmoothBrep& brep) {
    const auto shapes = smooth_shapes(brep);
    double worst = 0;
    for (std::size_t b = 0; b < shapes.size(); ++b)
        worst = std::max(worst, std::abs(cad_volume(*shapes[b]) / brep.quality[b].volume - 1));
    return worst;
}

TEST(IntegrationStrips, are_not_cut_where_volumes_are_right) {
    SmoothBrep brep = wavy_layers(40);
    ASSERT_LT(worst_off(brep), 1e-3);
    const std::size_t whole = brep.cells.cells.size();
    cut_for_integration(brep, 1e-3, 1);
    EXPECT_EQ(brep.cells.cells.size(), whole);
}

TEST(IntegrationStrips, make_the_volumes_right_that_a_cad_program_finds) {
    SmoothBrep brep = wavy_layers(4);
    ASSERT_GT(worst_off(brep), 5e-3) << "nothing to mend";
    const std::size_t whole = brep.cells.cells.size();
    cut_for_integration(brep, 5e-4, 1);
    EXPECT_LT(worst_off(brep), 1e-3);
    EXPECT_GT(brep.cells.cells.size(), whole);
    EXPECT_LT(brep.cells.cells.size(), whole + 30);
}

// Faces are not cut for what edges of many spans do: these become several.
TEST(IntegrationStrips, begin_with_edges) {
    SmoothBrep brep = build_smooth_brep(
        test::grid_model({.cells = 60,
                          .ground = [](double, double y) { return 12 * std::sin(y / 2); },
                          .thickness = {[](double, double y) { return 0.5 + 0.3 * std::sin(y / 2.5); },
                                        test::constant(3)}}),
        {.sheets = {.most_functions = 6000}});
    ASSERT_GT(worst_off(brep), 1e-3) << "nothing to mend";
    SmoothBrep of_short_edges = brep;
    for (auto& edge : of_short_edges.edges) edge.cad_spans = 4;
    cut_for_integration(of_short_edges, 5e-4, 1);
    cut_for_integration(brep, 5e-4, 1);
    EXPECT_LT(worst_off(brep), 5.5e-4);
    EXPECT_LE(brep.cells.cells.size(), of_short_edges.cells.cells.size());
    const auto is_several = [](const auto& edge) { return cad_edge_ends(edge).size() > 2; };
    EXPECT_TRUE(std::ranges::any_of(brep.edges, is_several));
}

// What a program will add to a volume by mistake is foretold, face by face.
TEST(IntegrationStrips, errors_are_those_of_opencascade) {
    const SmoothBrep brep = wavy_layers(4);
    const auto shapes = smooth_shapes(brep);
    const auto& body = brep.cells.bodies[0];
    for (const double x : {0.0, 40.0, 300.0}) {
        const gp_Pnt from(x, 20, -5);
        TopExp_Explorer face(*shapes[0], TopAbs_FACE);
        for (const auto c : body.top) {
            BRepGProp_Face surface;
            surface.Load(TopoDS::Face(face.Current()));
            BRepGProp_Domain outline(TopoDS::Face(face.Current()));
            const double cone = BRepGProp_Vinert(surface, outline, from).Mass();
            const double exact = integrate_cell(brep, c, {x, 20, -5}).from_point.cone;
            ASSERT_GT(std::abs(cone - exact), 0.5) << x;
            EXPECT_NEAR(integration_error(brep, c, {x, 20, -5}).all().cone / (cone - exact), 1, 0.01) << x;
            face.Next();
        }
    }
}

// Walls have their edges in common with top and base. Of few spans they are right.
TEST(IntegrationStrips, errors_along_walls_are_those_of_opencascade) {
    const SmoothBrep brep = wavy_layers(4);
    SmoothBrep fine = brep;
    for (auto& edge : fine.edges) edge.cad_spans = 3;
    const auto& body = brep.cells.bodies[1];
    const Point3 from{30, 20, -5};
    const auto cones = [&](const SmoothBrep& of) {
        std::vector<double> result;
        const auto shapes = smooth_shapes(of);
        TopExp_Explorer face(*shapes[1], TopAbs_FACE);
        for (std::size_t i = 0; i < body.top.size() + body.base.size(); ++i) face.Next();
        for (; face.More(); face.Next()) {
            BRepGProp_Face surface;
            surface.Load(TopoDS::Face(face.Current()));
            BRepGProp_Domain outline(TopoDS::Face(face.Current()));
            result.push_back(BRepGProp_Vinert(surface, outline, {from.x, from.y, from.z}).Mass());
        }
        return result;
    };
    const auto found = cones(brep), right = cones(fine);
    ASSERT_EQ(found.size(), body.walls.size());
    double largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto along = wall_integration_error(brep, body.walls[i], from);
        ConeIntegral sum;
        for (const auto& edge : along) sum.add(edge);
        const double foretold = sum.cone;
        EXPECT_NEAR(foretold, found[i] - right[i], 0.01 * std::abs(foretold) + 1e-3) << i;
        largest = std::max(largest, std::abs(foretold));
    }
    EXPECT_GT(largest, 1);
}

// Two solids as one, without what is between them.
TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    TopTools_IndexedMapOfShape in_a, in_b;
    TopExp::MapShapes(a, TopAbs_FACE, in_a);
    TopExp::MapShapes(b, TopAbs_FACE, in_b);
    TopoDS_Compound whole;
    BRep_Builder builder;
    builder.MakeCompound(whole);
    for (TopExp_Explorer face(a, TopAbs_FACE); face.More(); face.Next())
        if (!in_b.Contains(face.Current())) builder.Add(whole, face.Current());
    for (TopExp_Explorer face(b, TopAbs_FACE); face.More(); face.Next())
        if (!in_a.Contains(face.Current())) builder.Add(whole, face.Current());
    return whole;
}

// A lens is measured from its own middle; joined with what it lies on, from another one.
TEST(IntegrationStrips, volumes_add_up_where_neighbours_are_joined) {
    const SmoothBrep whole = build_smooth_brep(
        test::grid_model(
            {.cells = 80,
             .ground = [](double x, double y) { return 3 * std::sin(x / 60) * std::cos(y / 2.5); },
             .thickness = {[](double x, double y) {
                               return std::max(0.0, 4 - std::hypot(x - 30, y - 30) * 4 / 25);
                           },
                           test::constant(3)},
             .rounds = {{30, 30, 25}}}),
        {.sheets = {.end_gap = 1e-6, .most_functions = 9000}});
    const auto off = [&](double joined_share) {
        SmoothBrep brep = whole;
        cut_for_integration(brep, 2e-3, joined_share);
        const auto shapes = smooth_shapes(brep);
        const double sum = cad_volume(*shapes[0]) + cad_volume(*shapes[1]);
        return std::abs(cad_volume(joined(*shapes[0], *shapes[1])) / sum - 1);
    };
    ASSERT_GT(off(1), 3e-4) << "nothing to mend";
    EXPECT_LT(off(1e-4), 5e-5);
}

// From wherever.
TEST(IntegrationStrips, errors_change_with_the_point_as_those_of_normals_say) {
    const SmoothBrep brep = wavy_layers(4);
    const Point3 from{30, 20, -5}, by{-70, 11, 4}, there{from.x + by.x, from.y + by.y, from.z + by.z};
    const auto expect_growth = [&](const ConeIntegral& here, const ConeIntegral& away) {
        EXPECT_NEAR(away.cone, here.cone + here.growth(by), 1e-6 * (std::abs(here.growth(by)) + 1e-3));
    };
    for (std::uint32_t c = 0; c < brep.cells.cells.size(); ++c)
        expect_growth(integration_error(brep, c, from).all(), integration_error(brep, c, there).all());
    for (const auto& wall : brep.cells.bodies[0].walls) {
        const auto here = wall_integration_error(brep, wall, from),
                   away = wall_integration_error(brep, wall, there);
        for (std::size_t k = 0; k < here.size(); ++k) expect_growth(here[k], away[k]);
    }
}

// Edges of few spans leave what comes from across a face.
TEST(IntegrationStrips, tell_edges_from_faces) {
    SmoothBrep brep = wavy_layers(4);
    const Point3 from{10, 20, -5};
    const auto before = integration_error(brep, 0, from);
    for (auto& edge : brep.edges) edge.cad_spans = 4;
    const auto after = integration_error(brep, 0, from);
    ASSERT_EQ(after.along.size(), before.along.size());
    for (const auto& edge : after.along) {
        EXPECT_EQ(edge.cone, 0);
        EXPECT_EQ(edge.normal, Point3{});
    }
    EXPECT_GT(std::abs(before.all().cone - before.across.cone), std::abs(before.across.cone) / 100);
    EXPECT_NEAR(after.across.cone, before.across.cone, 0.02 * std::abs(before.across.cone));
}

}  // namespace
}  // namespace stratareeb
