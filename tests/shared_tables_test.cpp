// SPDX-License-Identifier: GPL-3.0-or-later
// The real tables beside the source tree, with the counts that their descriptions state.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "boreholes/errors.h"
#include "boreholes/plan_layout.h"
#include "io/read_boreholes.h"
#include "io/read_raster.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

std::string data(const std::string& name) {
    return STRATAREEB_SOURCE_DIR "/../shared/data/" + name;
}

#define NEEDS_DATA() \
    if (!std::filesystem::exists(data("README.md"))) GTEST_SKIP() << "no data beside the source tree"

BoreholeTable read_logs(const std::string& folder, const std::string& logs = "intervals.csv",
                        ReadBoreholesOptions options = {}) {
    options.collars = data(folder + "/collars.csv");
    return read_boreholes({data(folder + "/" + logs)}, options);
}

BoreholeTable read(const std::string& name) {
    return read_boreholes({data(name)});
}

std::size_t count_layers(const Survey& survey, std::size_t unit, Knowledge knowledge, bool zero = false) {
    std::size_t count = 0;
    for (const Borehole& hole : survey.holes)
        count += hole.layers[unit].knowledge == knowledge && (hole.layers[unit].thickness == 0) == zero;
    return count;
}

//! Layers and horizons of one survey must agree wherever both are known.
void expect_consistent(const Survey& survey) {
    for (const Borehole& hole : survey.holes) {
        ASSERT_EQ(hole.layers.size(), survey.units.size());
        ASSERT_EQ(hole.horizons.size(), survey.units.size() + 1);
        std::optional<double> above;
        for (std::size_t i = 0; i < hole.layers.size(); ++i) {
            const LayerFact& fact = hole.layers[i];
            EXPECT_GE(fact.thickness, 0);
            EXPECT_EQ(fact.knowledge == Knowledge::AtLeast,
                      fact.is_present() && fact.knowledge != Knowledge::Measured);
            EXPECT_TRUE(fact.knowledge != Knowledge::Unknown || fact.thickness == 0);
            if (fact.knowledge == Knowledge::Measured && hole.horizons[i] && hole.horizons[i + 1]) {
                EXPECT_NEAR(*hole.horizons[i] - *hole.horizons[i + 1], fact.thickness, 2e-6)
                    << hole.id << ' ' << i;
            }
        }
        for (const auto& z : hole.horizons) {
            if (!z) continue;
            EXPECT_LE(*z, above.value_or(*z) + 1e-9) << hole.id;
            above = z;
        }
    }
}

TEST(SharedTables, thesis) {
    NEEDS_DATA();
    for (const auto& [name, holes, layers] : {std::tuple{"1", 22u, 6u}, {"2", 27u, 6u}, {"3", 56u, 7u}}) {
        const auto named = read(std::string("thesis/thesis_sample") + name + ".csv");
        const auto bare = read(std::string("thesis/thesis_sample") + name + "_wide_noheader.csv");
        ASSERT_EQ(named.survey.holes.size(), holes);
        ASSERT_EQ(named.survey.units.size(), layers);
        for (std::size_t i = 0; i < holes; ++i) {
            EXPECT_EQ(told(named.survey.holes[i]), told(bare.survey.holes[i]));
            EXPECT_EQ(elevations(named.survey.holes[i]), elevations(bare.survey.holes[i]));
            EXPECT_EQ(told(named.survey.holes[i]).find_first_of("?>"), std::string::npos);
        }
        EXPECT_EQ(count_warnings(named.audit, "times_drawn, rows_in_table"), 1u);
        expect_consistent(named.survey);
    }
    EXPECT_EQ(read("thesis/thesis_sample1.xlsx").survey.holes.size(), 22u);
    for (const char* name : {"table_4_1.csv", "table_4_1.xlsx", "table_4_1_wide_noheader.csv"}) {
        const auto table = read(std::string("thesis/") + name);
        EXPECT_EQ(table.survey.holes.size(), 10u);
        EXPECT_EQ(codes(table.survey), "1 2 3");
        EXPECT_NEAR(table.survey.holes[0].layers[0].thickness, 116.5085, 1e-12);
    }
}

