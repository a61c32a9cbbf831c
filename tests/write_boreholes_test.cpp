// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_boreholes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/read_boreholes.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;

class WriteBoreholes : public testing::Test {
 protected:
    WriteBoreholes() { fs::create_directories(folder_); }
    ~WriteBoreholes() override { fs::remove_all(folder_); }

    static std::string content(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    fs::path folder_ = fs::temp_directory_path() / ("write_boreholes_test_" + std::to_string(::getpid()));
};

Survey hand_made() {
    Survey survey;
    survey.units = {{"clay", "clay", ""}, {"sand, fine", "sand, fine", ""}};
    Borehole first{
        .id = "B \"1\"", .at = {0.1, -2e-7}, .layers = {}, .horizons = {100.0, 98.0, std::nullopt}};
    first.layers = {{Knowledge::Measured, 2}, {Knowledge::AtLeast, 1.0 / 3}};
    Borehole second{.id = "B2", .at = {5'000'000.001, 7}, .layers = {}, .horizons = {{}, {}, {}}};
    second.layers = {{}, {Knowledge::Measured, 0}};
    survey.holes = {first, second};
    return survey;
}

//! What a reader takes from a row that ends in empty cells: the hole ended in its last layer.
Survey as_read(Survey survey) {
    for (Borehole& hole : survey.holes) {
        const auto deepest =
            std::find_if(hole.layers.rbegin(), hole.layers.rend(),
                         [](const LayerFact& fact) { return fact.knowledge != Knowledge::Unknown; });
        if (deepest != hole.layers.rend() && deepest != hole.layers.rbegin() && deepest->is_present())
            deepest->knowledge = Knowledge::AtLeast;
    }
    return survey;
}

void expect_same_facts(const Survey& read, const Survey& written, const std::string& what) {
    ASSERT_EQ(read.units.size(), written.units.size()) << what;
    ASSERT_EQ(read.holes.size(), written.holes.size()) << what;
    for (std::size_t i = 0; i < written.units.size(); ++i)
        EXPECT_EQ(read.units[i].code, written.units[i].code) << what;
    for (std::size_t h = 0; h < written.holes.size(); ++h) {
        const Borehole &a = read.holes[h], &b = written.holes[h];
        EXPECT_EQ(a.id, b.id) << what;
        EXPECT_EQ(a.at, b.at) << what << ", hole " << b.id;
        EXPECT_EQ(a.horizons[0], b.horizons[0]) << what << ", hole " << b.id;
        for (std::size_t i = 0; i < written.units.size(); ++i) {
            EXPECT_EQ(a.layers[i].knowledge, b.layers[i].knowledge)
                << what << ", hole " << b.id << ", layer " << i;
            EXPECT_EQ(a.layers[i].thickness, b.layers[i].thickness)
                << what << ", hole " << b.id << ", layer " << i;
        }
    }
}

TEST_F(WriteBoreholes, wide_csv_keeps_absent_unknown_and_at_least_apart) {
    write_boreholes(folder_ / "a.csv", hand_made());
    EXPECT_EQ(content(folder_ / "a.csv"),
              "hole_id,x,y,ground,clay,\"sand, fine\"\n"
              "\"B \"\"1\"\"\",0.1,-2e-07,100,2,>0.3333333333333333\n"
              "B2,5000000.001,7,,,0\n");
}

TEST_F(WriteBoreholes, wide_tables_read_back_as_the_same_survey_to_the_last_bit) {
    for (const char* name : {"a.csv", "a.xlsx"})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Survey survey = random_survey({.holes = 30,
                                                 .layers = 4,
                                                 .seed = seed,
                                                 .corner = {5e6, 6e6},
                                                 .plan = HolePlan::Clustered,
                                                 .pinch_outs = true,
                                                 .resolution = name == std::string("a.csv") ? 0 : 0.001,
                                                 .zero_share = 0.1,
                                                 .unknown_share = 0.1,
                                                 .cut_off_share = 0.3});
            write_boreholes(folder_ / name, survey);
            const BoreholeTable table = read_boreholes({(folder_ / name).string()});
            EXPECT_EQ(table.layout, TableLayout::Wide);
            expect_same_facts(table.survey, as_read(survey),
                              name + std::string(", seed ") + std::to_string(seed));
        }
}

TEST_F(WriteBoreholes, intervals_read_back_down_to_the_last_unit_of_each_log) {
    const Survey survey = random_survey({.holes = 40, .layers = 5, .pinch_outs = true, .cut_off_share = 0.4});
    write_boreholes(folder_ / "logs.csv", survey, TableLayout::Intervals);
    ReadBoreholesOptions options{.collars = collar_table(folder_ / "logs.csv").string()};
    for (const Unit& unit : survey.units) options.order.push_back(unit.code);
    const BoreholeTable table = read_boreholes({(folder_ / "logs.csv").string()}, options);
    ASSERT_EQ(table.layout, TableLayout::Intervals);
    ASSERT_EQ(table.survey.holes.size(), 40u);
    for (std::size_t h = 0; h < 40; ++h) {
        const Borehole &read = table.survey.holes[h], &written = survey.holes[h];
        EXPECT_EQ(read.at, written.at);
        std::size_t last = 0;
        for (std::size_t i = 0; i < 5; ++i)
            if (written.layers[i].is_present()) last = i;
        for (std::size_t i = 0; i <= last; ++i) {
            EXPECT_NEAR(read.layers[i].thickness, written.layers[i].thickness, 1e-9)
                << read.id << ", layer " << i;
            EXPECT_EQ(read.layers[i].knowledge, i < last ? Knowledge::Measured : Knowledge::AtLeast)
                << read.id;
        }
    }
}

TEST_F(WriteBoreholes, points_read_back_as_the_same_horizons) {
    const Survey survey = random_survey({.holes = 20, .layers = 3, .cut_off_share = 0.3});
    write_boreholes(folder_ / "points.csv", survey, TableLayout::Points);
    const BoreholeTable table = read_boreholes({(folder_ / "points.csv").string()});
    ASSERT_EQ(table.layout, TableLayout::Points);
    ASSERT_EQ(table.survey.holes.size(), 20u);
    for (std::size_t h = 0; h < 20; ++h) EXPECT_EQ(table.survey.holes[h].horizons, survey.holes[h].horizons);
}

TEST_F(WriteBoreholes, refuses_what_it_cannot_write) {
    const Survey survey = random_survey();
    EXPECT_THROW(write_boreholes(folder_ / "a.doc", survey), IoError);
    EXPECT_THROW(write_boreholes(folder_ / "no" / "a.csv", survey), IoError);
    EXPECT_THROW(write_boreholes(folder_ / "no" / "a.xlsx", survey), IoError);
    EXPECT_THROW(write_boreholes(folder_ / "a.csv", survey, TableLayout::Samples), InvalidInput);
    EXPECT_THROW(write_boreholes(folder_ / "a.csv", hand_made(), TableLayout::Intervals), InvalidInput);
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(WriteBoreholes, a_failed_write_leaves_the_old_file) {
    write_boreholes(folder_ / "a.csv", hand_made());
    const std::string before = content(folder_ / "a.csv");
    EXPECT_THROW(write_boreholes(folder_ / "a.csv", hand_made(), TableLayout::Intervals), InvalidInput);
    EXPECT_EQ(content(folder_ / "a.csv"), before);
}

}  // namespace
}  // namespace stratareeb
