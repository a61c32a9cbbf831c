// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/thickness_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stratareeb {
namespace {

// A square of 20 x 20 cells of two triangles, side 10.
TriMesh square_plan() {
    TriMesh plan;
    std::vector<TriMesh::VertexHandle> v;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) v.push_back(plan.add_vertex({0.5 * i, 0.5 * j, 0}));
    for (std::size_t i = 0; i < 20; ++i)
        for (std::size_t j = 0; j < 20; ++j) {
            const std::size_t a = 21 * i + j;
            plan.add_face(v[a], v[a + 21], v[a + 22]);
            plan.add_face(v[a], v[a + 22], v[a + 1]);
        }
    return plan;
}

HeightPatch random_patch(const CubicKnots& x, const CubicKnots& y, unsigned seed) {
    std::mt19937_64 random(seed);
    HeightPatch patch{x, y, {}};
    for (std::size_t i = 0; i < x.functions() * y.functions(); ++i)
        patch.coefficients.push_back(std::normal_distribution<double>(0, 20)(random));
    return patch;
}

std::vector<ThicknessSample> all_faces(const TriMesh& plan, double thickness, const HeightPatch& top) {
    std::vector<ThicknessSample> samples;
    for (std::uint32_t f = 0; f < plan.n_faces(); ++f) samples.push_back({f, thickness, &top});
    return samples;
}

const CubicKnots kCoarse = CubicKnots::uniform(-1, 11, 5);

// The patch of the limits themselves is the top, lowered: refining the knots does not change a spline.
TEST(ThicknessLimits, are_the_top_in_finer_knots_less_the_share) {
    const TriMesh plan = square_plan();
    const auto top = random_patch(kCoarse, kCoarse, 7);
    const CubicKnots x = kCoarse.refined({1, 0, 1, 1, 0}),
                     y = kCoarse.refined({0, 1, 1, 0, 1}).refined({0, 1, 1, 0, 1, 0, 0, 1});
    const HeightPatch limit{x, y, limits_below_top(x, y, plan, all_faces(plan, 4, top), {}, 0.25)};
    for (double px = 0; px <= 10; px += 0.37)
        for (double py = 0; py <= 10; py += 0.41)
            EXPECT_NEAR(limit.z({px, py}), top.z({px, py}) - 1, 1e-9) << px << " " << py;
}

TEST(ThicknessLimits, keep_any_patch_below_them_under_the_top_everywhere) {
    const TriMesh plan = square_plan();
    std::mt19937_64 random(3);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto top = random_patch(kCoarse, kCoarse, seed);
        const CubicKnots x = kCoarse.refined({1, 1, 0, 0, 1});
        HeightPatch base{x, x, limits_below_top(x, x, plan, all_faces(plan, 0.1, top), {}, 0.2)};
        for (double& c : base.coefficients) c -= std::exponential_distribution<double>(5)(random);
        for (double px = 0; px <= 10; px += 0.09)
            for (double py = 0; py <= 10; py += 0.31)
                ASSERT_LE(base.z({px, py}), top.z({px, py}) - 0.02 + 1e-9) << seed;
    }
}

// Over the half where it is not the top it lies far below the other.
TEST(ThicknessLimits, do_not_follow_a_top_beyond_its_own_triangles) {
    const TriMesh plan = square_plan();
    const auto level = [](const auto& height) {
        HeightPatch patch{kCoarse, kCoarse, {}};
        for (std::size_t i = 0; i < kCoarse.functions(); ++i)
            for (std::size_t j = 0; j < kCoarse.functions(); ++j) patch.coefficients.push_back(height(i));
        return patch;
    };
    const auto steep = level([](std::size_t i) { return i < 4 ? 10.0 : -1000.0; }),
               flat = level([](std::size_t) { return 12.0; });
    std::vector<ThicknessSample> samples;
    double own_lowest = INFINITY;
    for (const auto f : plan.faces()) {
        const double x = plan.calc_face_centroid(f)[0];
        samples.push_back({static_cast<std::uint32_t>(f.idx()), 1, x < 3 ? &steep : &flat});
        if (x < 3)
            for (const auto v : plan.fv_range(f))
                own_lowest = std::min(own_lowest, steep.z({plan.point(v)[0], plan.point(v)[1]}));
    }
    ASSERT_GT(own_lowest, -300);
    const auto limits = limits_below_top(kCoarse, kCoarse, plan, samples, {}, 0.2);
    for (std::size_t k = 0; k < limits.size(); ++k) {
        EXPECT_GE(limits[k], own_lowest - 0.2 - 1e-9) << k;
        EXPECT_LE(limits[k], 12 - 0.2 + 1e-9);
    }
}

TEST(ThicknessLimits, leave_functions_free_that_reach_an_end_or_tops_of_other_breaks) {
    const TriMesh plan = square_plan();
    const auto top = random_patch(kCoarse, kCoarse, 1);
    const auto samples = all_faces(plan, 1, top);
    const Point2 end{5.1, 4.3};
    const auto limits = limits_below_top(kCoarse, kCoarse, plan, samples, {{.at = end}}, 0.2);
    const std::size_t n = kCoarse.functions(), i = kCoarse.span(end.x), j = kCoarse.span(end.y);
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const bool reaches = k / n >= i && k / n < i + 4 && k % n >= j && k % n < j + 4;
        EXPECT_EQ(std::isinf(limits[k]), reaches) << k;
    }
    const auto other = limits_below_top(CubicKnots::uniform(-1, 11, 4), kCoarse, plan, samples, {}, 0.2);
    EXPECT_TRUE(std::isinf(other[3 * n + 3]));
}

}  // namespace
}  // namespace stratareeb
