// SPDX-License-Identifier: GPL-3.0-or-later
// FreeCAD and MeshLab open the solids of a model with faults. Skipped where they are not installed.
#include <gtest/gtest.h>

#include <map>

#include "io/read_boreholes.h"
#include "io/read_faults.h"
#include "io/write_mesh.h"
#include "io/write_step.h"
#include "mesh/faulted_model.h"
#include "tests/planar_shapes.h"
#include "tests/users_programs.h"

namespace stratareeb {
namespace {

//! The shipped graben, coarse, since CAD programs take their time with facets.
std::vector<LayerSolid> graben_solids() {
    const std::string graben = STRATAREEB_SOURCE_DIR "/examples/graben/";
    LayerModelOptions options;
    options.spacing = 250;
    const LayerModel model = build_faulted_model(read_boreholes({graben + "holes.csv"}).survey,
                                                 read_faults(graben + "faults.geojson"), options);
    std::vector<LayerSolid> solids;
    for (std::size_t i = 0; i < model.units.size(); ++i)
        for (LayerSolid& solid : build_block_solids(model, i)) solids.push_back(std::move(solid));
    return solids;
}

TEST(FaultedUsersPrograms, freecad_opens_a_graben_as_valid_closed_solids) {
    if (!test::has_program("freecadcmd")) GTEST_SKIP() << "no freecadcmd: install freecad-python3";
    const test::TemporaryFolder folder("freecad_faults");
    const auto solids = graben_solids();
    ASSERT_EQ(solids.size(), 12u);  // four layers in three blocks
    const auto step = folder.path() / "graben.step";
    write_step(step, solids, {.length_unit = "m"});
    double expected = 0, found = 0;
    for (const LayerSolid& solid : solids) expected += test::mesh_volume(solid.surface);
    const auto opened = test::open_in_freecad(step, folder.path());
    ASSERT_EQ(opened.size(), 12u);
    for (const auto& solid : opened) {
        EXPECT_EQ(solid.shape_type, "Solid") << solid.label;
        EXPECT_TRUE(solid.valid) << solid.label;
        EXPECT_TRUE(solid.closed) << solid.label;
        found += solid.volume_mm3 / 1e9;
    }
    EXPECT_NEAR(found, expected, 1e-6 * expected);
}

TEST(FaultedUsersPrograms, meshlab_opens_the_solids_of_a_graben_as_two_manifold_without_holes) {
    if (!test::has_program("meshlabserver") || !test::has_program("xvfb-run"))
        GTEST_SKIP() << "no meshlabserver or xvfb-run: install meshlab, xvfb, xauth and libgl1-mesa-dri";
    const test::TemporaryFolder folder("meshlab_faults");
    const auto ply = folder.path() / "solid.ply";
    std::size_t number = 0;
    for (const LayerSolid& solid : graben_solids()) {
        if (number++ % 4 != 0) continue;  // one of each block; each run starts the program anew
        write_mesh(ply, {solid.unit.name, solid.unit.color, &solid.surface});
        const auto report = test::open_in_meshlab(ply, folder.path());
        EXPECT_TRUE(report.two_manifold) << report.output;
        EXPECT_EQ(report.holes, 0);
        EXPECT_EQ(report.genus, 0);
        const double volume = test::mesh_volume(solid.surface);
        EXPECT_NEAR(report.volume.value_or(0), volume, 1e-5 * volume);
    }
}

}  // namespace
}  // namespace stratareeb
