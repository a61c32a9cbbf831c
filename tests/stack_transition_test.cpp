// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/stack_transition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/stack_cases.h"

namespace stratareeb {
namespace {

using testing::circle;
using testing::rectangle;
using Rings = std::vector<std::uint32_t>;
using Pieces = std::vector<std::pair<Rings, Rings>>;

//! Rings are numbered as given, which must be in sorted_stack's order: from left to right.
Pieces pieces_of(const std::vector<StackContour>& lower, const std::vector<StackContour>& upper) {
    Pieces pieces;
    for (const StackTransition& piece : stack_transitions(StackLevel(lower), StackLevel(upper)).pieces)
        pieces.emplace_back(piece.lower, piece.upper);
    std::ranges::sort(pieces);
    return pieces;
}

std::vector<StackContour> sorted(std::vector<StackContour> contours) {
    return sorted_stack({std::move(contours)}).contours;
}

const std::vector<StackContour> kRing = sorted({rectangle(0, 0, 0, 10, 10), rectangle(0, 3, 3, 7, 7)});

TEST(StackTransition, one_in_the_other_goes_on) {
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 9, 9)}, {rectangle(1, 3, 3, 4, 4)}), (Pieces{{{0}, {0}}}));
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 9, 9)}, {rectangle(1, 0, 0, 9, 9)}), (Pieces{{{0}, {0}}}));
}

TEST(StackTransition, apart_or_touching_they_end_and_start) {
    const Pieces apart{{{}, {0}}, {{0}, {}}};
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 1, 1)}, {rectangle(1, 5, 0, 6, 1)}), apart);
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 1, 1)}, {rectangle(1, 1, 0, 2, 1)}), apart);
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 1, 1)}, {rectangle(1, 1, 1, 2, 2)}), apart);
    EXPECT_EQ(pieces_of({rectangle(0, 0, 0, 1, 1)}, {}), (Pieces{{{0}, {}}}));
}

TEST(StackTransition, hole_closes_in_the_solid_and_opens_in_it) {
    EXPECT_EQ(pieces_of(kRing, {rectangle(1, 0, 0, 10, 10)}), (Pieces{{{0}, {0}}, {{1}, {}}}));
    EXPECT_EQ(pieces_of({rectangle(0, 1, 1, 9, 9)}, kRing), (Pieces{{{}, {1}}, {{0}, {0}}}));
    // The plug fits between hole and outer contour without touching them.
    EXPECT_EQ(pieces_of(kRing, {rectangle(1, 1, 1, 9, 9)}), (Pieces{{{0}, {0}}, {{1}, {}}}));
}

TEST(StackTransition, hole_that_is_hit_from_outside_opens) {
    const StackContour cut{
        .z = 1, .points = {{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 6}, {4, 6}, {4, 10}, {0, 10}}, .name = {}};
    EXPECT_EQ(pieces_of(kRing, {cut}), (Pieces{{{0, 1}, {0}}}));
    EXPECT_EQ(pieces_of({cut}, kRing), (Pieces{{{0}, {0, 1}}}));
}

TEST(StackTransition, ring_vanishes_at_once_whatever_stands_in_its_hole) {
    EXPECT_EQ(pieces_of(kRing, {}), (Pieces{{{0, 1}, {}}}));
    EXPECT_EQ(pieces_of(kRing, {rectangle(1, 4, 4, 6, 6)}), (Pieces{{{}, {0}}, {{0, 1}, {}}}));
    const auto with_island =
        sorted({rectangle(0, 0, 0, 10, 10), rectangle(0, 3, 3, 7, 7), rectangle(0, 4, 4, 6, 6)});
    EXPECT_EQ(pieces_of(with_island, {}), (Pieces{{{0, 1}, {}}, {{2}, {}}}));
    // The moat around the island is filled.
    EXPECT_EQ(pieces_of(with_island, {rectangle(1, 0, 0, 10, 10)}), (Pieces{{{0}, {0}}, {{1, 2}, {}}}));
}

TEST(StackTransition, outer_never_becomes_hole) {
    // A ring moved by more than its wall: its hole overlaps the other's wall, and nothing may link the two.
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        const auto level = [&](double z) {
            std::vector<StackContour> contours;
            for (int k = 0; k < 4; ++k) {
                const double x = 3 * k + unit(random), y = unit(random), r = 0.6 + unit(random) * 0.35;
                contours.push_back(circle(z, x, y, r, 24));
                if (random() % 2) contours.push_back(circle(z, x, y, r * (0.3 + 0.65 * unit(random)), 24));
            }
            return contours;
        };
        std::vector<StackContour> a = level(0), b = level(1);
        const auto apart = [](const std::vector<StackContour>& contours) {
            try {
                sorted_stack({contours});
                return true;
            } catch (const std::exception&) {
                return false;
            }
        };
        if (!apart(a) || !apart(b)) continue;
        a = sorted(a), b = sorted(b);
        const StackLevel lower(a), upper(b);
        std::vector<int> seen_below(lower.size(), 0), seen_above(upper.size(), 0);
        for (const StackTransition& piece : stack_transitions(lower, upper).pieces) {
            for (const auto r : piece.lower) ++seen_below[r];
            for (const auto r : piece.upper) ++seen_above[r];
            EXPECT_TRUE(piece.lower.size() < 2 || piece.upper.size() < 2);
            if (piece.lower.size() == 1 && piece.upper.size() == 1) {
                EXPECT_EQ(lower.is_hole(piece.lower[0]), upper.is_hole(piece.upper[0]));
            }
        }
        EXPECT_TRUE(std::ranges::all_of(seen_below, [](int n) { return n == 1; }));
        EXPECT_TRUE(std::ranges::all_of(seen_above, [](int n) { return n == 1; }));
    }
}

TEST(StackTransition, upside_down_is_the_same) {
    std::mt19937_64 random(8);
    const auto blobs = testing::random_blobs(20, 16, random);
    const TriMesh mesh = half_edge_mesh(testing::implicit_body(20, blobs));
    const SortedStack stack =
        sorted_stack(testing::sections(mesh, height_field(mesh), even_levels(height_field(mesh), 12)));
    for (std::size_t l = 0; l + 2 < stack.first.size(); ++l) {
        const auto at = [&](std::size_t k) {
            return StackLevel(
                std::span(stack.contours).subspan(stack.first[k], stack.first[k + 1] - stack.first[k]));
        };
        Pieces up, down;
        for (const auto& piece : stack_transitions(at(l), at(l + 1)).pieces)
            up.emplace_back(piece.lower, piece.upper);
        for (const auto& piece : stack_transitions(at(l + 1), at(l)).pieces)
            down.emplace_back(piece.upper, piece.lower);
        std::ranges::sort(up);
        std::ranges::sort(down);
        EXPECT_EQ(up, down);
    }
}

}  // namespace
}  // namespace stratareeb
