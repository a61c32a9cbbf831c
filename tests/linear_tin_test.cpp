// SPDX-License-Identifier: GPL-3.0-or-later
// Linear interpolation against the hold-out estimates that the thesis prints (R. Laichuthai, "An enhancement
// of Reeb graph for modeling hydrogeological information", Chulalongkorn University 2006, Tables 4.2 to 4.4).
#include "boreholes/linear_tin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>

namespace stratareeb {
namespace {

struct Hole {
    Point2 at;
    std::vector<double> thickness;  // per layer
};

std::vector<Point2> places(const std::vector<Hole>& holes) {
    std::vector<Point2> at;
    for (const Hole& hole : holes) at.push_back(hole.at);
    return at;
}

//! Thickness of every layer at a place, absent ones as zeros.
std::vector<double> estimate(const std::vector<Hole>& holes, const Point2& where) {
    std::vector<std::vector<double>> layer(holes[0].thickness.size());
    std::vector<SiteField> fields;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        for (const Hole& hole : holes) layer[i].push_back(hole.thickness[i]);
        fields.push_back({layer[i], {}});
    }
    const LinearTin tin(std::make_shared<HoleTriangulation>(places(holes)));
    std::vector<double> result;
    for (const auto& field : tin.predict(std::vector{where}, fields)) result.push_back(field[0]);
    return result;
}

struct Golden {
    const char* row;  // of the thesis
    Point2 at;
    std::vector<Hole> holes;
    std::vector<double> weight;
    std::vector<double> printed;  // "Depth 2"
    double last_digit;
};

// Thicknesses ("Depth 1") of the holes around and the estimate at the hole left out.
const std::vector<Golden> kGolden{
    {"Table 4.2, row 3",
     {-105, 115},
     {{{-155, -22.5}, {51.3948, 52.04788, 0, 52.65265, 41.80584, 36.36157}},
      {{-30, 202.5}, {44.53484, 40.06006, 0, 53.48008, 31.99863, 45.64749}},
      {{-92.5, 202.5}, {51.13041, 40.26161, 25.11142, 54.96707, 35.53856, 46.75435}}},
     {0.388889, 0.188889, 0.422222},
     {49.9874, 44.80709, 10.60261, 53.78613, 37.30718, 42.50364},
     2e-5},
    {"Table 4.2, row 6",  // two holes: half way between
     {-30, 202.5},
     {{{32.5, 202.5}, {46.47219, 36.69643, 0, 52.73171, 33.99262, 35.43713}},
      {{-92.5, 202.5}, {51.13041, 40.26161, 25.11142, 54.96707, 35.53856, 46.75435}}},
     {0.5, 0.5},
     {48.8013, 38.47902, 12.55572, 53.84938, 34.76559, 41.09573},
     2e-5},
    {"Table 4.2, row 13",
     {157.5, 40},
     {{{70, -72.5}, {55.37138, 45.75968, 0, 0, 60.58506, 30.90365}},
      {{57.5, 77.5}, {44.18732, 72.97251, 0, 0, 60.87439, 32.03487}},
      {{245, 40}, {56.37865, 52.28149, 0, 50.63086, 36.3924, 30.20529}}},
     {0.118644, 0.355932, 0.525424},
     {51.91985, 58.87231, 0, 26.60266, 47.97664, 30.93935},
     2e-5},
    {"Table 4.2, row 4",
     {57.5, 77.5},
     {{{70, -72.5}, {55.37138, 45.75968, 0, 0, 60.58506, 30.90365}},
      {{157.5, 40}, {36.90449, 61.11545, 0, 0, 60.25994, 47.55134}},
      {{32.5, 202.5}, {46.47219, 36.69643, 0, 52.73171, 33.99262, 35.43713}}},
     {0.408840, 0.077348, 0.513812},
     {49.3705, 42.2906, 0, 27.09419, 46.8964, 34.52068},
     2e-5},
    {"Table 4.3, row 19",
     {90, 202.5},
     {{{107.5, 215}, {39.88676, 37.78405, 40.00215, 41.33024, 48.3563, 45.84436}},
      {{32.5, 202.5}, {46.47219, 36.69643, 0, 52.73171, 33.99262, 35.43713}},
      {{15, 115}, {40.65987, 41.04004, 0, 51.14393, 41.00604, 36.40396}}},
     {0.793103, 0.093596, 0.113300},
     {40.59073, 38.05115, 31.72585, 43.50925, 46.17912, 43.80069},
     2e-5},
    {"Table 4.3, row 1",
     {70, -72.5},
     {{{157.5, -135}, {43.83072, 56.17483, 0, 43.95358, 35.58185, 36.46592}},
      {{190, -72.5}, {55.37138, 45.75968, 0, 0, 60.58506, 30.90365}},
      {{-35, -22.5}, {51.3948, 52.04788, 0, 52.65265, 41.80584, 36.36157}}},
     {0.382470, 0.139442, 0.478088},
     {49.05627, 52.74947, 0, 41.98352, 42.04396, 35.64042},
     2e-5},
    {"Table 4.4, row 9",
     {57, 77},
     {{{47, 32}, {30, 45, 0, 34, 7, 2, 46}},
      {{42, 99}, {43, 36, 0, 35, 9, 7, 23}},
      {{130, 75}, {25, 47, 0, 35, 0, 22, 15}}},
     {0.272853, 0.572195, 0.154952},
     {36.6638, 40.1601, 0, 34.7272, 7.05973, 7.96, 28.036},
     1e-4},
};

TEST(LinearTin, gives_the_estimates_that_the_thesis_prints) {
    for (const Golden& golden : kGolden) {
        SCOPED_TRACE(golden.row);
        const auto found = estimate(golden.holes, golden.at);
        ASSERT_EQ(found.size(), golden.printed.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], golden.printed[i], golden.last_digit) << "layer " << i + 1;
    }
}

