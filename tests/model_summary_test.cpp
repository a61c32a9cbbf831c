// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a model against closed forms, and checks that fail when a model is spoilt.
#include "mesh/model_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/analysis.h"

namespace stratareeb {
namespace {

constexpr LayerFact kUnknown{};

//! Three by three holes, 10 apart. Sand 2 thick; clay 3 thick, absent in the middle; gravel 1 thick, unknown
//! in one hole; the last hole ends half a unit deep in the gravel.
Survey survey() {
    Survey survey;
    survey.units = {{"S", "Sand", "#aa0000"}, {"C", "Clay", "#00aa00"}, {"G", "Gravel", "#0000aa"}};
    for (int i = 0; i < 9; ++i) {
        Borehole hole;
        hole.at = {10.0 * (i % 3), 10.0 * (i / 3)};
        const double clay = i == 4 ? 0 : 3;
        hole.layers = {{Knowledge::Measured, 2}, {Knowledge::Measured, clay}, {Knowledge::Measured, 1}};
        hole.horizons = {7.0, 5.0, 5.0 - clay, 4.0 - clay};
        survey.holes.push_back(hole);
    }
    survey.holes[2].layers[2] = kUnknown;
    survey.holes[8].layers[2] = {Knowledge::AtLeast, 0.5};
    for (const int h : {2, 8}) survey.holes[h].horizons[3].reset();
    return survey;
}

LayerModel model_of(const Survey& survey, double spacing = 0) {
    return build_layer_model(survey, {.interpolator = InterpolatorKind::Linear, .spacing = spacing});
}

std::vector<UnitSummary> summaries(const LayerModel& model, const Survey& survey) {
    std::vector<UnitSummary> result;
    for (std::size_t i = 0; i < model.units.size(); ++i)
        result.push_back(summarize_unit(model, build_layer_solid(model, i), survey));
    return result;
}

bool passes(const LayerModel& model, const Survey& survey, const std::vector<UnitSummary>& units,
            const std::string& name) {
    const auto checks = check_model(model, survey, units);
    const auto it = std::ranges::find(checks, name, &ModelCheck::name);
    EXPECT_NE(it, checks.end()) << name;
    EXPECT_FALSE(it->detail.empty()) << name;
    return it->ok;
}

TEST(ModelSummary, measures_a_slab) {
    for (const double spacing : {0.0, 3.0}) {
        const LayerModel model = model_of(survey(), spacing);
        const UnitSummary sand = summaries(model, survey())[0];
        EXPECT_NEAR(sand.volume, 800, 1e-9);
        EXPECT_NEAR(sand.area, 2 * 400 + 80 * 2, 1e-9);
        EXPECT_NEAR(sand.plan_area, 400, 1e-9);
        EXPECT_NEAR(sand.mean_thickness, 2, 1e-12);
        EXPECT_NEAR(sand.max_thickness, 2, 1e-12);
        EXPECT_EQ(sand.components, 1u);
        EXPECT_EQ(sand.genus, 0u);
        EXPECT_TRUE(sand.watertight);
        EXPECT_TRUE(sand.problems.empty());
    }
}

TEST(ModelSummary, measures_a_ring) {
    const LayerModel model = model_of(survey());
    const UnitSummary clay = summaries(model, survey())[1];
    EXPECT_EQ(clay.genus, 1u);
    EXPECT_EQ(clay.components, 1u);
    EXPECT_TRUE(clay.watertight);
    EXPECT_EQ(clay.max_thickness, 3);
    EXPECT_NEAR(clay.mean_thickness, clay.volume / clay.plan_area, 1e-12);
    EXPECT_LT(clay.plan_area, 400);
    EXPECT_GT(clay.plan_area, 400 - 200);
    const MeshReport report = analyze(build_layer_solid(model, 1).surface);
    EXPECT_EQ(clay.volume, report.volume);
    EXPECT_EQ(clay.area, report.area);
    EXPECT_EQ(clay.triangles, report.triangles);
}

TEST(ModelSummary, counts_what_holes_say) {
    const auto units = summaries(model_of(survey()), survey());
    EXPECT_EQ(units[1].holes_present, 8u);
    EXPECT_EQ(units[1].holes_absent, 1u);
    EXPECT_EQ(units[1].holes_unknown, 0u);
    EXPECT_EQ(units[2].holes_present, 8u) << "the hole that ends in it included";
    EXPECT_EQ(units[2].holes_at_least, 1u);
    EXPECT_EQ(units[2].holes_unknown, 1u);
    EXPECT_EQ(units[2].holes_absent, 0u);
}

TEST(ModelSummary, of_a_layer_that_is_nowhere_is_all_zeros_and_sound) {
    Survey absent = survey();
    for (Borehole& hole : absent.holes) {
        hole.layers[1] = {Knowledge::Measured, 0};
        hole.horizons = {7.0, 5.0, 5.0, std::nullopt};
    }
    const UnitSummary none = summaries(model_of(absent), absent)[1];
    EXPECT_EQ(none.triangles, 0u);
    EXPECT_EQ(none.volume, 0);
    EXPECT_EQ(none.area, 0);
    EXPECT_EQ(none.plan_area, 0);
    EXPECT_EQ(none.components, 0u);
    EXPECT_TRUE(none.watertight);
    EXPECT_EQ(none.holes_absent, 9u);
}

TEST(ModelMisfit, is_zero_for_a_model_as_built_and_the_distance_for_contacts_that_moved) {
    const LayerModel model = model_of(survey());
    const Misfit exact = misfit_of(model, survey());
    EXPECT_EQ(exact.max, 0);
    EXPECT_EQ(exact.rms, 0);
    EXPECT_EQ(exact.contacts, 9u * 4 - 2);
    Survey moved = survey();
    *moved.holes[0].horizons[1] += 0.75;
    *moved.holes[5].horizons[0] -= 0.25;
    const Misfit off = misfit_of(model, moved);
    EXPECT_DOUBLE_EQ(off.max, 0.75);
    EXPECT_DOUBLE_EQ(off.rms, std::sqrt((0.75 * 0.75 + 0.25 * 0.25) / 34));
}

TEST(ModelMisfit, leaves_out_holes_outside_the_footprint) {
    LayerModelOptions options{.spacing = 2.0};
    options.footprint = Footprint{{{5, 5}, {15, 5}, {15, 15}, {5, 15}}};
    const LayerModel model = build_layer_model(survey(), options);
    EXPECT_EQ(misfit_of(model, survey()).contacts, 4u) << "the hole in the middle";
}

TEST(ModelMisfit, is_in_map_coordinates) {
    Survey high = survey();
    for (Borehole& hole : high.holes) {
        hole.at = {hole.at.x + 5e6, hole.at.y + 5e6};
        for (auto& z : hole.horizons)
            if (z) *z += 30'000;
    }
    const LayerModel model = model_of(high, 2);
    EXPECT_NE(model.origin.z, 0);
    EXPECT_LT(misfit_of(model, high).max, 1e-10);
}

TEST(ModelCheck, all_pass_for_a_model_as_built) {
    for (const double spacing : {0.0, 2.0}) {
        const LayerModel model = model_of(survey(), spacing);
        const auto checks = check_model(model, survey(), summaries(model, survey()));
        EXPECT_EQ(checks.size(), 6u);
        for (const ModelCheck& check : checks) EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
    }
}

TEST(ModelCheck, finds_a_folded_plan) {
    LayerModel model = model_of(survey());
    const auto units = summaries(model, survey());
    model.plan.surface.point(OpenMesh::VertexHandle(static_cast<int>(model.plan.hole_vertex[4]))) = {50, 50,
                                                                                                     0};
    EXPECT_FALSE(passes(model, survey(), units, "plan_unfolded"));
}

TEST(ModelCheck, finds_horizons_that_cross_and_values_that_are_none) {
    for (const double spoilt : {5.5, std::nan("")}) {
        LayerModel model = model_of(survey());
        const auto units = summaries(model, survey());
        model.horizons[2][0] = spoilt;
        EXPECT_FALSE(passes(model, survey(), units, "horizons_ordered")) << spoilt;
    }
}

TEST(ModelCheck, finds_a_solid_that_leaks) {
    const LayerModel model = model_of(survey());
    LayerSolid open = build_layer_solid(model, 0);
    open.surface.delete_face(OpenMesh::FaceHandle(3), false);
    open.surface.garbage_collection();
    auto units = summaries(model, survey());
    units[0] = summarize_unit(model, open, survey());
    EXPECT_FALSE(units[0].watertight);
    EXPECT_FALSE(units[0].problems.empty());
    EXPECT_FALSE(passes(model, survey(), units, "solids_watertight"));
}

TEST(ModelCheck, finds_volumes_that_do_not_add_up) {
    const LayerModel model = model_of(survey());
    auto units = summaries(model, survey());
    units[1].volume *= 1 + 1e-7;
    EXPECT_FALSE(passes(model, survey(), units, "volumes_add_up"));
}

TEST(ModelCheck, finds_contacts_that_are_missed) {
    const LayerModel model = model_of(survey());
    const auto units = summaries(model, survey());
    Survey moved = survey();
    *moved.holes[3].horizons[2] += 1e-6;
    EXPECT_FALSE(passes(model, moved, units, "contacts_honoured"));
    EXPECT_TRUE(passes(model, survey(), units, "contacts_honoured"));
}

TEST(ModelCheck, finds_a_layer_where_a_hole_lacks_it_and_none_where_a_hole_has_it) {
    const LayerModel model = model_of(survey());
    const auto units = summaries(model, survey());
    Survey other = survey();
    other.holes[4].layers[1] = {Knowledge::Measured, 3};
    EXPECT_FALSE(passes(model, other, units, "absence_kept"));
    other = survey();
    other.holes[0].layers[1] = {Knowledge::Measured, 0};
    EXPECT_FALSE(passes(model, other, units, "absence_kept"));
    other.holes[0].layers[1] = kUnknown;
    EXPECT_TRUE(passes(model, other, units, "absence_kept")) << "who knows nothing objects to nothing";
}

}  // namespace
}  // namespace stratareeb
