// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/pinch_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace stratareeb {
namespace {

constexpr double kFractions[] = {0, 0.25, 1.0 / 3, 0.5};

//! `present[layer][site]` as "10" strings; thickness 1 where present.
ThicknessField field_of(const std::vector<Point2>& sites, const std::vector<std::string>& present,
                        double fraction) {
    std::vector<std::vector<double>> thickness;
    for (const std::string& layer : present) {
        auto& t = thickness.emplace_back();
        for (const char c : layer) t.push_back(c == '1');
    }
    const auto holes = std::make_shared<const HoleTriangulation>(sites);
    return {holes, thickness, {fraction}, make_interpolator(InterpolatorKind::Linear, holes)};
}

using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;

//! Segments by the coordinates of their ends, the smaller first.
std::multiset<Ends> segments_of(const PlanLines& lines) {
    std::multiset<Ends> result;
    for (const auto& [a, b] : lines.segments) {
        const Point2 &p = lines.points[a], &q = lines.points[b];
        result.insert(std::minmax(std::pair(p.x, p.y), std::pair(q.x, q.y)));
    }
    return result;
}

const std::vector<Point2> kTriangle{{0, 0}, {12, 0}, {0, 12}};

TEST(PinchLines, around_the_one_hole_that_has_a_layer) {
    const auto lines = [](double fraction) {
        return segments_of(pinch_lines(field_of(kTriangle, {"100"}, fraction), 0));
    };
    EXPECT_EQ(lines(0.5), (std::multiset<Ends>{{{0, 6}, {6, 0}}}));
    EXPECT_EQ(lines(0.25), (std::multiset<Ends>{{{0, 9}, {9, 0}}}));
    EXPECT_EQ(lines(0), (std::multiset<Ends>{{{0, 12}, {12, 0}}}));
}

TEST(PinchLines, around_the_one_hole_that_lacks_a_layer) {
    const auto lines = [](double fraction) {
        return segments_of(pinch_lines(field_of(kTriangle, {"011"}, fraction), 0));
    };
    EXPECT_EQ(lines(0.5), (std::multiset<Ends>{{{0, 6}, {6, 0}}}));
    EXPECT_EQ(lines(0.25), (std::multiset<Ends>{{{0, 3}, {3, 0}}}));
    EXPECT_TRUE(lines(0).empty()) << "the layer reaches the hole";
}

TEST(PinchLines, there_are_none_amid_equal_holes) {
    for (const double fraction : kFractions) {
        const PlanLines lines = pinch_lines(field_of(kTriangle, {"111", "000"}, fraction), 100);
        EXPECT_TRUE(lines.points.empty() && lines.segments.empty());
    }
}

TEST(PinchLines, layers_that_end_together_share_one_line) {
    for (const double fraction : kFractions)
        EXPECT_EQ(pinch_lines(field_of(kTriangle, {"100", "100", "100"}, fraction), 0).segments.size(), 1u);
}

TEST(PinchLines, of_a_layer_and_its_complement_are_one_at_half_and_two_otherwise) {
    EXPECT_EQ(pinch_lines(field_of(kTriangle, {"100", "011"}, 0.5), 0).segments.size(), 1u);
    EXPECT_EQ(pinch_lines(field_of(kTriangle, {"100", "011"}, 0.25), 0).segments.size(), 2u);
}

TEST(PinchLines, that_cross_are_cut_where_they_cross) {
    const PlanLines two = pinch_lines(field_of(kTriangle, {"100", "010"}, 0.25), 0);
    EXPECT_EQ(two.segments.size(), 4u);
    EXPECT_NE(std::ranges::find(two.points, Point2{3, 6}), two.points.end()) << "weights 1/4, 1/4, 1/2";
    const PlanLines three = pinch_lines(field_of(kTriangle, {"100", "010", "001"}, 1.0 / 3), 0);
    EXPECT_EQ(three.segments.size(), 6u) << "all meet in the centre";
    EXPECT_NE(std::ranges::find(three.points, Point2{4, 4}), three.points.end());
    EXPECT_EQ(three.points.size(), 7u);
}

TEST(PinchLines, go_on_beyond_the_hull_square_to_its_edge) {
    EXPECT_EQ(segments_of(pinch_lines(field_of({{0, 0}, {12, 0}}, {"10"}, 0.5), 30)),
              (std::multiset<Ends>{{{6, 0}, {6, 30}}, {{6, -30}, {6, 0}}}));
    const auto lines = segments_of(pinch_lines(field_of({{0, 0}, {12, 0}, {6, 12}}, {"101"}, 0.25), 8));
    EXPECT_EQ(lines.count({{9, -8}, {9, 0}}), 1u) << "a quarter of the way from (12, 0)";
}

TEST(PinchLines, cut_the_edges_of_the_triangulation_at_their_own_points) {
    EXPECT_EQ(
        segments_of(cut_triangulation_edges(field_of(kTriangle, {"100"}, 0.5))),
        (std::multiset<Ends>{
            {{0, 0}, {6, 0}}, {{6, 0}, {12, 0}}, {{0, 0}, {0, 6}}, {{0, 6}, {0, 12}}, {{0, 12}, {12, 0}}}));
    EXPECT_EQ(cut_triangulation_edges(field_of(kTriangle, {"100"}, 0)).segments.size(), 3u);
}

//! Places and presence at random. Coordinates are multiples of 12, so that all points of all fractions are
//! whole numbers and tests on them exact.
struct Pattern {
    std::vector<Point2> sites;
    std::vector<std::string> present;
};

Pattern random_pattern(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto count = 3 + random() % 25;
    const std::uint64_t side = seed % 3 == 0 ? 6 : 1000;  // a grid with many holes on a circle, or none
    std::set<std::pair<double, double>> taken;
    while (taken.size() < count)
        taken.insert(
            {12.0 * static_cast<double>(random() % side), 12.0 * static_cast<double>(random() % side)});
    Pattern pattern;
    for (const auto& [x, y] : taken) pattern.sites.push_back({x, y});
    for (int layer = 0; layer < 4; ++layer) {
        auto& present = pattern.present.emplace_back();
        for (std::size_t i = 0; i < count; ++i) present += random() % 2 ? '1' : '0';
    }
    return pattern;
}

//! Twice the signed area; exact for whole numbers up to 12,000.
double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool within_box(const Point2& a, const Point2& b, const Point2& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

//! Closed segments have a place in common.
bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) && ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0)))
        return true;
    return (abc == 0 && within_box(a, b, c)) || (abd == 0 && within_box(a, b, d)) ||
           (cda == 0 && within_box(c, d, a)) || (cdb == 0 && within_box(c, d, b));
}

