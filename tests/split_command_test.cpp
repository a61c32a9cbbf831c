// SPDX-License-Identifier: GPL-3.0-or-later
// The command split and what it stands on: mesh/level_cuts, mesh/slabs, mesh/thickness_regions; and mesh/fence_mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "mesh/analysis.h"
#include "mesh/fence_mesh.h"
#include "mesh/horizontal_section.h"
#include "mesh/level_cuts.h"
#include "mesh/slabs.h"
#include "mesh/thickness_regions.h"
#include "tests/grid_model.h"
#include "tests/random_model.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::constant;
using test::grid_model;
using test::random_model;

TEST(ClearLevel, is_the_nearest_that_keeps_the_distance) {
    std::mt19937 random(7);
    for (int round = 0; round < 400; ++round) {
        std::vector<double> values(30);
        for (double& value : values) value = static_cast<double>(random() % 200) / 10;
        std::ranges::sort(values);
        const double level = static_cast<double>(random() % 2000) / 100, clearance = 0.17;
        const double found = clear_level(values, level, clearance);
        for (const double value : values) EXPECT_GE(std::abs(value - found), clearance * (1 - 1e-9));
        double nearest = HUGE_VAL;  // on a fine grid
        for (double z = -5; z < 30; z += 0.001)
            if (std::ranges::all_of(values, [&](double v) { return std::abs(v - z) >= clearance; }))
                nearest = std::min(nearest, std::abs(z - level));
        EXPECT_NEAR(std::abs(found - level), nearest, 0.0011);
    }
}

TEST(LevelCuts, every_horizon_s_line_at_every_level_consists_of_edges) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const SlabCutter cutter(model, even_levels(model, 7));
        std::vector<double> levels;
        for (const double level : cutter.levels()) levels.push_back(level - model.origin.z);
        const LayerModel cut = cut_at_levels(model, levels);
        for (const auto f : cut.plan.surface.faces())
            for (std::size_t k = 0; k < cut.horizons.size(); ++k)
                for (const double level : levels) {
                    bool above = false, below = false;
                    for (const auto v : cut.plan.surface.fv_range(f)) {
                        const double z = cut.horizons[k][static_cast<std::size_t>(v.idx())];
                        above |= z > level;
                        below |= z < level;
                    }
                    ASSERT_FALSE(above && below);
                }
        for (std::size_t k = 0; k < model.horizons.size(); ++k)  // old vertices as they were
            EXPECT_TRUE(std::ranges::equal(model.horizons[k],
                                           std::span(cut.horizons[k]).first(model.horizons[k].size())));
        EXPECT_NEAR(envelope_volume(cut), envelope_volume(model), 1e-12 * envelope_volume(model));
    }
}

TEST(LevelCuts, a_level_through_a_vertex_is_refused) {
    const LayerModel model = grid_model({.cells = 2, .ground = constant(5), .thickness = {constant(5)}});
    EXPECT_THROW(cut_at_levels(model, {5.0}), InvalidInput);
    EXPECT_NO_THROW(cut_at_levels(model, {2.5}));
}

// An upright prism of ground x and base 0 over the square: slabs are prisms with slanted ends.
TEST(Slabs, of_a_wedge_have_their_closed_volumes) {
    const LayerModel wedge = grid_model({.cells = 7,
                                         .ground = [](double x, double) { return x; },
                                         .thickness = {[](double x, double) { return x; }}});
    const SlabCutter cutter(wedge, {13, 50, 77.7});
    const std::array<double, 5> ends{0, 13, 50, 77.7, 100};
    ASSERT_EQ(cutter.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const Slab slab = cutter.slab(i);
        const TriMesh solid = build_layer_solid(slab.model, 0).surface;
        const double low = cutter.levels().empty() || i == 0 ? 0 : cutter.levels()[i - 1];
        const double high = i == 3 ? 100 : cutter.levels()[i];
        EXPECT_NEAR(low, ends[i], 3e-4);
        EXPECT_NEAR(volume(solid), 100 * (high - low) * (100 - (low + high) / 2), 1e-7);
        EXPECT_TRUE(analyze(solid).watertight);
    }
}

