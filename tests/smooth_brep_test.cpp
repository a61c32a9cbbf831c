// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/smooth_brep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/grid_model.h"

namespace stratareeb {
namespace {

// Two whole layers over so many times 100 units.
SmoothBrep brep_of(double times, const char* unit) {
    auto model = test::grid_model(
        {.cells = 30,
         .ground = [](double x, double y) { return 3 * std::sin(x / 9) * std::cos(y / 7); },
         .thickness = {test::constant(4), [](double x, double y) { return 5 + std::sin(x / 11 + y / 13); }}});
    auto& plan = model.plan.surface;
    for (const auto v : plan.vertices()) plan.set_point(v, times * plan.point(v));
    for (auto& horizon : model.horizons)
        for (double& z : horizon) z *= times;
    model.length_unit = unit;
    return build_smooth_brep(model);
}

double worst_edge(const SmoothBrep& brep) {
    return std::ranges::max(brep.quality, {}, &SmoothBrep::BodyQuality::edge_off).edge_off;
}

// Beyond a millimetre programs look for edges anew: this is what makes them open a file slowly.
TEST(SmoothBrep, has_edges_within_a_third_of_a_millimetre_of_their_faces) {
    for (const double times : {1, 20, 60}) {
        EXPECT_LT(worst_edge(brep_of(times, "m")), 3.1e-4) << times;
        EXPECT_LT(worst_edge(brep_of(times, "ft")), 3.1e-4 / 0.3048) << times;
    }
}

TEST(SmoothBrep, keeps_to_its_size_where_it_is_too_large_for_that) {
    const SmoothBrep brep = brep_of(1000, "m");
    EXPECT_GT(brep.size, 2e4);
    EXPECT_LT(worst_edge(brep), 2.1e-7 * brep.size);
    EXPECT_GT(worst_edge(brep), 3.1e-4);
}

}  // namespace
}  // namespace stratareeb
