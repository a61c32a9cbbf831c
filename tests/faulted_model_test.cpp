// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/faulted_model.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "boreholes/errors.h"
#include "boreholes/hold_out.h"
#include "boreholes/random_survey.h"
#include "io/read_faults.h"
#include "mesh/analysis.h"
#include "mesh/layer_volumes.h"
#include "mesh/model_summary.h"
#include "mesh/plan_locator.h"
#include "mesh/slabs.h"
#include "mesh/vertical_section.h"
#include "subdivision/refined_layers.h"
#include "tests/model_soundness.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

constexpr double kExtent = 300;
const Footprint kSquare{{{0, 0}, {kExtent, 0}, {kExtent, kExtent}, {0, kExtent}}};

using Triangle = std::array<std::array<double, 3>, 3>;

std::multiset<Triangle> triangles_of(const TriMesh& mesh) {
    std::multiset<Triangle> result;
    for (const auto f : mesh.faces()) {
        Triangle t;
        int k = 0;
        for (const auto v : mesh.fv_range(f)) t[k++] = {mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]};
        std::sort(t.begin(), t.end());
        result.insert(t);
    }
    return result;
}

double area_of(const Triangle& t) {
    TriMesh::Point p[3];
    for (int k = 0; k < 3; ++k) p[k] = {t[k][0], t[k][1], t[k][2]};
    return ((p[1] - p[0]) % (p[2] - p[0])).norm() / 2;
}

//! Each block's solid is closed and sound; every triangle is that of one or two solids; those of one alone are the outside:
//! ground, lowest horizon, footprint walls, and fault walls beside nothing. Volumes add up to the envelope.
void expect_sound_blocks(const LayerModel& model, const Survey& survey) {
    const FaultSeams again = seams_of_pieces(model.plan.surface, model.horizons);  // as from a file
    EXPECT_EQ(again.blocks, model.seams.blocks);
    EXPECT_EQ(again.block, model.seams.block);
    EXPECT_EQ(again.levels, model.seams.levels);
    EXPECT_EQ(again.across, model.seams.across);
    std::map<Triangle, int> uses;
    double sum = 0;
    std::vector<UnitSummary> units;
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        const auto solids = build_block_solids(model, i);
        for (const LayerSolid& solid : solids) {
            testing::expect_watertight(solid.surface,
                                       solid.unit.code + " in block " + std::to_string(solid.block));
            sum += volume(solid.surface);
            for (const Triangle& t : triangles_of(solid.surface)) ++uses[t];
        }
        units.push_back(summarize_unit(model, i, solids, survey));
    }
    EXPECT_NEAR(sum, envelope_volume(model), 1e-9 * sum);
    for (const auto& [t, n] : uses) ASSERT_LE(n, 2);
    for (const ModelCheck& check : check_model(model, survey, units))
        EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
}

//! The area of fault walls that two solids share.
double shared_wall(const LayerModel& model) {
    std::map<Triangle, int> uses;
    for (std::size_t i = 0; i < model.units.size(); ++i)
        for (const LayerSolid& solid : build_block_solids(model, i))
            for (const auto f : solid.surface.faces()) {
                if (solid.surface.calc_face_normal(f)[2] != 0) continue;
                Triangle t;
                int k = 0;
                for (const auto v : solid.surface.fv_range(f))
                    t[k++] = {solid.surface.point(v)[0], solid.surface.point(v)[1],
                              solid.surface.point(v)[2]};
                std::sort(t.begin(), t.end());
                ++uses[t];
            }
    double area = 0;
    for (const auto& [t, n] : uses)
        if (n == 2) area += area_of(t);
    return area;
}

//! Level layers of 10, 20 and 15, the west block `throw_m` above the east one.
Survey two_blocks(double throw_m, double dip = 0, std::uint64_t seed = 3) {
    Survey survey;
    for (const char* code : {"a", "b", "c"}) survey.units.push_back({code, code, ""});
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> at(0, kExtent);
    for (int h = 0; h < 40; ++h) {
        const Point2 p{at(random), at(random)};
        const double ground = (p.x < 150 ? throw_m : 0.0) + 100 + dip * p.y * (p.x < 150 ? 1 : -1);
        survey.holes.push_back(
            {"h" + std::to_string(h),
             p,
             {{Knowledge::Measured, 10}, {Knowledge::Measured, 20}, {Knowledge::Measured, 15}},
             {ground, ground - 10, ground - 30, ground - 45},
             0});
    }
    return survey;
}