TEST(SharedTables, sighthill) {
    NEEDS_DATA();
    const auto logs = read_logs("ags_uk/sighthill");
    EXPECT_EQ(logs.survey.holes.size(), 123u - 3u);  // two places hold five holes
    EXPECT_EQ(logs.survey.units.size(), 7u);
    EXPECT_EQ(count_warnings(logs.audit, "same place"), 3u);
    expect_consistent(logs.survey);
    expect_consistent(read_logs("ags_uk/sighthill", "stratigraphy.csv").survey);
    for (const char* name : {"wide_noheader.csv", "wide.xlsx"}) {
        const auto wide = read(std::string("ags_uk/sighthill/") + name);
        const auto same_place = count_warnings(wide.audit, "same place");
        EXPECT_EQ(wide.survey.holes.size() + same_place, 116u);
        EXPECT_EQ(codes(wide.survey), "1 2 3 4 5");
        EXPECT_EQ(count_layers(wide.survey, 4, Knowledge::Measured), 20u);              // deepest met: rock
        EXPECT_EQ(count_layers(wide.survey, 3, Knowledge::AtLeast), 33u);               // clay
        EXPECT_EQ(count_layers(wide.survey, 1, Knowledge::AtLeast) + same_place, 63u);  // made ground
    }
}

TEST(SharedTables, wigan_depot) {
    NEEDS_DATA();
    const auto logs = read_logs("ags_uk/wigan_depot");
    EXPECT_EQ(logs.survey.units.size(), 5u);
    EXPECT_EQ(count_warnings(logs.audit, "hole ATK/2018/WS11: x 35934.98"), 1u);
    EXPECT_EQ(count_warnings(logs.audit, "has no unit"), 3u);
    EXPECT_GE(count_warnings(logs.audit, "overlaps"), 1u);
    EXPECT_EQ(count_warnings(logs.audit, "hole ATK/2018/WS09"), count_warnings(logs.audit, "overlaps"));
    EXPECT_EQ(count_warnings(logs.audit, "mend the coordinates"), 2u);  // another has its x in y
    EXPECT_EQ(logs.survey.holes.size() + 2u, 81u);
    const auto wide = read("ags_uk/wigan_depot/wide_noheader.csv");
    EXPECT_EQ(wide.survey.holes.size(), 68u);
    ReadBoreholesOptions keep;
    keep.keep_far_holes = true;
    EXPECT_EQ(read_boreholes({data("ags_uk/wigan_depot/wide_noheader.csv")}, keep).survey.holes.size(), 69u);
    expect_consistent(logs.survey);
}

TEST(SharedTables, dlr_city_airport) {
    NEEDS_DATA();
    const auto logs = read_logs("ags_uk/dlr_city_airport");
    EXPECT_EQ(logs.survey.holes.size() + count_warnings(logs.audit, "same place"), 100u);
    EXPECT_EQ(logs.survey.units.size(), 9u);
    EXPECT_EQ(logs.survey.units.front().code, "topsoil");
    EXPECT_EQ(logs.survey.units.back().code, "chalk");
    EXPECT_EQ(count_warnings(logs.audit, "nothing is said of"), 0u);
    expect_consistent(logs.survey);
    ReadBoreholesOptions split;
    split.repeats = RepeatRule::Split;
    const auto parts = read_logs("ags_uk/dlr_city_airport", "intervals.csv", split);
    EXPECT_GT(parts.survey.units.size(), 9u);
    expect_consistent(parts.survey);
}

TEST(SharedTables, teapot_dome) {
    NEEDS_DATA();
    const auto logs = read_logs("teapot_dome");
    EXPECT_EQ(logs.survey.units.front().code, "overburden");
    EXPECT_EQ(logs.survey.units.size(), 35u);
    EXPECT_EQ(count_warnings(logs.audit, "is below to"), 22u);
    EXPECT_EQ(count_warnings(logs.audit, "has no intervals"), 296u);
    EXPECT_EQ(logs.survey.holes.size() + count_warnings(logs.audit, "same place"), 1317u);
    expect_consistent(logs.survey);
    for (const char* name : {"wide_shannon.csv", "wide_shannon.xlsx", "wide_shannon_noheader.csv"}) {
        const auto wide = read(std::string("teapot_dome/") + name);
        EXPECT_EQ(wide.survey.holes.size(), 645u);
        EXPECT_EQ(wide.survey.units.size(), 3u);
    }
    for (const char* name : {"wide_frontier.csv", "wide_frontier_noheader.csv"})
        EXPECT_EQ(read(std::string("teapot_dome/") + name).survey.holes.size(), 119u);
    const auto points = read("teapot_dome/top_points.csv");
    EXPECT_TRUE(points.survey.contact_points);
    EXPECT_EQ(points.survey.units.front().code, "SSXS");
    expect_consistent(points.survey);
    ReadBoreholesOptions tops;
    tops.values = TableValues::Depth;
    tops.points_mark = PointsMark::Top;
    const auto columns = read_logs("teapot_dome", "tops_md.csv", tops);
    EXPECT_EQ(columns.survey.units.front().code, "overburden");
    EXPECT_EQ(columns.survey.holes.size() + count_warnings(columns.audit, "same place") +
                  count_warnings(columns.audit, "no usable collar"),
              1081u);
    expect_consistent(columns.survey);
    const auto tops_long = read_logs("teapot_dome", "tops_long.csv");
    EXPECT_EQ(count_warnings(tops_long.audit, "no usable collar"), 50u);
    expect_consistent(tops_long.survey);
}

