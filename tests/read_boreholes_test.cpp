// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_boreholes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

//! Random holes on a jittered grid. Numbers are multiples of 1/4, so that text and sums are exact.
struct RandomColumns {
    std::vector<std::string> units;
    struct Hole {
        double x, y, ground;
        std::vector<double> thickness;  // down to the deepest unit met, whose is > 0
    };
    std::vector<Hole> holes;
};

RandomColumns random_columns(unsigned seed) {
    std::mt19937 random(seed);
    const auto quarter = [&](unsigned steps) { return 0.25 * static_cast<double>(random() % steps); };
    RandomColumns columns;
    const std::size_t units = 2 + random() % 5;
    for (std::size_t i = 0; i < units; ++i) columns.units.push_back(fmt::format("u{}", (i * 7 + seed) % 100));
    const std::size_t count = 3 + random() % 30;
    for (std::size_t h = 0; h < count; ++h) {
        RandomColumns::Hole hole{5e6 + 40.0 * static_cast<double>(h % 6) + quarter(40),
                                 40.0 * static_cast<double>(h / 6) + quarter(40),
                                 100 + quarter(80),
                                 {}};
        const std::size_t deepest = h == 0 ? units - 1 : random() % units;
        for (std::size_t i = 0; i <= deepest; ++i)
            hole.thickness.push_back(h > 0 && i < deepest && random() % 3 == 0 ? 0.0 : 0.25 + quarter(60));
        columns.holes.push_back(hole);
    }
    return columns;
}

//! What a table tells of a hole whose last layer is, or is not, cut off by the hole's end.
std::string expected_layers(const RandomColumns::Hole& hole, std::size_t units, bool last_is_cut) {
    std::string text;
    for (std::size_t i = 0; i < units; ++i) {
        LayerFact fact;
        if (i < hole.thickness.size()) fact = {Knowledge::Measured, hole.thickness[i]};
        if (i + 1 == hole.thickness.size() && last_is_cut) fact.knowledge = Knowledge::AtLeast;
        text.append(i ? " " : "").append(told(fact));
    }
    return text;
}

std::string expected_elevations(const RandomColumns::Hole& hole, std::size_t units, bool last_is_cut) {
    Borehole result;
    result.horizons.resize(units + 1);
    double z = hole.ground;
    result.horizons[0] = z;
    for (std::size_t i = 0; i < hole.thickness.size(); ++i)
        if (i + 1 < hole.thickness.size() || !last_is_cut) result.horizons[i + 1] = z -= hole.thickness[i];
    return elevations(result);
}

void expect_read_back(const RandomColumns& columns, const Survey& survey, bool last_is_always_cut) {
    const std::size_t units = columns.units.size();
    ASSERT_EQ(survey.units.size(), units);
    ASSERT_EQ(survey.holes.size(), columns.holes.size());
    for (std::size_t h = 0; h < columns.holes.size(); ++h) {
        const auto& truth = columns.holes[h];
        const bool cut = last_is_always_cut || truth.thickness.size() < units;
        EXPECT_EQ(survey.holes[h].at, (Point2{truth.x, truth.y}));
        EXPECT_EQ(told(survey.holes[h]), expected_layers(truth, units, cut));
        EXPECT_EQ(elevations(survey.holes[h]), expected_elevations(truth, units, cut));
    }
    for (std::size_t i = 0; i < units; ++i) EXPECT_EQ(survey.units[i].code, columns.units[i]);
}

constexpr unsigned kRounds = 100;

TEST(ReadBoreholes, random_columns_come_back_from_pairs) {
    const TempFolder folder;
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        const RandomColumns columns = random_columns(seed);
        std::string text;
        for (const auto& hole : columns.holes) {
            text += fmt::format("{},{},{}", hole.x, hole.y, hole.ground);
            for (std::size_t i = 0; i < hole.thickness.size(); ++i)
                text += fmt::format(",{},{}", columns.units[i], hole.thickness[i]);
            text += "\n";
        }
        const auto table = read_boreholes({folder.write("t.csv", text)});
        expect_read_back(columns, table.survey, false);
        EXPECT_EQ(table.audit.warning_count(), 0u) << table.audit.text();
    }
}

TEST(ReadBoreholes, random_columns_come_back_from_layer_columns) {
    const TempFolder folder;
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        const RandomColumns columns = random_columns(seed);
        std::string text = fmt::format("hole_id;x;y;z;{}\r\n", fmt::join(columns.units, ";"));
        for (std::size_t h = 0; h < columns.holes.size(); ++h) {
            const auto& hole = columns.holes[h];
            text += fmt::format("H{};{};{};{}", h, hole.x, hole.y, hole.ground);
            for (std::size_t i = 0; i < columns.units.size(); ++i)
                text += i < hole.thickness.size() ? fmt::format(";{}", hole.thickness[i]) : ";";
            text += "\r\n";
        }
        expect_read_back(columns, read_boreholes({folder.write("t.csv", text)}).survey, false);
    }
}

