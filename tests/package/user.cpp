// SPDX-License-Identifier: GPL-3.0-or-later
// Boreholes in a slab 6 thick under a square of 300 × 300: the solid's volume must be 540,000, in memory and
// in the file.
#include <cmath>
#include <cstdio>

#include "boreholes/random_survey.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "mesh/layer_model.h"

int main() {
    using namespace stratareeb;
    const Survey survey = random_survey(
        {.layers = 1, .extent = 300, .thickness = 6, .truth = TruthKind::Slab, .corners = true});
    const LayerSolid solid = build_layer_solid(build_layer_model(survey), 0);
    write_mesh("user.ply", {.name = "slab", .mesh = &solid.surface});
    const MeshReport report = analyze(read_mesh("user.ply"));
    std::printf("volume %.9f, watertight %d\n", report.volume, report.watertight);
    return report.watertight && std::abs(report.volume / 540000 - 1) < 1e-9 ? 0 : 1;
}