TEST(LinearTin, weighs_holes_as_the_thesis_does) {
    for (const Golden& golden : kGolden) {
        SCOPED_TRACE(golden.row);
        const HoleTriangulation holes(places(golden.holes));
        const PlanLocation found = holes.locate(std::vector{golden.at})[0];
        std::vector<double> weight(golden.holes.size());
        for (int k = 0; k < 3; ++k) weight[found.site[k]] += found.weight[k];
        for (std::size_t h = 0; h < weight.size(); ++h) EXPECT_NEAR(weight[h], golden.weight[h], 5e-7);
    }
}

using Cells = std::vector<std::string>;

std::vector<Cells> table(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::vector<Cells> rows;
    for (std::string line; std::getline(stream, line);) {
        Cells cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
        rows.push_back(cells);
    }
    if (!rows.empty()) rows.erase(rows.begin());
    return rows;
}

std::vector<double> numbers(const std::string& text) {
    std::istringstream stream(text);
    std::vector<double> result;
    for (double number; stream >> number;) result.push_back(number);
    return result;
}

struct Row {
    Hole hole;
    std::string draw;
};

//! Rows of Table 4.2, 4.3 or 4.4: row, x, y, then actual and estimated thickness per layer, draw.
std::vector<Row> thesis_rows(const std::filesystem::path& folder, int sample) {
    std::vector<Row> rows;
    for (const Cells& cells : table(folder / ("table_4_" + std::to_string(sample + 1) + ".csv"))) {
        Row row{{{std::stod(cells[1]), std::stod(cells[2])}, {}}, cells.back()};
        for (std::size_t i = 3; i + 1 < cells.size(); i += 2)
            row.hole.thickness.push_back(std::stod(cells[i]));
        rows.push_back(row);
    }
    return rows;
}

using KnownHoles = std::map<std::pair<double, double>, std::vector<double>>;

KnownHoles holes_of(const std::vector<Row>& rows) {
    KnownHoles holes;
    for (const Row& row : rows) holes[{row.hole.at.x, row.hole.at.y}] = row.hole.thickness;
    return holes;
}

//! Sample 2 is sample 1 and a copy of it 120 to the east: each table tells holes of the other.
KnownHoles known_holes(const std::filesystem::path& folder, int sample) {
    if (sample == 3) return holes_of(thesis_rows(folder, 3));
    constexpr double kShift = 120;
    KnownHoles first = holes_of(thesis_rows(folder, 1));
    const KnownHoles second = holes_of(thesis_rows(folder, 2));
    const auto same = [](const KnownHoles& in, double x, double y, const std::vector<double>& thickness) {
        const auto it = in.find({x, y});
        return it != in.end() && it->second == thickness;
    };
    for (const auto& [at, thickness] : second) {
        const auto [x, y] = at;
        if (first.contains(at) || same(first, x - kShift, y, thickness)) continue;
        if (same(second, x + kShift, y, thickness)) first[at] = thickness;
    }
    if (sample == 1) return first;
    KnownHoles all = second;
    all.insert(first.begin(), first.end());
    for (const auto& [at, thickness] : first) all.insert({{at.first + kShift, at.second}, thickness});
    return all;
}

