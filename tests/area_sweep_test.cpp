// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/area_sweep.h"

#include <gtest/gtest.h>

#include "tests/band_cases.h"

namespace stratareeb {
namespace {

using namespace band_cases;

constexpr std::size_t kSize = 60;

struct Coordinates {
    std::array<std::vector<double>, 3> axes;
    explicit Coordinates(std::mt19937& random) {
        std::uniform_int_distribution<int> integer(-3, 3);
        for (auto& axis : axes)
            for (std::size_t i = 0; i < kSize; ++i) axis.push_back(integer(random));
    }
    operator Axes() const { return {axes[0].data(), axes[1].data(), axes[2].data()}; }
    Point3 at(std::size_t i) const { return {axes[0][i], axes[1][i], axes[2][i]}; }
};

//! Half the edge and the span as triangle: from the origin to the whole edge and to the span.
double expected_area(const Coordinates& half_edge, const Coordinates& from, const Coordinates& to,
                     std::size_t i) {
    const Point3 e = half_edge.at(i), a = from.at(i), b = to.at(i);
    return triangle_area({}, {2 * e.x, 2 * e.y, 2 * e.z}, {b.x - a.x, b.y - a.y, b.z - a.z});
}

TEST(AreaSweep, takes_the_cheaper_of_two_triangles_for_any_number_of_spans) {
    std::mt19937 random(1);
    for (std::size_t count = 0; count + kSweepPadding <= kSize; ++count) {
        const Coordinates up_edge(random), low_edge(random), upper(random), lower(random);
        std::vector<double> up_from(kSize), low_from(kSize), to(kSize, -1);
        for (std::size_t i = 0; i < kSize; ++i)
            up_from[i] = double(random() % 9), low_from[i] = double(random() % 9);
        std::vector<std::uint8_t> steps(kSize);
        const HalfEdgesAndSpans up{up_edge, upper, lower}, low{low_edge, upper, lower};
        relax_areas(up, low, up_from.data(), low_from.data(), static_cast<std::ptrdiff_t>(count), to.data(),
                    steps.data());
        for (std::size_t i = 0; i < count; ++i) {
            const double a = up_from[i] + expected_area(up_edge, upper, lower, i);
            const double b = low_from[i] + expected_area(low_edge, upper, lower, i);
            EXPECT_NEAR(to[i], std::min(a, b), 1e-12);
            if (std::abs(a - b) > 1e-12) {
                EXPECT_EQ(steps[i / 8] >> (i % 8) & 1, b < a);
            }
        }
        if (count > 0) {
            EXPECT_NEAR(triangle_area(up), expected_area(up_edge, upper, lower, 0), 1e-12);
        }
    }
}

//! All sizes of rest, wherever in memory a span stands: the same sum to the last bit.
TEST(AreaSweep, is_the_same_to_the_last_bit_at_any_place_of_a_sweep) {
    std::mt19937 random(2);
    const auto values = [&] {
        std::array<std::vector<double>, 3> axes;
        std::normal_distribution<double> normal;
        for (auto& axis : axes)
            for (std::size_t i = 0; i < kSize; ++i) axis.push_back(normal(random));
        return axes;
    };
    const auto e = values(), u = values(), l = values();
    const auto at = [](const auto& axes, std::ptrdiff_t i) {
        return Axes{axes[0].data() + i, axes[1].data() + i, axes[2].data() + i};
    };
    const std::vector<double> from(kSize, 0);
    for (std::ptrdiff_t first = 0; first < 20; ++first)
        for (std::ptrdiff_t count = 1; count < 20; ++count) {
            std::vector<double> to(kSize);
            const HalfEdgesAndSpans spans{at(e, first), at(u, first), at(l, first)};
            relax_areas(spans, spans, from.data(), from.data(), count, to.data(), nullptr);
            for (std::ptrdiff_t i = 0; i < count; ++i)
                EXPECT_EQ(
                    to[static_cast<std::size_t>(i)],
                    triangle_area(HalfEdgesAndSpans{at(e, first + i), at(u, first + i), at(l, first + i)}));
        }
}

}  // namespace
}  // namespace stratareeb