const FaultTraces kMiddle{{{150, -10}, {150, 310}}};

LayerModelOptions square_options() {
    return {.interpolator = InterpolatorKind::Linear, .footprint = kSquare, .spacing = 30};
}

TEST(FaultedModel, two_blocks_with_a_known_throw_come_back_with_it) {
    const Survey survey = two_blocks(12);
    const LayerModel model = build_faulted_model(survey, kMiddle, square_options());
    ASSERT_EQ(model.seams.blocks, 2u);
    expect_sound_blocks(model, survey);
    ASSERT_FALSE(model.seams.across.empty());
    for (const auto& [edge, other] : model.seams.across)
        for (std::size_t k = 0; k < 4; ++k) {
            const double here = model.horizons[k][edge.first], there = model.horizons[k][other[0]];
            EXPECT_NEAR(std::abs(here - there), 12, 1e-9);
        }
    const double area = kExtent * kExtent;
    EXPECT_NEAR(layer_volumes(model)[0], 10 * area, 1e-6);
    EXPECT_NEAR(layer_volumes(model)[1], 20 * area, 1e-6);
    EXPECT_NEAR(envelope_volume(model), 45 * area, 1e-6);
    EXPECT_NEAR(shared_wall(model), (45 - 12) * kExtent, 1e-6) << "what is beside rock on both sides";
}

TEST(FaultedModel, horizons_that_cross_along_the_fault_meet_in_vertices) {
    const Survey survey = two_blocks(-9, 0.06);  // the throw turns over half way: a scissor fault
    for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::NaturalNeighbour}) {
        LayerModelOptions options = square_options();
        options.interpolator = kind;
        expect_sound_blocks(build_faulted_model(survey, kMiddle, options), survey);
    }
}

TEST(FaultedModel, a_section_jumps_at_the_fault) {
    const LayerModel model = build_faulted_model(two_blocks(12), kMiddle, square_options());
    const PlanLocator locator(model.plan.surface);
    for (const auto& line :
         {std::vector<Point2>{{10, 30}, {290, 30}}, {{290, 41.7}, {10, 233.3}}, {{150.5, 0}, {149.5, 300}}}) {
        const VerticalSection section = vertical_section(model, locator, line);
        ASSERT_EQ(section.runs.size(), 2u);
        EXPECT_EQ(section.runs[0].back().along, section.runs[1].front().along);
        EXPECT_NEAR(section.runs[0].back().at.x, 150, 1e-9);
        EXPECT_NEAR(std::abs(section.runs[0].back().horizons[1] - section.runs[1].front().horizons[1]), 12,
                    1e-9);
        EXPECT_NEAR(envelope_area(section), 45 * section.corners.back(), 1e-6);
    }
}

TEST(FaultedModel, a_fault_without_throw_shares_its_whole_wall) {
    const Survey survey = two_blocks(0);
    const LayerModel model = build_faulted_model(survey, kMiddle, square_options());
    expect_sound_blocks(model, survey);
    EXPECT_NEAR(shared_wall(model), 45 * kExtent, 1e-6);
}

TEST(FaultedModel, a_throw_of_a_layers_thickness_or_beyond_all_layers_is_sound) {
    for (const double throw_m : {10.0, 30.0, 45.0, 60.0}) {
        SCOPED_TRACE(throw_m);
        const Survey survey = two_blocks(throw_m);
        const LayerModel model = build_faulted_model(survey, kMiddle, square_options());
        expect_sound_blocks(model, survey);
        EXPECT_NEAR(shared_wall(model), std::max(0.0, 45 - throw_m) * kExtent, 1e-6);
    }
}

TEST(FaultedModel, blocks_are_refined_one_by_one) {
    const Survey survey = two_blocks(-9, 0.06);
    LayerModelOptions options{.footprint = kSquare, .spacing_factor = 2, .ring_holes = true};
    const LayerModel model =
        build_faulted_model(survey, {{{150, -10}, {170, 150}}, {{170, 150}, {120, 310}}}, options,
                            [](LayerModel block) { return refine_layers(block, {.levels = 1}).model; });
    ASSERT_EQ(model.seams.blocks, 2u);
    expect_sound_blocks(model, survey);
}

