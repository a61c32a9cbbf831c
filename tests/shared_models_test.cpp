// SPDX-License-Identifier: GPL-3.0-or-later
// Models of real borehole sets, checked by CGAL, and of the thesis's samples against the values it prints. The sets stand
// beside the source tree where the project is developed; elsewhere these tests are skipped and examples/ alone is modelled.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/read_boreholes.h"
#include "io/read_raster.h"
#include "mesh/model_summary.h"
#include "tests/model_soundness.h"
#include "tests/thesis_estimates.h"

namespace stratareeb {
namespace {

const std::string kExamples = STRATAREEB_SOURCE_DIR "/examples/";
const std::string kShared = STRATAREEB_SOURCE_DIR "/../shared/data/";

struct Set {
    const char* name;
    std::string table, collars, unit = "m";
    double spacing = 0;  // 0 = suitable
    RepeatRule repeats = RepeatRule::Absorb;
};

void expect_sound_model(const Set& set) {
    ReadBoreholesOptions read;
    read.collars = set.collars;
    read.length_unit = set.unit;
    read.repeats = set.repeats;
    const Survey survey = read_boreholes({set.table}, read).survey;
    LayerModelOptions options;
    if (set.spacing > 0) options.spacing = set.spacing;
    const LayerModel model = build_layer_model(survey, options);
    testing::expect_sound(model, survey);
    const auto& [low, high] = std::ranges::minmax(survey.holes, {}, [](const Borehole& h) { return h.at.x; });
    EXPECT_LE(misfit_of(model, survey).max, 1e-9 * (high.at.x - low.at.x));
}

TEST(ExampleModels, are_watertight_conforming_and_true_to_their_holes) {
    expect_sound_model(
        {"intervals", kExamples + "sighthill/intervals.csv", kExamples + "sighthill/collars.csv"});
    expect_sound_model({"wide", kExamples + "sighthill/wide_noheader.csv", ""});
    expect_sound_model({"thesis", kExamples + "thesis_sample3.csv", ""});
}

class SharedModels : public ::testing::TestWithParam<Set> {};

TEST_P(SharedModels, are_watertight_conforming_and_true_to_their_holes) {
    Set set = GetParam();
    set.table = kShared + set.table;
    if (!set.collars.empty()) set.collars = kShared + set.collars;
    if (!std::filesystem::exists(set.table)) GTEST_SKIP() << "no " << set.table;
    expect_sound_model(set);
}

INSTANTIATE_TEST_SUITE_P(
    Sets, SharedModels,
    ::testing::Values(Set{"thesis_table", "thesis/table_4_1_wide_noheader.csv", ""},
                      Set{"thesis_1", "thesis/thesis_sample1_wide_noheader.csv", ""},
                      Set{"thesis_2", "thesis/thesis_sample2_wide_noheader.csv", ""},
                      Set{"thesis_3", "thesis/thesis_sample3_wide_noheader.csv", ""},
                      Set{"wigan", "ags_uk/wigan_depot/intervals.csv", "ags_uk/wigan_depot/collars.csv"},
                      Set{"wigan_wide", "ags_uk/wigan_depot/wide_noheader.csv", ""},
                      Set{"docklands", "ags_uk/dlr_city_airport/intervals.csv",
                          "ags_uk/dlr_city_airport/collars.csv"},
                      Set{"shannon", "teapot_dome/wide_shannon.csv", "", "ft"},
                      Set{"frontier", "teapot_dome/wide_frontier_noheader.csv", "", "ft"},
                      Set{"teapot", "teapot_dome/intervals.csv", "teapot_dome/collars.csv", "ft", 2000},
                      Set{"llobregat", "llobregat_delta/intervals.csv", "llobregat_delta/collars.csv"},
                      Set{"louisiana", "louisiana_north/intervals.csv", "louisiana_north/collars.csv"},
                      Set{"louisiana_split", "louisiana_north/intervals.csv", "louisiana_north/collars.csv",
                          "m", 5000, RepeatRule::Split},
                      Set{"claycap", "louisiana_north/wide_claycap_noheader.csv", ""},
                      Set{"bungendore", "bungendore/intervals.csv", "bungendore/collars.csv", "m", 200},
                      Set{"claudius", "points_models/claudius.csv", "", "m", 400}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(SharedModels, follow_a_terrain_and_still_meet_the_collars) {
    const std::string folder = kShared + "bungendore/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
    ReadBoreholesOptions read;
    read.collars = folder + "collars.csv";
    read.has_ground_raster = true;
    const Survey survey = read_boreholes({folder + "intervals.csv"}, read).survey;
    const Raster raster = read_raster(folder + "dem.asc");
    LayerModelOptions options;
    options.spacing = 200;
    options.terrain = [&](const Point2& p) { return raster.sample(p.x, p.y); };
    const LayerModel model = build_layer_model(survey, options);
    testing::expect_sound(model, survey);
    EXPECT_LE(misfit_of(model, survey).max, 1e-9 * 4000);
    double farthest =
        0;  // collars are up to 2.3 m off the raster (its README); the bent ground stays as close to it
    for (const auto v : model.plan.surface.vertices()) {
        const auto& p = model.plan.surface.point(v);
        const auto z = raster.sample(p[0] + model.origin.x, p[1] + model.origin.y);
        ASSERT_TRUE(z);
        farthest = std::max(
            farthest, std::abs(model.horizons[0][static_cast<std::size_t>(v.idx())] + model.origin.z - *z));
    }
    EXPECT_LE(farthest, 2.3 * 2);
    EXPECT_GT(farthest, 0.1);
}

//! Thickness of each layer at a place, linear over the plan triangle around it.
std::vector<double> thickness_at(const LayerModel& model, double x, double y) {
    const auto& mesh = model.plan.surface;
    for (const auto f : mesh.faces()) {
        std::array<std::size_t, 3> corner{};
        std::array<TriMesh::Point, 3> p;
        int k = 0;
        for (const auto v : mesh.fv_range(f))
            corner[k] = static_cast<std::size_t>(v.idx()), p[k++] = mesh.point(v);
        const auto twice = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
        const double all = twice(p[1][0] - p[0][0], p[1][1] - p[0][1], p[2][0] - p[0][0], p[2][1] - p[0][1]);
        std::array<double, 3> w{};
        for (int i = 0; i < 3; ++i) {
            const auto &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
            w[i] = twice(a[0] - x, a[1] - y, b[0] - x, b[1] - y) / all;
        }
        if (std::ranges::min(w) < -1e-12) continue;
        std::vector<double> result;
        for (std::size_t layer = 0; layer < model.units.size(); ++layer)
            result.push_back(w[0] * model.thickness(layer, corner[0]) +
                             w[1] * model.thickness(layer, corner[1]) +
                             w[2] * model.thickness(layer, corner[2]));
        return result;
    }
    return {};
}

TEST(ThesisModels, bare_linear_surfaces_have_the_printed_values_between_holes) {
    std::size_t compared = 0;
    for (const thesis::Golden& golden : thesis::kGolden) {
        SCOPED_TRACE(golden.row);
        if (golden.holes.size() < 3) continue;  // on an edge between two holes: no area of its own
        ++compared;
        Survey survey;
        for (std::size_t i = 0; i < golden.printed.size(); ++i)
            survey.units.push_back({std::to_string(i + 1), "", "#808080"});
        for (const thesis::Hole& known : golden.holes) {
            Borehole hole{.id = "", .at = known.at, .layers = {}, .horizons = {0.0}};
            for (const double t : known.thickness) hole.layers.push_back({Knowledge::Measured, t});
            survey.holes.push_back(hole);
        }
        LayerModelOptions options;
        options.interpolator = InterpolatorKind::Linear;
        options.pinch_out.fraction = 0;
        options.spacing = 0;
        const auto values = thickness_at(build_layer_model(survey, options), golden.at.x, golden.at.y);
        ASSERT_EQ(values.size(), golden.printed.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], golden.printed[i], golden.last_digit);
    }
    EXPECT_GE(compared, 4u);
}

}  // namespace
}  // namespace stratareeb
