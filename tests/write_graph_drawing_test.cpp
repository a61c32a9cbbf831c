// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_graph_drawing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boreholes/errors.h"
#include "io/side_view.h"
#include "reeb/collapse_plateaus.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

class WriteGraphDrawing : public ::testing::Test {
 protected:
    std::string drawn(const std::string& name, const TriangleSoup& soup,
                      const GraphDrawingOptions& options = {}, bool collapsed = true) const {
        const TriMesh mesh = half_edge_mesh(soup);
        const ScalarField field = height_field(mesh, options.direction.value_or(Point3{0, 0, 1}));
        const ReebGraph fine = reeb_graph(mesh, field);
        const ReebGraph coarse = collapse_plateaus(fine);
        const ReebGraph& graph = collapsed ? coarse : fine;
        const ArcIndex index(mesh, field, fine);
        const ArcMembers members = arc_members(fine, graph);
        write_graph_drawing(folder_ / name, {mesh, field, fine, index, graph, members}, options);
        return content_of(folder_ / name);
    }
    TemporaryFolder folder_;
};

TEST_F(WriteGraphDrawing, writes_svg_pdf_and_png) {
    const TriangleSoup torus = shapes::torus(3, 1, 40, 20);
    const GraphDrawingOptions options{.title = "a torus", .value_label = "x", .direction = {{1, 0, 0}}};
    EXPECT_EQ(drawn("a.svg", torus, options).substr(0, 5), "<?xml");
    EXPECT_EQ(drawn("a.pdf", torus, options).substr(0, 5), "%PDF-");
    EXPECT_EQ(drawn("a.png", torus, options).substr(1, 3), "PNG");
}

TEST_F(WriteGraphDrawing, gives_the_same_bytes_again) {
    const TriangleSoup terrain = shapes::terrain(20);
    EXPECT_EQ(drawn("a.pdf", terrain), drawn("b.pdf", terrain));
    EXPECT_EQ(drawn("a.png", terrain), drawn("b.png", terrain));
}

TEST_F(WriteGraphDrawing, draws_every_shape) {
    for (const auto& shapes : {shapes::solids(), shapes::open_surfaces()})
        for (const auto& [name, soup] : shapes)
            for (const bool collapsed : {false, true}) {
                EXPECT_GT(drawn("s.svg", soup, {.title = name}, collapsed).size(), 1000u) << name;
                GraphDrawingOptions tilted{.direction = {{0.1, 0.7, 1e-6}}};
                EXPECT_GT(drawn("s.svg", soup, tilted, collapsed).size(), 1000u) << name;
                tilted.direction = {};
                EXPECT_GT(drawn("s.svg", soup, tilted, collapsed).size(), 1000u) << name;
            }
}

TEST_F(WriteGraphDrawing, says_when_there_is_nothing_or_too_much_to_see) {
    EXPECT_THROW(drawn("a.svg", {}), InvalidInput);
    EXPECT_THROW(drawn("a.bmp", shapes::cube()), IoError);
    try {
        drawn("a.svg", shapes::terrain(20), {.most_nodes = 3});
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("--simplify"), std::string::npos);
    }
    EXPECT_EQ(folder_.size(), 0u);
}

TEST(SideView, shows_the_broad_side) {
    const TriMesh mesh = half_edge_mesh(shapes::slab(1, 9, 2));
    const SideView view = side_view(mesh, Point3{0, 0, 3});
    EXPECT_NEAR(std::abs(view.right.y), 1, 1e-12);
    EXPECT_NEAR(std::abs(view.toward.x), 1, 1e-12);
    EXPECT_NEAR(view.right_max - view.right_min, 9, 1e-12);
    EXPECT_NEAR(view.toward_max - view.toward_min, 1, 1e-12);
    // Right, height and the direction to the eye are a right-handed frame.
    EXPECT_NEAR(view.right.x * view.toward.y - view.right.y * view.toward.x, -1, 1e-12);
    const SideView along_x = side_view(mesh, Point3{1, 0, 0});
    EXPECT_NEAR(std::abs(along_x.right.y), 1, 1e-12);
    EXPECT_NEAR(std::abs(along_x.toward.z), 1, 1e-12);
}

}  // namespace
}  // namespace stratareeb