TEST(FaultedModel, faults_may_meet_in_t_y_and_x) {
    const Survey survey = random_survey({.holes = 60, .layers = 4, .seed = 5, .pinch_outs = true});
    const FaultTraces t{{{150, -10}, {152, 310}}, {{151, 140}, {310, 130}}},
        y{{{150, 150}, {10, -10}}, {{150, 150}, {320, 20}}, {{150, 150}, {140, 320}}},
        x{{{-10, 100}, {310, 180}}, {{100, -10}, {190, 310}}};
    for (const auto& [traces, blocks] : {std::pair(t, 3u), std::pair(y, 3u), std::pair(x, 4u)}) {
        LayerModelOptions options{.spacing = 30};
        const LayerModel model = build_faulted_model(survey, traces, options);
        EXPECT_EQ(model.seams.blocks, blocks);
        expect_sound_blocks(model, survey);
    }
}

TEST(FaultedModel, a_trace_that_ends_just_short_is_led_on_and_one_beyond_a_crossing_cut) {
    const std::vector<Point2> holes{{50, 50}, {250, 50}, {50, 250}, {250, 250}, {20, 150}};
    const FaultBlocks led_on = fault_blocks(kSquare, {{{150, 4}, {150, 297}}}, holes);
    EXPECT_EQ(led_on.outline.size(), 2u);
    EXPECT_TRUE(led_on.ways_on.empty());
    EXPECT_TRUE(led_on.ties.empty());
    ASSERT_EQ(led_on.notes.size(), 2u);
    EXPECT_NE(led_on.notes[0].find("ends at x 150, y 4, just short of x 150, y 0; it is led on to there"),
              std::string::npos);
    const FaultBlocks cut = fault_blocks(kSquare, {{{150, -5}, {150, 305}}, {{310, 150}, {148, 150}}}, holes);
    EXPECT_EQ(cut.outline.size(), 3u);
    EXPECT_TRUE(cut.notes.empty());
    double sum = 0;
    for (const auto& outline : cut.outline) sum += area(outline);
    EXPECT_NEAR(sum, kExtent * kExtent, 1e-9);
}

TEST(FaultedModel, a_trace_that_ends_inside_dies_out_there) {
    const std::vector<Point2> holes{{50, 50}, {250, 50}, {50, 250}, {250, 250}, {20, 150}};
    const FaultBlocks blocks = fault_blocks(kSquare, {{{150, 100}, {150, 310}}}, holes);
    EXPECT_EQ(blocks.outline.size(), 2u);
    ASSERT_EQ(blocks.notes.size(), 1u);
    EXPECT_EQ(blocks.notes[0], "fault trace 1 ends inside at x 150, y 100; its throw dies out there");
    ASSERT_EQ(blocks.ways_on.size(), 1u);
    EXPECT_EQ(blocks.ways_on[0].tip, (Point2{150, 100}));
    EXPECT_NEAR(blocks.ways_on[0].end.y, 0, 1e-4);
    ASSERT_FALSE(blocks.ties.empty());
    for (const BlockTie& tie : blocks.ties) {
        EXPECT_LT(tie.at.y, 100) << "beyond the tip";
        EXPECT_NE(tie.at.x, 150) << "to a side of the way on";
        EXPECT_EQ(tie.to.size(), 2u);
        EXPECT_EQ(std::vector(tie.to.begin(), tie.to.end()), tie.from);
    }
    // A hole in the way: the way on goes past it.
    const FaultBlocks turned =
        fault_blocks(kSquare, {{{150, 100}, {150, 310}}}, {{150, 40}, {50, 50}, {250, 50}});
    EXPECT_EQ(turned.outline.size(), 2u);
    EXPECT_GT(std::abs(turned.ways_on[0].end.x - 150), 0.3);
}

