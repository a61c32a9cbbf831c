// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D page (io/write_viewer, io/view_*), unpacked again by a reader of its own, and the command view.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "io/read_model.h"
#include "io/view_order.h"
#include "io/view_payload.h"
#include "io/viewer_template.h"
#include "io/write_viewer.h"
#include "tests/run_program.h"
#include "tests/view_reader.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Far from the origin, so that the model is shifted; the lens of clay pinches out, the last hole ends inside it, one name is hostile.
constexpr const char* kHoles =
    "hole,x,y,ground,</script><script>alert(1)//,Clay \"&<b>,Gravel\n"
    "A,500000,0,10,2,3,1\n"
    "B,500100,0,11,2,0,1\n"
    "C,500100,100,12,2,3,1\n"
    "D,500000,100,10,2,3,1\n"
    "E</script>,500050,40,10,2,3,>1.5\n"
    "F,500080,60,10.5,2,0,\n"
    "G,500030,70,10.5,2,>1,\n";

class WriteViewer : public testing::Test {
 protected:
    WriteViewer() {
        folder_.file("holes.csv", kHoles);
        const auto result = run_program(folder_, "build holes.csv -o model --quiet --refine 1");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    fs::path model() const { return folder_ / "model"; }
    static Payload payload_of(const SavedModel& saved) {
        return Payload(view_payload(saved, {"A title", "report.html", {}}));
    }

    TemporaryFolder folder_;
};

TEST_F(WriteViewer, page_holds_the_model_and_opens_nothing_else) {
    const std::string page = viewer_page(read_model(model()), {.title = "</title><script>alert(2)</script>"});
    const Payload payload(inflated(from_base64(model_text(page))));
    EXPECT_EQ(payload.header["format"], "stratareeb view 1");
    EXPECT_EQ(payload.header["units"][0]["name"], "</script><script>alert(1)//");
    EXPECT_EQ(payload.header["holes"][4]["id"], "E</script>");
    EXPECT_EQ(page.find("<script>alert("),
              page.npos);  // what is in the tables stands in base64, the title is escaped
    EXPECT_NE(page.find("<title>&lt;/title&gt;&lt;script&gt;"), page.npos);
    EXPECT_EQ(page.find("<script src"), page.npos);
    EXPECT_EQ(page.find("<link rel=\"stylesheet\""), page.npos);
    EXPECT_EQ(page.find("@@"), page.npos);
}

TEST_F(WriteViewer, keeps_the_surfaces_before_refinement) {
    const auto before = read_unrefined(model());
    ASSERT_TRUE(before);
    const SavedModel saved = read_model(model());
    EXPECT_EQ(4 * before->plan.surface.n_faces(), saved.model.plan.surface.n_faces());
    EXPECT_EQ(before->origin, saved.model.origin);
    const Payload with(view_payload(saved, {"A title", "", {}, &*before}));
    EXPECT_EQ(with.numbers(with.header["unrefined"]["corner"]).size(), 3 * before->plan.surface.n_faces());
    EXPECT_TRUE(payload_of(saved).header["unrefined"].is_null());
    ASSERT_EQ(run_program(folder_, "build holes.csv -o model --quiet --refine 0 --overwrite").exit_code, 0);
    EXPECT_FALSE(read_unrefined(model()));  // and nothing of it is left
    EXPECT_FALSE(fs::exists(model() / "unrefined"));
}

TEST_F(WriteViewer, horizons_come_back_to_a_step_of_the_grid) {
    const SavedModel saved = read_model(model());
    const LayerModel ordered = in_view_order(saved.model);
    const Payload payload = payload_of(saved);
    const json& surfaces = payload.header["model"];
    const auto x = payload.sums(surfaces["x"]), y = payload.sums(surfaces["y"]);
    auto horizon = payload.sums(surfaces["ground"]);
    const double step = surfaces["step"][0], z_step = surfaces["step"][2];
    const double low_x = surfaces["low"][0], low_y = surfaces["low"][1], low_z = surfaces["low"][2];
    EXPECT_LT(step, 1e-3);
    ASSERT_EQ(x.size(), ordered.plan.surface.n_vertices());
    for (std::size_t k = 0; k <= ordered.units.size(); ++k) {
        std::vector<std::int64_t> thickness(x.size());
        if (k > 0) thickness = payload.sums(surfaces["thickness"][k - 1]);
        for (std::size_t v = 0; v < x.size(); ++v) {
            const auto& p = ordered.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
            EXPECT_NEAR(low_x + static_cast<double>(x[v]) * step, p[0], step);
            EXPECT_NEAR(low_y + static_cast<double>(y[v]) * step, p[1], step);
            horizon[v] -= thickness[v];
            if (k > 0) {
                EXPECT_EQ(thickness[v] == 0, ordered.thickness(k - 1, v) == 0);
            }
            EXPECT_GE(thickness[v], 0);
            EXPECT_NEAR(low_z + static_cast<double>(horizon[v]) * z_step, ordered.horizons[k][v],
                        (0.5 + static_cast<double>(k)) * z_step + 1e-12);
        }
    }
}

TEST_F(WriteViewer, order_of_view_keeps_the_model) {
    const SavedModel saved = read_model(model());
    const LayerModel ordered = in_view_order(saved.model);
    EXPECT_EQ(ordered.plan.surface.n_faces(), saved.model.plan.surface.n_faces());
    EXPECT_EQ(ordered.plan.surface.n_edges(), saved.model.plan.surface.n_edges());
    EXPECT_NEAR(envelope_volume(ordered), envelope_volume(saved.model), 1e-9 * envelope_volume(ordered));
    for (std::size_t h = 0; h < saved.survey.holes.size(); ++h) {
        const auto v = static_cast<int>(ordered.plan.hole_vertex[h]);
        const auto& p = ordered.plan.surface.point(TriMesh::VertexHandle(v));
        EXPECT_EQ(p[0], saved.model.columns.sites[h].x);
        EXPECT_EQ(p[1], saved.model.columns.sites[h].y);
    }
    // Corners of neighbouring triangles are near each other in the numbering.
    const Payload payload = payload_of(saved);
    const auto codes = payload.numbers(payload.header["model"]["corner"]);
    std::uint64_t sum = 0;
    for (const std::uint64_t code : codes) sum += code;
    EXPECT_LT(sum / codes.size(), 4 * std::lround(std::sqrt(ordered.plan.surface.n_vertices())));
}

TEST_F(WriteViewer, straight_surfaces_go_through_the_holes) {
    const SavedModel saved = read_model(model());
    const Payload payload = payload_of(saved);
    const json& straight = payload.header["straight"];
    EXPECT_EQ(straight["vertices"], saved.survey.holes.size());
    const auto corner = payload.corners(straight);
    const auto x = payload.sums(straight["x"]), y = payload.sums(straight["y"]),
               ground = payload.sums(straight["ground"]);
    double area = 0;
    for (std::size_t i = 0; i < corner.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return Point2{static_cast<double>(x[corner[i + k]]), static_cast<double>(y[corner[i + k]])};
        };
        area += ((at(1).x - at(0).x) * (at(2).y - at(0).y) - (at(2).x - at(0).x) * (at(1).y - at(0).y)) / 2;
    }
    const double step = straight["step"][0];
    EXPECT_NEAR(area * step * step, 100.0 * 100.0, 0.1);  // the hull of the holes
    std::multiset<long> elevations;
    for (const std::int64_t q : ground)
        elevations.insert(std::lround(1000 * (straight["low"][2].get<double>() +
                                              static_cast<double>(q) * straight["step"][2].get<double>())));
    EXPECT_EQ(elevations, (std::multiset<long>{10000, 11000, 12000, 10000, 10000, 10500, 10500}));
}

