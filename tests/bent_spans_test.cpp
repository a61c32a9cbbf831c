// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/bent_spans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stratareeb {
namespace {

struct Spot {
    Point2 at;
    double reach;
    int name;
};

class BentSpansOfAPatch : public testing::TestWithParam<unsigned> {
 protected:
    BentSpansOfAPatch() {
        std::uniform_real_distribution<double> reach(0, 1);
        patch.coefficients.assign(patch.x.functions() * patch.y.functions(), 0);
        for (int i = 0; i < 400; ++i) {
            spots.push_back({somewhere(), reach(random), i});
            places.add(spots.back());
        }
        places.sort(bent);
    }

    Point2 somewhere() {
        std::uniform_real_distribution<double> in(0, 10);
        return {in(random), in(random)};
    }

    std::mt19937 random{GetParam()};
    HeightPatch patch{
        CubicKnots::uniform(0, 10, 23).refined(std::vector<char>(23, 1)), CubicKnots::uniform(0, 10, 31), {}};
    BentSpans bent{patch};
    std::vector<Spot> spots;
    PlacesBySpan<Spot> places;
};

TEST_P(BentSpansOfAPatch, visit_all_places_once_at_first) {
    std::vector<int> visits(spots.size(), 0);
    places.each_bent(bent, [&](const Spot& spot) { ++visits[static_cast<std::size_t>(spot.name)]; });
    EXPECT_EQ(visits, std::vector<int>(spots.size(), 1));
    places.each_bent(bent, [&](const Spot&) { ADD_FAILURE(); });
}

// All heights that changed are visited, few others are.
TEST_P(BentSpansOfAPatch, visit_places_whose_heights_changed) {
    for (int round = 0; round < 20; ++round) {
        places.each_bent(bent, [](const Spot&) {});
        places.each_bent_around(bent, 1, [](const Spot&) {});
        const HeightPatch before = patch;
        const Point2 at = somewhere();
        bent.bend(at, lower_at(patch, at, 1));
        std::vector<char> visited(spots.size(), 0), around(spots.size(), 0);
        places.each_bent(bent, [&](const Spot& spot) { visited[static_cast<std::size_t>(spot.name)] = 1; });
        places.each_bent_around(bent, 1,
                                [&](const Spot& spot) { around[static_cast<std::size_t>(spot.name)] = 1; });
        std::size_t many = 0;
        for (const Spot& spot : spots) {
            const auto i = static_cast<std::size_t>(spot.name);
            many += static_cast<std::size_t>(visited[i]);
            EXPECT_EQ(visited[i] != 0, before.z(spot.at) != patch.z(spot.at)) << i;
            for (double turn = 0; turn < 6.28; turn += 0.5) {
                const Point2 there{std::clamp(spot.at.x + spot.reach * std::cos(turn), 0.0, 10.0),
                                   std::clamp(spot.at.y + spot.reach * std::sin(turn), 0.0, 10.0)};
                EXPECT_TRUE(around[i] || before.z(there) == patch.z(there)) << i;
            }
        }
        EXPECT_LT(many, spots.size() / 4);
    }
}

// A visit that bends the patch itself comes again.
TEST_P(BentSpansOfAPatch, visit_again_where_a_visit_bent) {
    int visits = 0;
    const auto bend_once = [&](const Spot& spot) {
        if (spot.name == 0 && visits++ == 0) bent.bend(spot.at, 0);
    };
    places.each_bent(bent, bend_once);
    places.each_bent(bent, bend_once);
    EXPECT_EQ(visits, 2);
}

// Whatever bends a patch: no place falls short of its room without being looked at, and few are looked at.
TEST_P(BentSpansOfAPatch, visit_places_that_may_have_risen_too_far) {
    std::uniform_real_distribution<double> by(-1, 1);
    std::vector<double> highest(spots.size(), -INFINITY);
    int visits = 0;
    for (int round = 0; round < 200; ++round) {
        places.each_risen(bent, [&](const Spot& spot) {
            ++visits;
            const double room = 1 + by(random);
            highest[static_cast<std::size_t>(spot.name)] = patch.z(spot.at) + room;
            return room;
        });
        for (const Spot& spot : spots)
            EXPECT_LE(patch.z(spot.at), highest[static_cast<std::size_t>(spot.name)] + 1e-12);
        const Point2 at = somewhere();
        if (round % 2 == 0)
            bent.bend(at, lower_at(patch, at, by(random)));
        else
            bent.bend(at, tilt_at(patch, at, {0.6, 0.8}, by(random)));
    }
    EXPECT_LT(visits, 200 * static_cast<int>(spots.size()) / 10);
    places.each_risen(bent, [](const Spot&) { return 0.0; });
    for (int round = 0; round < 20; ++round) {
        const Point2 at = somewhere();
        bent.bend(at, lower_at(patch, at, 1));
    }
    places.each_risen(bent, [](const Spot&) { return ADD_FAILURE() << "lowered only", 0.0; });
}

INSTANTIATE_TEST_SUITE_P(Seeds, BentSpansOfAPatch, testing::Range(0u, 5u));

}  // namespace
}  // namespace stratareeb