//! Holes in rows beside a fault at x = 150 whose throw grows from 0 at y = 120 to 18 at y = 300.
Survey dying_out() {
    Survey survey;
    for (const char* code : {"a", "b", "c"}) survey.units.push_back({code, code, ""});
    for (const double x : {10.0, 50.0, 90.0, 130.0, 170.0, 210.0, 250.0, 290.0})
        for (double y = 0; y <= 300; y += 20) {
            const double throw_m = x < 150 ? std::max(0.0, 0.1 * (y - 120)) : 0;
            const double ground = 100 + throw_m;
            survey.holes.push_back(
                {"h" + std::to_string(survey.holes.size()),
                 {x, y},
                 {{Knowledge::Measured, 10}, {Knowledge::Measured, 20}, {Knowledge::Measured, 15}},
                 {ground, ground - 10, ground - 30, ground - 45},
                 0});
        }
    return survey;
}

const FaultTraces kDying{{{150, 120}, {150, 310}}};

TEST(FaultedModel, a_throw_that_dies_out_comes_back_and_the_plan_is_cut_along_the_trace_alone) {
    const Survey survey = dying_out();
    for (const auto kind : {InterpolatorKind::Linear, InterpolatorKind::Kriging}) {
        SCOPED_TRACE(name_of(kind));
        LayerModelOptions options = square_options();
        options.interpolator = kind;
        const LayerModel model = build_faulted_model(survey, kDying, options);
        expect_sound_blocks(model, survey);
        EXPECT_EQ(model.seams.blocks, 1u) << "one piece, with a slit";
        double slit = 0;
        for (const auto& [edge, other] : model.seams.across) {
            const auto at = [&](std::uint32_t v) {
                return model.plan.surface.point(TriMesh::VertexHandle(static_cast<int>(v)));
            };
            for (const std::uint32_t v : {edge.first, edge.second}) {
                EXPECT_EQ(at(v)[0], 150);
                EXPECT_GE(at(v)[1], 120);
            }
            slit += (at(edge.second) - at(edge.first)).norm();
            for (std::size_t k = 0; k < 4; ++k) {
                const double y = at(edge.first)[1];
                EXPECT_NEAR(std::abs(model.horizons[k][edge.first] - model.horizons[k][other[0]]),
                            0.1 * (y - 120), kind == InterpolatorKind::Linear ? 1.0 : 0.4)
                    << "y " << y;
            }
        }
        EXPECT_NEAR(slit, 2 * 180, 1e-9) << "both sides of the trace";
        for (std::size_t i = 0; i < 3; ++i) {
            const auto solids = build_block_solids(model, i);
            ASSERT_EQ(solids.size(), 1u) << "one body around the tip";
            EXPECT_EQ(analyze(solids[0].surface).components, 1u);
        }
    }
}

TEST(FaultedModel, held_out_holes_are_predicted_across_the_way_on_and_not_across_the_trace) {
    const Survey survey = dying_out();
    const FaultBlocks blocks = fault_blocks_of(survey, kDying);
    const auto draws = fold_draws(survey.holes.size(), 10, 1);
    const auto rmse = [&](bool by_block, bool tied) {
        HoldOutOptions options;
        options.prediction.interpolator = InterpolatorKind::Kriging;
        if (by_block) options.block = blocks.block_of;
        if (tied) options.ties = blocks.ties;
        double sum = 0;
        const auto residuals = elevation_residuals(survey, hold_out(survey, draws, options), 0);
        for (const Residual& residual : residuals) sum += residual.error() * residual.error();
        return std::sqrt(sum / static_cast<double>(residuals.size()));
    };
    EXPECT_LT(rmse(true, true), 0.2);
    EXPECT_GT(rmse(false, false), 3 * rmse(true, true)) << "without the fault";
}

TEST(FaultedModel, a_fault_that_dies_out_within_one_plane_is_no_fault) {
    Survey survey = dying_out();
    for (Borehole& hole : survey.holes) {
        const double ground = 100 + 0.02 * hole.at.x - 0.05 * hole.at.y;
        hole.horizons = {ground, ground - 10, ground - 30, ground - 45};
    }
    LayerModelOptions options = square_options();
    options.interpolator = InterpolatorKind::Kriging;
    const FaultTraces both_ends{{{150, 80}, {165, 215}}};
    const LayerModel model = build_faulted_model(survey, both_ends, options);
    expect_sound_blocks(model, survey);
    EXPECT_EQ(model.seams.blocks, 1u);
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        EXPECT_NEAR(model.horizons[0][static_cast<std::size_t>(v.idx())], 100 + 0.02 * p[0] - 0.05 * p[1],
                    5e-3);
    }
    const double area = kExtent * kExtent;
    EXPECT_NEAR(layer_volumes(model)[1], 20 * area, 1e-4 * area);
}