TEST(ReadBoreholes, random_columns_come_back_from_intervals_in_any_order) {
    const TempFolder folder;
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        const RandomColumns columns = random_columns(seed);
        std::string collars = "id,easting,northing,ground level\n";
        std::vector<std::string> rows;
        for (std::size_t h = 0; h < columns.holes.size(); ++h) {
            const auto& hole = columns.holes[h];
            collars += fmt::format("H{},{},{},{}\n", h, hole.x, hole.y, hole.ground);
            double depth = 0;
            for (std::size_t i = 0; i < hole.thickness.size(); ++i) {
                if (hole.thickness[i] == 0) continue;
                rows.push_back(
                    fmt::format("H{},{},{},{}\n", h, depth, depth + hole.thickness[i], columns.units[i]));
                depth += hole.thickness[i];
            }
        }
        std::shuffle(rows.begin(), rows.end(), std::mt19937(seed));
        ReadBoreholesOptions options;
        options.collars = folder.write("collars.csv", collars);
        options.order = columns.units;
        const auto source =
            folder.write("t.csv", fmt::format("id,from,to,lithology\n{}", fmt::join(rows, "")));
        const auto table = read_boreholes({source}, options);
        expect_read_back(columns, table.survey, true);
        EXPECT_EQ(table.audit.warning_count(), 0u) << table.audit.text();
    }
}

TEST(ReadBoreholes, random_columns_come_back_from_contact_points) {
    const TempFolder folder;
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        const RandomColumns columns = random_columns(seed);
        std::string text = "x,y,z,formation\n";
        for (const auto& hole : columns.holes) {
            double z = hole.ground;
            for (std::size_t i = 0; i < hole.thickness.size(); ++i) {
                text += fmt::format("{},{},{},{}\n", hole.x, hole.y, z, columns.units[i]);
                z -= hole.thickness[i];
            }
        }
        ReadBoreholesOptions options;
        options.order = columns.units;
        const Survey survey = read_boreholes({folder.write("t.csv", text)}, options).survey;
        ASSERT_EQ(survey.units.size() + 1, columns.units.size());
        for (std::size_t h = 0; h < columns.holes.size(); ++h)
            EXPECT_EQ(elevations(survey.holes[h]),
                      expected_elevations(columns.holes[h], columns.units.size() - 1, true));
    }
}

TEST(ReadBoreholes, tables_of_one_layout_are_read_as_one) {
    const TempFolder folder;
    const auto a = folder.write("a.csv", "id,x,y,z,s,c\nA,0,0,9,1,2\n"),
               b = folder.write("b.csv", "id,x,y,z,c,k\nB,1,0,9,1,2\n");
    EXPECT_EQ(codes(read_boreholes({a, b}).survey), "s c k");
    const auto points = folder.write("p.csv", "x,y,z,unit\n0,0,1,a\n1,0,0,b\n");
    EXPECT_THROW(read_boreholes({a, points}), InvalidInput);
    EXPECT_THROW(read_boreholes({}), InvalidInput);
}

TEST(ReadBoreholes, units_have_colours_and_the_survey_its_unit) {
    const TempFolder folder;
    ReadBoreholesOptions options;
    options.length_unit = "us-ft";
    const Survey survey =
        read_boreholes({folder.write("a.csv", "id,x,y,z,s,c\nA,0,0,9,1,2\n")}, options).survey;
    EXPECT_EQ(survey.length_unit, "us-ft");
    EXPECT_EQ(survey.units[0].color.size(), 7u);
    EXPECT_NE(survey.units[0].color, survey.units[1].color);
}

TEST(ReadBoreholes, a_unit_column_full_of_prose_is_refused) {
    const TempFolder folder;
    std::string text = "hole,x,y,z,from,to,unit\n";
    for (int i = 0; i < 600; ++i) text += fmt::format("H{},{},0,9,0,1,\"Brown clay, sample {}\"\n", i, i, i);
    EXPECT_THROW(read_boreholes({folder.write("t.csv", text)}), InvalidInput);
}

TEST(ReadBoreholes, damaged_tables_end_in_words_not_in_a_crash) {
    const TempFolder folder;
    const std::string good =
        "hole,x,y,z,from,to,unit\nA,0,0,9,0,1,s\nA,0,0,9,1,2,c\nB,5,0,9,0,2,s\nB,5,0,9,2,3,c\nC,0,5,8,0,1,"
        "s\n";
    const std::string alphabet = ",\n\";-.0e9 \tNa>\r#x|+";
    std::mt19937 random(11);
    for (int round = 0; round < 3000; ++round) {
        std::string text = good;
        for (unsigned hits = 1 + random() % 6; hits > 0; --hits) {
            const std::size_t at = random() % text.size();
            const unsigned kind = random() % 3;
            if (kind == 0) text[at] = alphabet[random() % alphabet.size()];
            if (kind == 1) text.erase(at, 1 + random() % 8);
            if (kind == 2) text.insert(at, 1, alphabet[random() % alphabet.size()]);
        }
        try {
            const Survey survey = read_boreholes({folder.write("t.csv", text)}).survey;
            for (const Borehole& hole : survey.holes) {
                ASSERT_EQ(hole.layers.size(), survey.units.size());
                ASSERT_EQ(hole.horizons.size(), survey.units.size() + 1);
                for (const LayerFact& fact : hole.layers) ASSERT_GE(fact.thickness, 0) << text;
            }
        } catch (const InvalidInput& error) {
            EXPECT_GT(std::string(error.what()).size(), 10u);
        }
    }
}

}  // namespace
}  // namespace stratareeb
