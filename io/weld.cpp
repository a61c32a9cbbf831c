// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/weld.h"

#include <bit>
#include <limits>

namespace stratareeb {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mixed(std::uint64_t h) {
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93u;
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93u;
    return h ^ (h >> 32);
}

// Adding 0 turns -0 into 0, so that equal numbers have equal bits.
std::uint64_t hash(const Point3& p) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
    return mixed(mixed(mixed(bits(p.x)) + bits(p.y)) + bits(p.z));
}

}  // namespace

void weld(TriangleSoup& soup) {
    const std::uint64_t mask = std::bit_ceil(2 * soup.points.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, kFree);
    std::vector<std::uint32_t> number(soup.points.size());
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
        const auto p = soup.points[v];
        auto slot = hash(p) & mask;
        while (table[slot] != kFree && !(soup.points[table[slot]] == p)) slot = (slot + 1) & mask;
        if (table[slot] == kFree) {
            table[slot] = kept;
            soup.points[kept++] = p;
        }
        number[v] = table[slot];
    }
    soup.points.resize(kept);
    for (auto& triangle : soup.triangles)
        for (auto& v : triangle) v = number[v];
}

}  // namespace stratareeb
