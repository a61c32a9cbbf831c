// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_contours.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boreholes/errors.h"
#include "io/write_mesh.h"
#include "reeb/contour_nesting.h"
#include "tests/run_program.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

std::vector<LevelSet> levels_of(const TriangleSoup& soup, const Point3& direction,
                                const std::vector<double>& levels) {
    const TriMesh mesh = half_edge_mesh(soup);
    return level_sets(mesh, height_field(mesh, direction), levels);
}

nlohmann::json stack_of(std::span<const LevelSet> sets,
                        const std::optional<Point3>& direction = Point3{0, 0, 1}) {
    const TemporaryFolder folder;
    write_contours(folder / "stack.json", sets, direction);
    return nlohmann::json::parse(content_of(folder / "stack.json"));
}

TEST(WriteContours, a_stack_of_heights_has_all_points_in_plan_without_loss) {
    const auto sets = levels_of(shapes::torus(3, 1, 20, 12), {0, 0, 1}, {0.3, -0.1, 7});
    const auto json = stack_of(sets);
    EXPECT_FALSE(json.contains("direction"));
    ASSERT_EQ(json["contours"].size(), 4u);
    std::size_t next = 0;
    for (const auto& set : sets)
        for (const auto& contour : set.contours) {
            const auto& written = json["contours"][next++];
            EXPECT_EQ(written["z"].get<double>(), set.level);
            EXPECT_TRUE(written["closed"].get<bool>());
            ASSERT_EQ(written["points"].size(), contour.points.size());
            for (std::size_t i = 0; i < contour.points.size(); ++i)
                EXPECT_EQ(written["points"][i].get<std::vector<double>>(),
                          (std::vector<double>{contour.points[i].x, contour.points[i].y}));
        }
}

TEST(WriteContours, parents_count_through_the_whole_file) {
    const auto sets = levels_of(shapes::torus(3, 1, 20, 12), {0, 0, 1}, {0.3, -0.1});
    const auto json = stack_of(sets)["contours"];
    std::size_t first = 0, holes = 0;
    for (const auto& set : sets) {
        const auto nesting = nest_contours(set);
        for (std::size_t c = 0; c < set.contours.size(); ++c) {
            EXPECT_EQ(json[first + c]["depth"].get<std::uint32_t>(), nesting.depth[c]);
            if (nesting.parent[c] == ContourNesting::kNone) {
                EXPECT_TRUE(json[first + c]["parent"].is_null());
            } else {
                EXPECT_EQ(json[first + c]["parent"].get<std::size_t>(), first + nesting.parent[c]);
                ++holes;
            }
        }
        first += set.contours.size();
    }
    EXPECT_EQ(holes, 2u);
}

TEST(WriteContours, other_directions_are_written_in_space) {
    const Point3 direction{1, 0.5, 0};
    const auto sets = levels_of(shapes::torus(3, 1, 20, 12), direction, {0.3});
    const auto json = stack_of(sets, direction);
    EXPECT_EQ(json["direction"].get<std::vector<double>>(), (std::vector<double>{1, 0.5, 0}));
    ASSERT_EQ(json["contours"].size(), 2u);
    for (const auto& contour : json["contours"]) {
        EXPECT_TRUE(contour["parent"].is_null()) << "two circles side by side";
        for (const auto& point : contour["points"]) {
            ASSERT_EQ(point.size(), 3u);
            EXPECT_NEAR(double(point[0]) + 0.5 * double(point[1]), 0.3, 1e-12);
        }
    }
}

TEST(WriteContours, contours_in_no_plane_have_no_nesting) {
    const TriMesh mesh = half_edge_mesh(shapes::cube());
    const auto sets = level_sets(mesh, distance_field(mesh, {0, 0, 0}), std::array{1.2});
    const auto json = stack_of(sets, std::nullopt);
    EXPECT_FALSE(json.contains("direction"));
    ASSERT_GE(json["contours"].size(), 1u);
    EXPECT_FALSE(json["contours"][0].contains("parent"));
    EXPECT_EQ(json["contours"][0]["points"][0].size(), 3u);
}