TEST(FaultedModel, a_dying_fault_may_be_refined_and_read_back) {
    const Survey survey = dying_out();
    LayerModelOptions options{.footprint = kSquare, .spacing_factor = 2, .ring_holes = true};
    const LayerModel model = build_faulted_model(
        survey, kDying, options, [](LayerModel block) { return refine_layers(block, {.levels = 1}).model; });
    EXPECT_EQ(model.seams.blocks, 1u);
    expect_sound_blocks(model, survey);
}

TEST(FaultedModel, slabs_are_closed_conform_and_add_up) {
    const Survey pinching = random_survey({.holes = 60, .layers = 4, .seed = 5, .pinch_outs = true});
    const FaultTraces meeting{{{150, -10}, {152, 310}}, {{151, 140}, {220, 130}}};
    LayerModelOptions options = square_options();
    options.interpolator = InterpolatorKind::NaturalNeighbour;
    for (const LayerModel& model : {build_faulted_model(dying_out(), kDying, options),
                                    build_faulted_model(two_blocks(12), kMiddle, options),
                                    build_faulted_model(two_blocks(-9, 0.06), kMiddle, options),
                                    build_faulted_model(pinching, meeting, options)}) {
        const SlabCutter cutter(model, even_levels(model, 5));
        double sum = 0;
        std::map<Triangle, int> uses;
        for (std::size_t s = 0; s < cutter.size(); ++s) {
            const Slab slab = cutter.slab(s);
            for (std::size_t i = 0; i < slab.model.units.size(); ++i)
                for (const LayerSolid& solid : build_block_solids(slab.model, i)) {
                    if (solid.surface.n_faces() == 0) continue;
                    testing::expect_watertight(solid.surface,
                                               solid.unit.code + " in slab " + std::to_string(s));
                    sum += volume(solid.surface);
                    for (const Triangle& t : triangles_of(solid.surface)) ++uses[t];
                }
        }
        EXPECT_NEAR(sum, envelope_volume(model), 1e-9 * sum);
        for (const auto& [t, n] : uses) ASSERT_LE(n, 2);
    }
}

TEST(FaultedModel, dying_faults_that_cross_are_sound) {
    const Survey survey = random_survey({.holes = 60, .layers = 4, .seed = 5, .pinch_outs = true});
    const FaultTraces cross{{{80, 150}, {220, 160}}, {{150, 80}, {155, 230}}},
        t{{{40, 150}, {260, 160}}, {{150, 155}, {140, 60}}},
        en_echelon{{{40, 100}, {170, 140}}, {{130, 170}, {260, 200}}};
    for (const auto& traces : {cross, t, en_echelon}) {
        LayerModelOptions options{.spacing = 30};
        expect_sound_blocks(build_faulted_model(survey, traces, options), survey);
    }
}

TEST(FaultedModel, a_part_without_holes_goes_with_its_neighbour_and_says_so) {
    const std::vector<Point2> holes{{50, 50}, {50, 250}, {250, 250}};
    const FaultBlocks blocks =
        fault_blocks(kSquare, {{{150, -5}, {150, 305}}, {{310, 140}, {150, 140}}}, holes);
    EXPECT_EQ(blocks.outline.size(), 2u);
    ASSERT_EQ(blocks.notes.size(), 1u);
    EXPECT_NE(blocks.notes[0].find("no borehole stands in the part"), std::string::npos);
    EXPECT_EQ(blocks.block_of[0], blocks.block_of[1]);
    EXPECT_NE(blocks.block_of[0], blocks.block_of[2]);
}

TEST(FaultedModel, a_closed_trace_is_a_block_of_its_own) {
    const Survey survey = random_survey({.holes = 60, .layers = 3, .seed = 9});
    const FaultTraces ring{{{80, 80}, {220, 90}, {210, 220}, {90, 200}, {80, 80}}};
    const LayerModel model = build_faulted_model(survey, ring, {.spacing = 30});
    EXPECT_EQ(model.seams.blocks, 2u);
    expect_sound_blocks(model, survey);
}