TEST(Slabs, level_ground_at_a_level_is_cut_beside_it) {
    const LayerModel model =
        grid_model({.cells = 4, .ground = constant(10), .thickness = {constant(4), constant(6)}});
    const SlabCutter cutter(model, {6});  // the interface itself
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k) {
            const TriMesh solid = build_layer_solid(cutter.slab(i).model, k).surface;
            if (solid.n_faces() == 0) continue;
            EXPECT_TRUE(analyze(solid).watertight);
            sum += volume(solid);
        }
    EXPECT_NEAR(sum, 1e5, 1e-6);
    EXPECT_NEAR(cutter.levels()[0], 6, 3e-5);
}

using Corner = std::array<double, 3>;
//! The triangles of a solid at one height whose normals point up or down, by their corners.
std::set<std::set<Corner>> triangles_at(const TriMesh& solid, double z) {
    std::set<std::set<Corner>> found;
    for (const auto f : solid.faces()) {
        std::set<Corner> corners;
        bool level = true;
        for (const auto v : solid.fv_range(f)) {
            const auto& p = solid.point(v);
            corners.insert({p[0], p[1], p[2]});
            level &= p[2] == z;
        }
        if (level) found.insert(corners);
    }
    return found;
}

TEST(Slabs, of_random_models_are_watertight_conform_and_add_up) {
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const SlabCutter cutter(model, even_levels(model, 2 + seed % 9));
        std::vector<double> volumes(model.units.size(), 0);
        std::map<std::size_t, std::set<std::set<Corner>>> tops;  // of the slab below, by layer
        for (std::size_t i = 0; i < cutter.size(); ++i) {
            const Slab slab = cutter.slab(i);
            std::map<std::size_t, std::set<std::set<Corner>>> next;
            for (std::size_t k = 0; k < model.units.size(); ++k) {
                const TriMesh solid = build_layer_solid(slab.model, k).surface;
                if (solid.n_faces() > 0) {
                    const MeshReport report = analyze(solid);
                    EXPECT_TRUE(report.watertight) << report.problems[0];
                    volumes[k] += report.volume;
                }
                const double z = slab.model.origin.z;
                if (i > 0) {
                    EXPECT_EQ(triangles_at(solid, cutter.levels()[i - 1] - z), tops[k]);
                }
                if (i < cutter.levels().size()) next[k] = triangles_at(solid, cutter.levels()[i] - z);
            }
            tops = std::move(next);
        }
        for (std::size_t k = 0; k < model.units.size(); ++k) {
            const TriMesh solid = build_layer_solid(model, k).surface;
            EXPECT_NEAR(volumes[k], solid.n_faces() > 0 ? volume(solid) : 0, 1e-9 * envelope_volume(model));
        }
    }
}

TEST(Slabs, between_levels_hold_the_integral_of_the_sections) {
    const LayerModel model = random_model(4);
    const auto levels = even_levels(model, 5);
    const SlabCutter cutter(model, {levels[1], levels[2]});
    const Slab slab = cutter.slab(1);
    double sum = 0;
    constexpr int kSteps = 500;
    for (int i = 0; i < kSteps; ++i) {
        const double z = slab.low + (slab.high - slab.low) * (i + 0.5) / kSteps;
        for (const LevelPolygon& polygon : horizontal_section(model, z)) sum += area(polygon);
    }
    sum *= (slab.high - slab.low) / kSteps;
    EXPECT_NEAR(sum, envelope_volume(slab.model), 2e-4 * sum);
}

TEST(Slabs, levels_outside_or_out_of_order_are_refused) {
    const LayerModel model = grid_model({.cells = 2, .ground = constant(0), .thickness = {constant(10)}});
    EXPECT_THROW(SlabCutter(model, {1}), InvalidInput);
    EXPECT_THROW(SlabCutter(model, {-10}), InvalidInput);
    EXPECT_THROW(SlabCutter(model, {-3, -5}), InvalidInput);
    EXPECT_THROW(even_levels(model, 0), InvalidInput);
    EXPECT_EQ(even_levels(model, 4), (std::vector<double>{-7.5, -5, -2.5}));
}

