// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/plan_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/self_intersection.h"
#include "reeb/link_signs.h"
#include "tests/sheet_cases.h"

namespace stratareeb {
namespace {

using testing::summits;
using testing::wavy_ring;

TriangleSoup soup_of(const std::vector<SheetRing>& rings, const PlanSheet& sheet) {
    TriangleSoup soup;
    for (const SheetRing& ring : rings)
        soup.points.insert(soup.points.end(), ring.points.begin(), ring.points.end());
    soup.points.insert(soup.points.end(), sheet.added.begin(), sheet.added.end());
    soup.triangles = sheet.triangles;
    return soup;
}

double up(const TriangleSoup& soup, const std::array<std::uint32_t, 3>& t) {
    const Point3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

//! By number of changes around an added vertex: how many there are.
std::map<int, int> kinds(const std::vector<SheetRing>& rings, const PlanSheet& sheet) {
    const TriangleSoup soup = soup_of(rings, sheet);
    std::vector<bool> is_added(soup.points.size(), true);
    const std::size_t first = soup.points.size() - sheet.added.size();
    std::fill_n(is_added.begin(), first, false);
    const auto signs = link_signs(soup, is_added);
    std::map<int, int> result;
    for (std::size_t v = first; v < signs.size(); ++v) ++result[signs[v]];
    return result;
}

void expect_sheet(const std::vector<SheetRing>& rings, const std::optional<PlanSheet>& sheet, bool faces_up) {
    ASSERT_TRUE(sheet);
    const TriangleSoup soup = soup_of(rings, *sheet);
    EXPECT_EQ(self_intersections(soup).count, 0u);
    for (const auto& t : soup.triangles) EXPECT_EQ(up(soup, t) > 0, faces_up);
}

TEST(PlanSheet, bands_rise_from_ring_to_ring) {
    for (const bool outer_is_lower : {true, false})
        for (const bool is_hole : {true, false}) {
            const std::vector<SheetRing> rings{
                {wavy_ring(0, 0, outer_is_lower ? 0 : 1, 5, 60, 0.2), outer_is_lower, is_hole},
                {wavy_ring(0, 0, outer_is_lower ? 1 : 0, 2.5, 40, 0.3), !outer_is_lower, is_hole}};
            const auto sheet = plan_sheet(rings, std::nullopt, 6);
            ASSERT_NO_FATAL_FAILURE(expect_sheet(rings, sheet, outer_is_lower != is_hole));
            EXPECT_EQ(kinds(rings, *sheet).size(), 1u);
            EXPECT_EQ(kinds(rings, *sheet).begin()->first, 2);
        }
}

TEST(PlanSheet, caps_rise_or_fall_to_the_node) {
    const std::vector<Point3> shoe{{0, 0, 1}, {9, 0, 1}, {9, 9, 1}, {7, 9, 1},
                                   {7, 2, 1}, {2, 2, 1}, {2, 9, 1}, {0, 9, 1}};
    for (const bool is_top : {true, false}) {
        const std::vector<SheetRing> rings{{shoe, is_top, false}};
        const auto sheet = plan_sheet(rings, Point3{8, 8, is_top ? 2.0 : 0.0}, 6);
        ASSERT_NO_FATAL_FAILURE(expect_sheet(rings, sheet, is_top));
        const auto found = kinds(rings, *sheet);
        EXPECT_EQ(found.at(is_top ? kHighest : kLowest), 1);
        EXPECT_EQ(found.at(2), static_cast<int>(sheet->added.size()) - 1);
        EXPECT_FALSE(plan_sheet(rings, Point3{5, 5, is_top ? 2.0 : 0.0}, 6)) << "outside of the horseshoe";
        EXPECT_FALSE(plan_sheet(rings, Point3{8, 8, is_top ? 0.5 : 1.5}, 6)) << "on the wrong side";
    }
}

TEST(PlanSheet, caps_hold_what_half_ellipsoids_do) {
    const std::vector<SheetRing> rings{{wavy_ring(5'000'000, 400'000, 100, 30, 120, 0.1), true, false}};
    const auto sheet = plan_sheet(rings, Point3{5'000'003, 400'002, 120}, 12);
    ASSERT_NO_FATAL_FAILURE(expect_sheet(rings, sheet, true));
    const TriangleSoup soup = soup_of(rings, *sheet);
    double area = 0, volume = 0;
    for (const auto& t : soup.triangles) {
        area += up(soup, t) / 2;
        for (const std::uint32_t v : t) volume += up(soup, t) / 6 * (soup.points[v].z - 100);
    }
    EXPECT_NEAR(volume, 2.0 / 3 * area * 20, 1e-6 * volume);
}

// One saddle of the right multiplicity at the node, or simple ones across gaps, and nothing else.
TEST(PlanSheet, branches_have_the_saddles_they_are_asked_for) {
    for (int count = 2; count <= 8; ++count)
        for (int seed = 0; seed < 6; ++seed)
            for (const bool mirrored : {false, true}) {
                SCOPED_TRACE(::testing::Message()
                             << count << " summits, seed " << seed << (mirrored ? ", pits" : ""));
                auto rings = summits(count, 0.06 * seed, seed);
                if (mirrored)
                    for (SheetRing& ring : rings) {
                        ring.is_lower = !ring.is_lower;
                        for (Point3& p : ring.points) p.z *= -1;
                    }
                const auto sheet = plan_sheet(rings, Point3{0.1, -0.2, mirrored ? -1.2 : 1.2}, 4);
                ASSERT_NO_FATAL_FAILURE(expect_sheet(rings, sheet, !mirrored));
                auto found = kinds(rings, *sheet);
                const int regular = found[2];
                found.erase(2);
                int multiplicity = 0, saddles = 0;
                for (const auto& [changes, many] : found) {
                    ASSERT_GE(changes, 4);
                    multiplicity += many * (changes / 2 - 1);
                    saddles += many;
                }
                EXPECT_EQ(multiplicity, count - 1);
                EXPECT_EQ(static_cast<std::size_t>(saddles), sheet->critical);
                EXPECT_EQ(regular + saddles, static_cast<int>(sheet->added.size()));
                for (std::size_t k = 0; k < sheet->critical; ++k)
                    EXPECT_EQ(sheet->added[k].z, mirrored ? -1.2 : 1.2);
            }
}

// A crater whose rim opens: a contour and its hole below, a crescent above.
TEST(PlanSheet, a_contour_and_its_hole_meet) {
    std::vector<Point3> crescent;
    for (int i = 0; i <= 50; ++i) {
        const double a = 0.5 + (2 * std::numbers::pi - 1) * i / 50;
        crescent.push_back({3.2 * std::cos(a), 3.2 * std::sin(a), 1});
    }
    for (int i = 50; i >= 0; --i) {
        const double a = 0.5 + (2 * std::numbers::pi - 1) * i / 50;
        crescent.push_back({2.4 * std::cos(a), 2.4 * std::sin(a), 1});
    }
    const std::vector<SheetRing> rings{{wavy_ring(0, 0, 0, 4, 80), true, false},
                                       {wavy_ring(0, 0, 0, 1.5, 50), true, true},
                                       {crescent, false, false}};
    const auto sheet = plan_sheet(rings, Point3{2.8, 0, 0.4}, 5);
    ASSERT_NO_FATAL_FAILURE(expect_sheet(rings, sheet, true));
    EXPECT_EQ(kinds(rings, *sheet).at(4), 1);
}

TEST(PlanSheet, is_nothing_where_heights_over_the_plan_are_not_single) {
    auto rings = summits(2);
    const Point3 node{0, 0, 1};
    EXPECT_TRUE(plan_sheet(rings, node, 4));
    EXPECT_FALSE(plan_sheet(rings, std::nullopt, 4));
    EXPECT_FALSE(plan_sheet(rings, Point3{5, 0, 1}, 4)) << "the node is in a summit";
    EXPECT_FALSE(plan_sheet(rings, Point3{0, 0, 3}, 4)) << "the node is above all";
    auto crossing = rings;
    for (Point3& p : crossing[1].points) p.x += 4;
    EXPECT_FALSE(plan_sheet(crossing, node, 4));
    auto tilted = rings;
    tilted[1].points[0].z += 0.1;
    EXPECT_FALSE(plan_sheet(tilted, node, 4));
    auto inside_out = rings;
    inside_out[1].is_hole = true;
    EXPECT_FALSE(plan_sheet(inside_out, node, 4));
    const std::vector<SheetRing> beside{{wavy_ring(0, 0, 0, 1), true, false},
                                        {wavy_ring(5, 0, 1, 1), false, false}};
    EXPECT_FALSE(plan_sheet(beside, std::nullopt, 4));
}

}  // namespace
}  // namespace stratareeb