//! Thirds are whole numbers but for rounding; two points of one place show as a repeat.
PlanLines in_whole_numbers(PlanLines lines) {
    for (Point2& p : lines.points) {
        const Point2 whole{std::round(p.x), std::round(p.y)};
        EXPECT_NEAR(p.x, whole.x, 1e-11) << "the test's own premise";
        EXPECT_NEAR(p.y, whole.y, 1e-11) << "the test's own premise";
        p = whole;
    }
    return lines;
}

void expect_no_crossing(const PlanLines& given) {
    const PlanLines lines = in_whole_numbers(given);
    std::set<std::pair<double, double>> places;
    for (const Point2& p : lines.points)
        ASSERT_TRUE(places.insert({p.x, p.y}).second) << "a point twice: " << p.x << " " << p.y;
    for (std::size_t s = 0; s < lines.segments.size(); ++s) {
        const auto [a, b] = lines.segments[s];
        ASSERT_NE(a, b);
        for (std::size_t r = 0; r < s; ++r) {
            const auto [c, d] = lines.segments[r];
            const Point2 &p = lines.points[a], &q = lines.points[b], &u = lines.points[c],
                         &v = lines.points[d];
            if (a != c && a != d && b != c && b != d) {
                ASSERT_FALSE(meet(p, q, u, v)) << "segments " << r << " and " << s;
                continue;
            }
            // One end shared: the others must not lie along the same way.
            const auto shared = a == c || a == d ? a : b;
            const Point2 &other = lines.points[shared == a ? b : a],
                         &another = lines.points[shared == c ? d : c], &o = lines.points[shared];
            ASSERT_FALSE(turn(o, other, another) == 0 &&
                         (other.x - o.x) * (another.x - o.x) + (other.y - o.y) * (another.y - o.y) > 0)
                << "segments " << r << " and " << s << " overlap";
        }
    }
}

TEST(PinchLines, never_cross_but_at_shared_points) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Pattern pattern = random_pattern(seed);
        for (const double fraction : kFractions)
            expect_no_crossing(pinch_lines(field_of(pattern.sites, pattern.present, fraction), 0));
        if (HasFatalFailure()) break;
    }
}

