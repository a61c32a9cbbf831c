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
    const double needed = estimated_memory(plan_triangles, layers, all_solids), free = available_memory();
    if (needed <= free) return;
    throw InvalidInput(fmt::format(
        "about {:.2g} million plan triangles in {} layers need {:.1f} GiB of memory, {:.1f} GiB are free "
        "(give a larger --spacing, fewer --formats, or --ignore-memory to try all the same)",
        plan_triangles / 1e6, layers, needed / kGiB, free / kGiB));
}

}  // namespace stratareeb