TEST_F(WriteViewer, holes_say_what_they_said) {
    const SavedModel saved = read_model(model());
    const json holes = payload_of(saved).header["holes"];
    ASSERT_EQ(holes.size(), 7u);
    EXPECT_EQ(holes[0]["intervals"], json::parse("[[0,10.0,8.0,1],[1,8.0,5.0,1],[2,5.0,4.0,1]]"));
    EXPECT_EQ(holes[1]["intervals"], json::parse("[[0,11.0,9.0,1],[2,9.0,8.0,1]]"));
    EXPECT_EQ(holes[4]["intervals"][2], json::parse("[2,5.0,3.5,0]"));  // ends inside
    EXPECT_EQ(holes[6]["intervals"].size(), 2u);
    EXPECT_EQ(holes[6]["intervals"][1], json::parse("[1,8.5,7.5,0]"));
    EXPECT_NEAR(holes[1]["x"].get<double>() + saved.model.origin.x, 500100, 1e-4);
}

//! Triangles of a solid along the outline.
std::size_t walls_of(const LayerModel& model, std::size_t layer) {
    std::size_t tops = 0;
    for (const LayerSet& layers : model.regions.in_face) tops += layers[layer];
    return build_layer_solid(model, layer).surface.n_faces() - 2 * tops;
}