TEST(LinearTin, gives_all_21_estimates_of_the_thesis_that_can_be_recomputed) {
    const std::filesystem::path folder = STRATAREEB_SOURCE_DIR "/../shared/data/thesis";
    if (!std::filesystem::exists(folder / "reproduced_estimates.csv"))
        GTEST_SKIP() << "no tables of the thesis here";
    int seen = 0;
    for (const Cells& cells : table(folder / "reproduced_estimates.csv")) {
        SCOPED_TRACE("sample " + cells[0] + ", row " + cells[1]);
        const int sample = std::stoi(cells[0]);
        std::set<std::pair<double, double>> drawn;
        for (const Row& row : thesis_rows(folder, sample))
            if (row.draw == cells[2]) drawn.insert({row.hole.at.x, row.hole.at.y});
        std::vector<Hole> rest;
        for (const auto& [at, thickness] : known_holes(folder, sample))
            if (!drawn.contains(at)) rest.push_back({{at.first, at.second}, thickness});
        const auto found = estimate(rest, {std::stod(cells[3]), std::stod(cells[4])});
        const auto printed = numbers(cells[7]);
        const double tolerance = std::stod(cells[9]) + 1e-5 * 10;  // printed to six digits
        ASSERT_EQ(found.size(), printed.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], printed[i], tolerance) << "layer " << i + 1;
        ++seen;
    }
    EXPECT_EQ(seen, 21);
}

std::vector<Point2> random_places(std::size_t count, std::uint64_t seed, double low, double high) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> anywhere(low, high);
    std::vector<Point2> at(count);
    for (Point2& p : at) p = {anywhere(random), anywhere(random)};
    return at;
}

TEST(LinearTin, reproduces_planes_inside_the_hull) {
    for (const double corner : {0.0, 5e6}) {
        auto sites = random_places(60, 3, 0, 100);
        for (const double x : {0.0, 100.0})
            for (const double y : {0.0, 100.0}) sites.push_back({x, y});
        auto where = random_places(500, 4, 0, 100);
        const auto plane = [&](const Point2& p) { return 12 + 0.3 * (p.x - corner) - 0.7 * (p.y - corner); };
        for (auto* list : {&sites, &where})
            for (Point2& p : *list) p = {p.x + corner, p.y + corner};
        std::vector<double> value;
        for (const Point2& p : sites) value.push_back(plane(p));
        const LinearTin tin(std::make_shared<HoleTriangulation>(sites));
        const auto found = tin.predict(where, std::vector<SiteField>{{value, {}}})[0];
        for (std::size_t i = 0; i < where.size(); ++i)
            EXPECT_NEAR(found[i], plane(where[i]), corner == 0 ? 1e-11 : 1e-7);
    }
}

TEST(LinearTin, gives_a_site_its_own_value_to_the_last_bit) {
    const auto sites = random_places(200, 5, 4.9e6, 4.9e6 + 300);
    std::vector<double> value;
    for (const Point2& p : sites) value.push_back(std::sin(p.x) / 3);
    const LinearTin tin(std::make_shared<HoleTriangulation>(sites));
    EXPECT_EQ(tin.predict(sites, std::vector<SiteField>{{value, {}}})[0], value);
}

TEST(LinearTin, leaves_sites_without_a_say_out) {
    const std::vector<Point2> sites{{0, 0}, {4, 0}, {0, 4}};
    const std::vector<double> value{1, 5, 1e9};
    const std::vector<char> use{1, 1, 0}, none{0, 0, 0};
    const LinearTin tin(std::make_shared<HoleTriangulation>(sites));
    const auto found =
        tin.predict(std::vector<Point2>{{1, 2}, {0, 4}}, std::vector<SiteField>{{value, use}, {value, none}});
    EXPECT_DOUBLE_EQ(found[0][0], (0.25 * 1 + 0.25 * 5) / 0.5);
    EXPECT_EQ(found[0][1], 0) << "at a site that has no say";
    EXPECT_EQ(found[1], (std::vector<double>{0, 0}));
}

TEST(LinearTin, stays_within_the_values_of_the_triangle) {
    const auto sites = random_places(50, 6, 0, 1), where = random_places(2000, 7, -0.5, 1.5);
    std::mt19937_64 random(8);
    std::vector<double> value;
    for (std::size_t i = 0; i < sites.size(); ++i) value.push_back(static_cast<double>(random() % 1000));
    const auto holes = std::make_shared<HoleTriangulation>(sites);
    const auto found = LinearTin(holes).predict(where, std::vector<SiteField>{{value, {}}})[0];
    const auto located = holes->locate(where);
    for (std::size_t i = 0; i < where.size(); ++i) {
        const auto& s = located[i].site;
        EXPECT_GE(found[i], std::min({value[s[0]], value[s[1]], value[s[2]]}) - 1e-9);
        EXPECT_LE(found[i], std::max({value[s[0]], value[s[1]], value[s[2]]}) + 1e-9);
    }
}

}  // namespace
}  // namespace stratareeb
