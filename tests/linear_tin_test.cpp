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

#include "tests/thesis_estimates.h"

namespace stratareeb {
namespace {

using thesis::Golden;
using thesis::Hole;
using thesis::kGolden;

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