TEST(SharedTables, llobregat_delta_as_intervals_samples_and_workbook) {
    NEEDS_DATA();
    const auto logs = read_logs("llobregat_delta");
    EXPECT_EQ(logs.survey.holes.size(), 453u);
    EXPECT_EQ(logs.survey.units.size(), 4u);
    EXPECT_EQ(count_warnings(logs.audit, "nothing is said of"), 2u);
    expect_consistent(logs.survey);
    const auto samples = read("llobregat_delta/samples_1m.csv");
    EXPECT_EQ(samples.layout, TableLayout::Samples);
    ASSERT_EQ(samples.survey.holes.size(), 453u);
    std::map<std::string, std::string> by_id;
    for (const Borehole& hole : logs.survey.holes) by_id[hole.id] = told(hole) + elevations(hole);
    for (const Borehole& hole : samples.survey.holes)
        EXPECT_EQ(told(hole) + elevations(hole), by_id[hole.id]) << hole.id;
    const auto workbook = read("llobregat_delta/original/horizontal sections data.xlsx");
    EXPECT_EQ(workbook.layout, TableLayout::Samples);
    EXPECT_EQ(workbook.survey.holes.size(), 453u);
    EXPECT_EQ(read("llobregat_delta/basement_top_points.csv").survey.holes.size(), 85u);
}

TEST(SharedTables, louisiana_north) {
    NEEDS_DATA();
    const auto logs = read_logs("louisiana_north");
    EXPECT_EQ(codes(logs.survey), "clay sand");
    EXPECT_EQ(logs.survey.holes.size() + count_warnings(logs.audit, "same place"), 484u);
    expect_consistent(logs.survey);
    const auto wide = read("louisiana_north/wide_claycap_noheader.csv");
    EXPECT_EQ(wide.survey.holes.size() + count_warnings(wide.audit, "same place"), 287u);
    expect_consistent(wide.survey);
}

TEST(SharedTables, bungendore_with_its_terrain) {
    NEEDS_DATA();
    for (const bool original : {false, true}) {
        const auto logs =
            original ? read("bungendore/original/litho_logs_sample.csv") : read_logs("bungendore");
        EXPECT_EQ(logs.survey.units.size(), 39u);
        EXPECT_EQ(logs.survey.holes.size(), 73u);
        EXPECT_EQ(count_warnings(logs.audit, "has no unit") + count_warnings(logs.audit, "(no unit)"), 27u);
        EXPECT_EQ(count_warnings(logs.audit, "has no ground elevation"), 5u);
        expect_consistent(logs.survey);
    }
    const auto survey = read_logs("bungendore").survey;
    for (const char* name : {"bungendore/dem.asc", "bungendore/original/sample_dem.tif"}) {
        const Raster dem = read_raster(data(name));
        EXPECT_EQ(dem.columns, 158);
        EXPECT_EQ(dem.rows, 141);
        std::vector<double> differences;
        for (const Borehole& hole : survey.holes)
            if (const auto z = dem.sample(hole.at.x, hole.at.y); z && hole.horizons[0])
                differences.push_back(std::abs(*z - *hole.horizons[0]));
        std::sort(differences.begin(), differences.end());
        EXPECT_GE(differences.size(), 60u);
        EXPECT_LT(differences[differences.size() / 2], 0.5);
        EXPECT_LT(differences.back(), 5.0);
    }
}

TEST(SharedTables, contact_points) {
    NEEDS_DATA();
    const auto claudius = read("points_models/claudius.csv");
    EXPECT_TRUE(claudius.survey.contact_points);
    EXPECT_EQ(codes(claudius.survey), "strati_0 strati_60 strati_250");
    EXPECT_EQ(claudius.survey.holes.size(), 21023u - 2668u);
    EXPECT_EQ(count_warnings(read("points_models/ales.csv").audit, "is a fault"), 3u);
    EXPECT_EQ(count_warnings(read("points_models/perth_basin.csv").audit, "is a fault"), 2u);
    EXPECT_EQ(read("points_models/turner_syncline.csv").survey.holes.size(), 588u);
    EXPECT_EQ(count_warnings(read("points_models/hamersley_contacts.csv").audit, "two heights"), 2u);
    try {
        read("points_models/moureze.csv");
        FAIL() << "an overhang must be refused";
    } catch (const InvalidInput& error) {
        const std::string text = error.what();
        for (const char* word : {"moureze.csv:", "at z", "near x", "overhangs"})
            EXPECT_NE(text.find(word), text.npos) << text;
    }
}

}  // namespace
}  // namespace stratareeb