TEST(PinchLines, meet_cut_triangulation_edges_in_identical_points_only) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Pattern pattern = random_pattern(seed);
        for (const double fraction : kFractions) {
            const auto field = field_of(pattern.sites, pattern.present, fraction);
            PlanLines all = cut_triangulation_edges(field);
            const PlanLines lines = pinch_lines(field, 0);
            std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
            for (const auto& [a, b] : all.segments) joined.insert(std::minmax(a, b));
            std::vector<std::uint32_t> number;
            for (const Point2& p : lines.points) {
                const auto known = std::ranges::find(all.points, p);
                number.push_back(static_cast<std::uint32_t>(known - all.points.begin()));
                if (known == all.points.end()) all.points.push_back(p);
            }
            for (const auto& [a, b] : lines.segments)
                if (joined.insert(std::minmax(number[a], number[b])).second)
                    all.segments.push_back({number[a], number[b]});
            expect_no_crossing(all);
        }
        if (HasFatalFailure()) break;
    }
}

TEST(PinchLines, lie_where_the_share_of_a_layer_is_the_fraction) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        for (const double fraction : kFractions) {
            const Pattern pattern = random_pattern(seed);
            const auto field = field_of(pattern.sites, pattern.present, fraction);
            const PlanLines lines = pinch_lines(field, 0);
            for (const auto& [a, b] : lines.segments) {
                const Point2 &p = lines.points[a], &q = lines.points[b];
                const Point2 middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
                const auto l = field.holes().locate(std::span(&middle, 1))[0];
                double off = 1;
                for (std::size_t layer = 0; layer < field.layers(); ++layer)
                    off = std::min(off, std::abs(field.share(layer, l) - fraction));
                EXPECT_LT(off, 1e-9) << "seed " << seed << " fraction " << fraction;
            }
        }
}

// Oracle: who walks from where a layer is to where it is not crosses a line, outside of the hull too.
TEST(PinchLines, part_where_a_layer_is_from_where_it_is_not) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        for (const double fraction : kFractions) {
            const Pattern pattern = random_pattern(seed);
            const auto field = field_of(pattern.sites, pattern.present, fraction);
            const double reach = 40'000;
            const PlanLines lines = pinch_lines(field, reach);
            std::mt19937_64 random(seed);
            const double extent = seed % 3 == 0 ? 72 : 12'000;
            std::uniform_real_distribution<double> anywhere(-0.1 * extent, 1.1 * extent);
            for (int n = 0; n < 100; ++n) {
                const std::vector<Point2> way{{anywhere(random), anywhere(random)},
                                              {anywhere(random), anywhere(random)}};
                const auto l = field.holes().locate(way);
                bool differ = false;
                for (std::size_t layer = 0; layer < field.layers(); ++layer)
                    differ |= field.is_present(layer, l[0]) != field.is_present(layer, l[1]);
                if (!differ) continue;
                const bool crosses = std::ranges::any_of(lines.segments, [&](const auto& s) {
                    return meet(way[0], way[1], lines.points[s[0]], lines.points[s[1]]);
                });
                ASSERT_TRUE(crosses) << "seed " << seed << " fraction " << fraction << ": " << way[0].x << " "
                                     << way[0].y << " to " << way[1].x << " " << way[1].y;
            }
        }
}

TEST(PinchLines, keep_shared_points_to_the_bit_far_from_the_origin) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> anywhere(5e6, 5e6 + 300);
    std::vector<Point2> sites;
    std::vector<std::string> present(3);
    for (int i = 0; i < 60; ++i) {
        sites.push_back({anywhere(random), anywhere(random)});
        for (auto& layer : present) layer += random() % 2 ? '1' : '0';
    }
    for (const double fraction : kFractions) {
        const auto field = field_of(sites, present, fraction);
        const PlanLines lines = pinch_lines(field, 0), edges = cut_triangulation_edges(field);
        std::vector<int> uses(lines.points.size());
        for (const auto& [a, b] : lines.segments) ++uses[a], ++uses[b];
        for (const Point2& point : lines.points) {
            const bool on_edge = std::ranges::find(edges.points, point) != edges.points.end();
            const auto l = field.holes().locate(std::span(&point, 1))[0];
            const bool amid = std::ranges::min(l.weight) > 1e-6;
            EXPECT_NE(on_edge, amid) << "a point on an edge is a cut of that edge";
        }
    }
}

}  // namespace
}  // namespace stratareeb