double middle_height(const TriMesh& mesh, std::size_t face) {
    std::vector<double> z;
    for (const auto v : mesh.fv_range(TriMesh::FaceHandle(static_cast<int>(face))))
        z.push_back(mesh.point(v)[2]);
    std::sort(z.begin(), z.end());
    return z[1];
}

//! A triangle belongs to the arc of the contour just below its middle corner.
TEST_F(WriteViewer, graphs_name_an_arc_for_every_triangle) {
    const SavedModel saved = read_model(model());
    const LayerModel ordered = in_view_order(saved.model);
    const Payload payload = payload_of(saved);
    const json& graphs = payload.header["graphs"]["layers"];
    ASSERT_EQ(graphs.size(), 3u);
    for (const json& graph : graphs) {
        const LayerSolid solid = build_layer_solid(ordered, graph["layer"]);
        const auto runs = payload.numbers(graph["runs"]);
        std::vector<std::uint64_t> arc_of;
        for (std::size_t i = 0; i < runs.size(); i += 2) arc_of.insert(arc_of.end(), runs[i + 1], runs[i]);
        ASSERT_EQ(arc_of.size(), solid.surface.n_faces());
        const auto value = [&](const json& node) {
            return graph["nodes"][node.get<std::size_t>()]["at"][2].get<double>();
        };
        const std::size_t plan_triangles = (solid.surface.n_faces() - walls_of(ordered, graph["layer"])) / 2;
        for (std::size_t i = 0; i < arc_of.size(); ++i) {
            ASSERT_LE(arc_of[i], graph["arcs"].size());
            if (arc_of[i] == 0 || graph["share"] > 0) continue;
            const std::size_t face = i < plan_triangles       ? 2 * i
                                     : i < 2 * plan_triangles ? 2 * (i - plan_triangles) + 1
                                                              : i;
            const json& arc = graph["arcs"][arc_of[i] - 1];
            const double z = middle_height(solid.surface, face);
            EXPECT_GE(z, value(arc["from"]) - 1e-5);
            EXPECT_LE(z, value(arc["to"]) + 1e-5);
        }
        for (std::size_t i = 0; i < graph["arcs"].size(); ++i) {
            const json& arc = graph["arcs"][i];
            EXPECT_LE(value(arc["from"]), value(arc["to"]));
            EXPECT_GE(arc["curve"].size(), 2u);
        }
        // Nodes less arcs is one less a loop for each piece.
        const std::size_t nodes = graph["nodes"].size(), arcs = graph["arcs"].size(), loops = graph["loops"];
        EXPECT_GE(nodes + loops, arcs + 1);
    }
    const json& layered = payload.header["graphs"]["layered"];
    EXPECT_GT(layered["nodes"].size(), 3u);
    for (const json& arc : layered["arcs"])
        EXPECT_LT(layered["nodes"][arc["from"].get<std::size_t>()]["z"].get<double>(),
                  layered["nodes"][arc["to"].get<std::size_t>()]["z"].get<double>());
}