TEST(WriteContours, obj_closes_closed_polylines_only) {
    std::vector<LevelSet> sets{
        {.level = 2, .contours = {{.points = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}}}},
        {.level = 3, .contours = {{.points = {{0, 0, 3}, {1, 0, 3}}, .closed = false}}}};
    const TemporaryFolder folder;
    write_contours(folder / "c.obj", sets);
    EXPECT_EQ(content_of(folder / "c.obj"),
              "v 0 0 2\nv 1 0 2\nv 0 1 2\nl 1 2 3 1\nv 0 0 3\nv 1 0 3\nl 4 5\n");
    write_contours(folder / "c.obj", {});
    EXPECT_EQ(content_of(folder / "c.obj"), "");
    EXPECT_TRUE(stack_of({})["contours"].empty());
}

TEST(WriteContours, what_fails_leaves_no_file_and_keeps_the_old_one) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_contours(folder / "c.svg", {}), IoError);
    EXPECT_THROW(write_contours(folder / "no" / "such.json", {}), IoError);
    EXPECT_EQ(folder.size(), 0u);
    folder.file("old.json", "old");
    const auto sets = levels_of(shapes::cube(), {0, 0, 1}, {0.5});
    EXPECT_THROW(write_contours(folder / "old.json", sets, Point3{0, 0, 0}), InvalidInput);
    EXPECT_EQ(content_of(folder / "old.json"), "old");
    EXPECT_EQ(folder.size(), 1u);
}

class LevelsCommand : public ::testing::Test {
 protected:
    LevelsCommand() {
        const TriMesh torus = half_edge_mesh(shapes::torus(3, 1, 120, 60));
        write_mesh(folder_ / "torus.ply", {"torus", "#808080", &torus});
    }

    nlohmann::json level(const std::string& options) const {
        const auto result = run_program(folder_, "levels torus.ply --json " + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(result.out)["levels"][0];
    }

    TemporaryFolder folder_;
};

TEST_F(LevelsCommand, reports_the_area_of_polygons_with_holes_along_any_direction) {
    using std::numbers::pi;
    const auto lying = level("--at 0.02");  // a ring
    EXPECT_EQ(lying["polygons"], 1);
    EXPECT_EQ(lying["holes"], 1);
    EXPECT_NEAR(double(lying["area"]), 12 * pi, 0.1);
    for (const char* across : {"x", "y", "-1,0,0", "0.6,0.8,0"}) {  // two circles of the tube
        const auto level_across = level(std::string("--at 0 --field ") + across);
        EXPECT_EQ(level_across["polygons"], 2) << across;
        EXPECT_EQ(level_across["holes"], 0);
        EXPECT_NEAR(double(level_across["area"]), 2 * pi, 0.02);
        EXPECT_NEAR(double(level_across["length"]), 4 * pi, 0.02);
    }
    const auto text = run_program(folder_, "levels torus.ply --at 0.02");
    EXPECT_NE(text.out.find("2 contours,      2 closed,      1 holes"), std::string::npos) << text.out;
}

TEST_F(LevelsCommand, does_not_nest_what_lies_in_no_plane) {
    const auto around = level("--at 3 --field distance:0,0,0");
    EXPECT_EQ(around["contours"], 2);
    EXPECT_FALSE(around.contains("polygons"));
}

TEST_F(LevelsCommand, writes_contours_across_x_in_space) {
    level("--at 0.01 --field x -o across.json");
    const auto json = nlohmann::json::parse(content_of(folder_ / "across.json"));
    EXPECT_EQ(json["direction"], (std::vector<double>{1, 0, 0}));
    ASSERT_EQ(json["contours"].size(), 2u);
    for (const auto& point : json["contours"][0]["points"]) EXPECT_NEAR(double(point.at(0)), 0.01, 1e-12);
}

}  // namespace
}  // namespace stratareeb
