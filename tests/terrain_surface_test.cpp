// SPDX-License-Identifier: GPL-3.0-or-later
// Ground from its contours against the ground, and against plain linear interpolation between contours.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <string>

#include "io/read_contour_stack.h"
#include "io/read_raster.h"
#include "mesh/analysis.h"
#include "reeb/graph_of_stack.h"
#include "reeb/level_set.h"
#include "reeb/surface_construction.h"
#include "reeb/terrain_stack.h"
#include "tests/terrain_error.h"

namespace stratareeb {
namespace {

using namespace testing;

struct Comparison {
    HeightErrors surface, linear;
    std::size_t crossings = 0;
};

Comparison compare(const ContourStack& stack, const HeightGrid& truth) {
    const StackGraph graph = graph_of_stack(stack);
    EXPECT_TRUE(is_terrain(graph.graph));
    EXPECT_TRUE(graph.dropped.empty());
    const auto surface = construct_surface(graph.graph, {.terrain = true});
    const auto depth = ring_depths(stack, truth);
    const MeshReport report = analyze(surface.soup);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.self_intersections, 0u);
    return {errors_of(heights_of(surface.soup, truth), truth, depth),
            errors_of(heights_of(contour_tin(stack), truth), truth, depth), surface.crossings.size()};
}

void expect_better(const Comparison& found, double share) {
    EXPECT_EQ(found.crossings, 0u);
    EXPECT_GT(found.surface.places, 1000u);
    EXPECT_LT(found.surface.mean, share * found.linear.mean);
    EXPECT_LT(found.surface.rms, share * found.linear.rms);
    EXPECT_LT(found.surface.most_of_95_percent, share * found.linear.most_of_95_percent);
    std::printf("%zu places: mean %.2f (linear %.2f), rms %.2f (%.2f), 95 %% %.2f (%.2f), most %.2f (%.2f)\n",
                found.surface.places, found.surface.mean, found.linear.mean, found.surface.rms,
                found.linear.rms, found.surface.most_of_95_percent, found.linear.most_of_95_percent,
                found.surface.most, found.linear.most);
}

void add(HeightErrors& sum, const HeightErrors& part) {
    sum.places += part.places;
    sum.mean += part.mean;
    sum.rms += part.rms;
    sum.most_of_95_percent += part.most_of_95_percent;
    sum.most += part.most;
}

//! Hills and hollows over a square, sinking to its sides.
HeightGrid hills(std::uint64_t seed, std::size_t size) {
    std::mt19937_64 random(seed);
    const auto unit = [&] { return static_cast<double>(random() % 100'000) / 100'000; };
    struct Hill {
        double x, y, width, height;
    };
    std::vector<Hill> all{{0.5, 0.5, 0.3, 400}};
    for (int k = 0; k < 12; ++k)
        all.push_back({0.2 + 0.6 * unit(), 0.2 + 0.6 * unit(), 0.04 + 0.08 * unit(), 300 * unit() - 110});
    HeightGrid grid{.low = {0, 0},
                    .step = 4000.0 / static_cast<double>(size - 1),
                    .columns = size,
                    .rows = size,
                    .heights = {}};
    grid.heights.assign(size * size, 0);
    for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = 0; c < size; ++c) {
            const double x = grid.place(c, r).x / 4000, y = grid.place(c, r).y / 4000;
            for (const Hill& h : all)
                grid.at(c, r) += h.height * std::exp(-((x - h.x) * (x - h.x) + (y - h.y) * (y - h.y)) /
                                                     (2 * h.width * h.width));
        }
    return grid;
}

TriMesh mesh_of(const HeightGrid& grid) {
    TriangleSoup soup;
    for (std::uint32_t r = 0; r < grid.rows; ++r)
        for (std::uint32_t c = 0; c < grid.columns; ++c) {
            const Point2 p = grid.place(c, r);
            soup.points.push_back({p.x, p.y, grid.heights[r * grid.columns + c]});
            if (r == 0 || c == 0) continue;
            const auto v = static_cast<std::uint32_t>(r * grid.columns + c),
                       n = static_cast<std::uint32_t>(grid.columns);
            soup.triangles.push_back({v - n - 1, v - n, v});
            soup.triangles.push_back({v - n - 1, v, v - 1});
        }
    return half_edge_mesh(soup);
}

TEST(TerrainSurface, of_hills_is_closer_to_them_than_linear_interpolation) {
    Comparison all;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        SCOPED_TRACE(seed);
        const HeightGrid truth = hills(seed, 81);
        const TriMesh mesh = mesh_of(truth);
        std::vector<double> levels;
        for (double z = 120.3; z < 900; z += 25) levels.push_back(z);
        ContourStack stack;
        for (const LevelSet& set : level_sets(mesh, height_field(mesh), levels))
            for (const Contour& contour : set.contours) {
                ASSERT_TRUE(contour.closed);
                stack.contours.push_back({.z = set.level, .points = {}, .name = {}});
                for (const Point3& p : contour.points) stack.contours.back().points.push_back({p.x, p.y});
            }
        const Comparison own = compare(stack, truth);
        EXPECT_LT(own.surface.mean, 0.75 * own.linear.mean);
        add(all.surface, own.surface);
        add(all.linear, own.linear);
        all.crossings += own.crossings;
    }
    expect_better(all, 0.75);
}

HeightGrid st_helens() {
    const Raster raster = read_raster(STRATAREEB_SOURCE_DIR "/../shared/data/terrain/st_helens_30m.asc");
    const auto columns = static_cast<std::size_t>(raster.columns),
               rows = static_cast<std::size_t>(raster.rows);
    HeightGrid grid{.low = {raster.low().x + 15, raster.low().y + 15},
                    .step = 30,
                    .columns = columns,
                    .rows = rows,
                    .heights = {}};
    grid.heights.resize(columns * rows);
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) grid.at(c, rows - 1 - r) = raster.heights[r * columns + c];
    return grid;
}

TEST(TerrainSurface, of_mount_st_helens_is_closer_to_it_than_linear_interpolation) {
    const std::string shared = STRATAREEB_SOURCE_DIR "/../shared/data/";
    if (!std::filesystem::exists(shared + "terrain/st_helens_30m.asc")) GTEST_SKIP() << "no shared data";
    const HeightGrid truth = st_helens();
    const std::string all = shared + "contours_st_helens/ring_points.csv",
                      large = STRATAREEB_SOURCE_DIR "/examples/st_helens/contours.json";
    for (const std::string& file : {all, large}) {
        SCOPED_TRACE(file);
        expect_better(compare(read_contour_stack(file), truth), 0.95);
    }
}

}  // namespace
}  // namespace stratareeb
