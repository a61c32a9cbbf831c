// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/memory_guard.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr double kGiB = 1024.0 * 1024 * 1024;

//! Free memory in bytes; swap is not counted, a build in swap never ends.
double available_memory() {
    std::ifstream info("/proc/meminfo");
    std::string key, unit;
    for (double kilobytes = 0; info >> key >> kilobytes; std::getline(info, unit))
        if (key == "MemAvailable:") return kilobytes * 1024;
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void require_free(double needed, const std::string& what, const char* way_out) {
    const double free = available_memory();
    if (needed <= free) return;
    throw InvalidInput(fmt::format(
        "{} need {:.1f} GiB of memory, {:.1f} GiB are free ({}, or --ignore-memory to try all the same)",
        what, needed / kGiB, free / kGiB, way_out));
}

}  // namespace

double estimated_memory(double plan_triangles, std::size_t layers, bool all_solids) {
    // Measured on 0.1 to 2 million plan triangles in 10 layers, with and without all solids held: plan and fields, the
    // solids that are held, and the checks of one of them.
    constexpr double kPlanBytes = 350, kFieldBytes = 12, kSolidBytes = 260, kCheckBytes = 400;
    const double solids = all_solids ? static_cast<double>(layers) : 1;
    return plan_triangles *
           (kPlanBytes + kFieldBytes * static_cast<double>(layers) + kSolidBytes * solids + kCheckBytes);
}

void check_memory(double plan_triangles, std::size_t layers, bool all_solids) {
    require_free(
        estimated_memory(plan_triangles, layers, all_solids),
        fmt::format("about {:.2g} million plan triangles in {} layers", plan_triangles / 1e6, layers),
        "give a larger --spacing, fewer --formats");
}

double estimated_refine_memory(double faces, bool are_quads) {
    // Measured on 0.3 to 17 million faces: OpenSubdiv's tables of all levels, points, normals and faces, and the copy that is written.
    constexpr double kTriangleBytes = 300, kQuadBytes = 430;
    return faces * (are_quads ? kQuadBytes : kTriangleBytes);
}

bool has_refine_memory(double faces, bool are_quads) {
    return estimated_refine_memory(faces, are_quads) <= available_memory();
}

void check_refine_memory(double faces, bool are_quads) {
    require_free(estimated_refine_memory(faces, are_quads),
                 fmt::format("about {:.3g} million faces", faces / 1e6), "give fewer --levels or --adaptive");
}

}  // namespace stratareeb