//! The page numbers walls by the outline's half-edges: by triangle, then by corner. OpenMesh must do so too.
TEST_F(WriteViewer, walls_are_numbered_as_the_page_numbers_them) {
    const LayerModel ordered = in_view_order(read_model(model()).model);
    const TriMesh& plan = ordered.plan.surface;
    std::vector<std::pair<int, int>> by_half_edge, by_corner;
    for (const auto h : plan.halfedges())
        if (!plan.is_boundary(h) && plan.is_boundary(plan.opposite_halfedge_handle(h)))
            by_half_edge.emplace_back(plan.from_vertex_handle(h).idx(), plan.to_vertex_handle(h).idx());
    for (const auto f : plan.faces()) {
        std::vector<int> corner;
        for (const auto v : plan.fv_range(f)) corner.push_back(v.idx());
        for (std::size_t k = 0; k < 3; ++k) {
            const auto h = plan.find_halfedge(TriMesh::VertexHandle(corner[k]),
                                              TriMesh::VertexHandle(corner[(k + 1) % 3]));
            if (plan.is_boundary(plan.opposite_halfedge_handle(h)))
                by_corner.emplace_back(corner[k], corner[(k + 1) % 3]);
        }
    }
    EXPECT_FALSE(by_corner.empty());
    EXPECT_EQ(by_half_edge, by_corner);
}

TEST_F(WriteViewer, same_model_same_bytes) {
    const SavedModel saved = read_model(model());
    EXPECT_EQ(viewer_page(saved, {.title = "t"}), viewer_page(saved, {.title = "t"}));
}

TEST_F(WriteViewer, command_writes_the_page_once) {
    const auto first = run_program(folder_, "view model");
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.out.find("model.html"), first.out.npos);
    const std::string page = content_of(model() / "model.html");
    EXPECT_NE(page.find("<title>model</title>"), page.npos);
    const auto again = run_program(folder_, "view model");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_NE(again.err.find("--overwrite"), again.err.npos);
    EXPECT_NE(content_of(model() / "report.html").find("href=\"model.html\""), page.npos);
    folder_.file("model/report.html", "the user's");
    const auto json_run = run_program(folder_, "view model --overwrite --json --title 'My site'");
    EXPECT_EQ(json_run.exit_code, 0) << json_run.err;
    EXPECT_EQ(json::parse(json_run.out)["bytes"], content_of(model() / "model.html").size());
    const Payload payload(inflated(from_base64(model_text(content_of(model() / "model.html")))));
    EXPECT_EQ(payload.header["report"], "report.html");
    EXPECT_EQ(payload.header["title"], "My site");
    EXPECT_GT(payload.header["units"][0]["volume"].get<double>(), 0);
    EXPECT_EQ(content_of(model() / "report.html"), "the user's");
    fs::remove(model() / "report.html");
    ASSERT_EQ(run_program(folder_, "view model --overwrite --no-report").exit_code, 0);
    ASSERT_EQ(run_program(folder_, "view model -o page.html").exit_code, 0);
    EXPECT_FALSE(fs::exists(model() / "report.html") || fs::exists(folder_.path() / "report.html"));
}

TEST_F(WriteViewer, build_writes_page_and_report) {
    ASSERT_EQ(run_program(folder_, "sample --holes 12 --layers 2 -o wells.csv").exit_code, 0);
    const auto built = run_program(folder_, "build wells.csv -o wells --formats html --refine 0");
    ASSERT_EQ(built.exit_code, 0) << built.err;
    const Payload payload(inflated(from_base64(model_text(content_of(folder_.path() / "wells/model.html")))));
    EXPECT_EQ(payload.header["report"], "report.html");
    EXPECT_NE(content_of(folder_.path() / "wells/report.html").find("<h1>wells</h1>"), std::string::npos);
}

TEST_F(WriteViewer, command_says_what_is_wrong) {
    EXPECT_EQ(run_program(folder_, "view").exit_code, 2);
    const auto missing = run_program(folder_, "view nowhere");
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.err.find("nowhere"), missing.err.npos);
    const auto no_folder = run_program(folder_, "view model -o none/page.html");
    EXPECT_EQ(no_folder.exit_code, 1);
    folder_.file("model/model.json", "{");
    EXPECT_EQ(run_program(folder_, "view model").exit_code, 1);
    EXPECT_FALSE(fs::exists(model() / "model.html"));
}

TEST(ViewerTemplate, is_one_page_with_two_places) {
    const std::string_view page = viewer_template();
    EXPECT_EQ(page.substr(0, 15), "<!doctype html>");
    for (const std::string_view mark : {"@@title@@", "@@model@@"}) {
        ASSERT_NE(page.find(mark), page.npos);
        EXPECT_EQ(page.find(mark), page.rfind(mark));
    }
}

}  // namespace
}  // namespace stratareeb