TEST(FenceMesh, panels_have_the_sections_areas_and_share_their_borders) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const VerticalSection section =
            vertical_section(model, PlanLocator(model.plan.surface), {{-5, 20}, {150, 160}, {310, 90}});
        const auto meshes = fence_meshes(section, model.units.size(), model.origin);
        std::vector<double> areas(model.units.size(), 0);
        for (const SectionPolygon& polygon : section_polygons(section)) areas[polygon.layer] += area(polygon);
        std::map<std::set<Corner>, int> uses;
        for (std::size_t k = 0; k < meshes.size(); ++k) {
            if (meshes[k].n_faces() > 0)
                EXPECT_NEAR(area(meshes[k]), areas[k], 1e-9 * envelope_area(section));
            else
                EXPECT_EQ(areas[k], 0);
            for (const auto e : meshes[k].edges()) {
                std::set<Corner> ends;
                for (const unsigned side : {0U, 1U}) {
                    const auto& p =
                        meshes[k].point(meshes[k].to_vertex_handle(meshes[k].halfedge_handle(e, side)));
                    ends.insert({p[0], p[1], p[2]});
                }
                if (meshes[k].is_boundary(e)) ++uses[ends];
            }
        }
        // Edges used once lie on the panel's outline: ground, lowest base, its two ends and those of its runs.
        std::size_t once = 0;
        for (const auto& [ends, count] : uses) {
            EXPECT_LE(count, 2);
            once += count == 1;
        }
        std::size_t spans = 0;
        for (const auto& run : section.runs) spans += run.size() - 1;
        EXPECT_LE(once, 2 * spans + 2 * model.units.size() * section.runs.size());
    }
}

TEST(SplitCommand, writes_slabs_that_read_back_watertight) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(folder, "sample -o t.csv --holes 30 --layers 3 --pinch-outs").exit_code, 0);
    ASSERT_EQ(run_program(folder, "build t.csv -o model --refine 0").exit_code, 0);
    const ProgramResult run = run_program(folder, "split model -o slabs --count 5 --pictures --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const json record = json::parse(run.out);
    EXPECT_EQ(record, json::parse(content_of(folder / "slabs/split.json")));
    ASSERT_EQ(record["slabs"].size(), 5U);
    EXPECT_EQ(record["levels"].size(), 4U);
    double sum = 0;
    for (const json& slab : record["slabs"])
        for (const json& piece : slab["layers"]) {
            const MeshReport report =
                analyze(read_mesh(folder / ("slabs/" + piece["solid"].get<std::string>())));
            EXPECT_TRUE(report.watertight);
            EXPECT_NEAR(report.volume, piece["volume"].get<double>(), 1e-9 * report.volume);
            EXPECT_EQ(piece["reeb"]["loops"].get<std::size_t>(), report.genus.value());
            sum += report.volume;
        }
    const json model = json::parse(content_of(folder / "model/model.json"));
    EXPECT_NEAR(sum, model["envelope_volume"].get<double>(), 1e-9 * sum);
    for (const json& file : record["files"])
        EXPECT_TRUE(fs::exists(folder / ("slabs/" + file.get<std::string>())));

    EXPECT_EQ(run_program(folder, "split model -o slabs").exit_code, 1);
    ASSERT_EQ(run_program(folder, "split model -o slabs --count 2 --overwrite").exit_code, 0);
    EXPECT_FALSE(fs::exists(folder / "slabs/slab_01.png"));
    EXPECT_FALSE(fs::exists(folder / "slabs/slab_05"
                                     "/01_1.ply"));
    EXPECT_EQ(run_program(folder, "split model -o other --at 1e9").exit_code, 1);
    EXPECT_FALSE(fs::exists(folder / "other"));
    EXPECT_EQ(run_program(folder, "split model -o other --at 1,2 --count 3").exit_code, 2);
}

}  // namespace
}  // namespace stratareeb