TEST(FaultedModel, what_is_no_fault_or_stands_on_one_is_refused) {
    const std::vector<Point2> holes{{150, 50}, {50, 50}};
    try {
        fault_blocks(kSquare, kMiddle, holes);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("borehole 1 at x 150, y 50 stands on a fault trace"),
                  std::string::npos);
    }
    EXPECT_THROW(fault_blocks(kSquare, {{{1, 1}}}, holes), InvalidInput);
    EXPECT_THROW(fault_blocks(kSquare, {{{1, 1}, {1, std::nan("")}}}, holes), InvalidInput);
    const LayerModel plain = build_faulted_model(two_blocks(0), {{{400, 0}, {400, 300}}}, square_options());
    EXPECT_TRUE(plain.seams.empty());
    EXPECT_EQ(plain.notes.back(), "no fault trace parts the footprint; the model has no faults");
}

TEST(FaultedModel, lines_are_read_from_geojson_and_wkt) {
    const TemporaryFolder folder;
    folder.file(
        "faults.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString",
                "coordinates":[[150,-10],[150,310]]}},{"type":"Feature","properties":{},"geometry":{"type":"MultiLineString",
                "coordinates":[[[0,1],[2,3]],[[4,5],[6,7],[8,9]]]}}]})");
    const auto traces = read_faults((folder / "faults.geojson").string());
    ASSERT_EQ(traces.size(), 3u);
    EXPECT_EQ(traces[0], kMiddle[0]);
    EXPECT_EQ(traces[2].size(), 3u);
    folder.file("faults.csv", "id,WKT\n1,\"LINESTRING (150 -10, 150 310)\"\n");
    EXPECT_EQ(read_faults((folder / "faults.csv").string()), kMiddle);
    folder.file("points.csv", "id,WKT\n1,\"POINT (150 -10)\"\n");
    EXPECT_THROW(read_faults((folder / "points.csv").string()), InvalidInput);
    EXPECT_THROW(read_faults((folder / "nothing.gpkg").string()), IoError);
}

class RandomFaults : public ::testing::TestWithParam<int> {};

TEST_P(RandomFaults, part_random_surveys_soundly) {
    constexpr int kSeedsPerTest = 10;
    int refused = 0;
    for (int k = 0; k < kSeedsPerTest; ++k) {
        const auto seed = static_cast<std::uint64_t>(GetParam() * kSeedsPerTest + k + 1);
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937_64 random(seed);
        const auto below = [&](std::uint64_t n) { return static_cast<double>(random() % n); };
        const Survey survey = random_survey({.holes = 12 + random() % 50,
                                             .layers = 1 + random() % 5,
                                             .seed = seed,
                                             .corner = seed % 3 == 0 ? Point2{5e6, 4.9e6} : Point2{},
                                             .truth = seed % 2 ? TruthKind::Random : TruthKind::Lens,
                                             .pinch_outs = seed % 5 < 3,
                                             .zero_share = seed % 4 == 0 ? 0.2 : 0.0,
                                             .unknown_share = seed % 7 == 0 ? 0.1 : 0.0,
                                             .cut_off_share = seed % 3 == 1 ? 0.2 : 0.0});
        const Point2 corner = seed % 3 == 0 ? Point2{5e6, 4.9e6} : Point2{};
        FaultTraces traces;
        for (std::size_t t = 0; t < 1 + random() % 3; ++t) {
            auto& trace = traces.emplace_back();
            for (std::size_t i = 0; i < 2 + random() % 3; ++i)
                trace.push_back({corner.x + below(3400) / 10 - 20, corner.y + below(3400) / 10 - 20});
        }
        LayerModelOptions options{.interpolator = seed % 2 ? InterpolatorKind::Linear
                                                           : InterpolatorKind::NaturalNeighbour};
        options.spacing = seed % 4 == 3 ? 0 : 30;
        try {
            expect_sound_blocks(build_faulted_model(survey, traces, options), survey);
        } catch (const InvalidInput& error) {
            ASSERT_NE(std::string(error.what()).find("meets itself in the point"), std::string::npos)
                << error.what();
            ++refused;
        }
        if (HasFailure()) break;
    }
    EXPECT_LE(refused, 1);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomFaults, ::testing::Range(0, 10));

}  // namespace
}  // namespace stratareeb
