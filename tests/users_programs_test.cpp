// SPDX-License-Identifier: GPL-3.0-or-later
// FreeCAD and MeshLab open what the program writes. Skipped where they are not installed (test.sh installs
// them).
#include "tests/users_programs.h"

#include <gtest/gtest.h>

#include <map>

#include "io/write_mesh.h"
#include "io/write_step.h"
#include "tests/planar_shapes.h"

namespace stratareeb {
namespace {

using test::FreeCadSolid;
using test::TemporaryFolder;

#define REQUIRE_FREECAD() \
    if (!test::has_program("freecadcmd")) GTEST_SKIP() << "no freecadcmd: install freecad-python3"
#define REQUIRE_MESHLAB()                                                      \
    if (!test::has_program("meshlabserver") || !test::has_program("xvfb-run")) \
    GTEST_SKIP() << "no meshlabserver or xvfb-run: install meshlab, xvfb, xauth and libgl1-mesa-dri"

double wavy(double x, double y) {
    return 25 + 3 * std::sin(x / 70) * std::cos(y / 90) + 0.01 * x;
}

std::vector<LayerSolid> three_layers() {
    TriMesh islands;
    test::add_slab(islands, {.n = 3, .size = 100, .top = test::level(-5), .base = test::level(-8)});
    test::add_slab(islands,
                   {.n = 4, .size = 200, .x0 = 500, .top = test::level(-5), .base = test::level(-9)});
    const auto holed = [](int i, int j) { return i < 8 || i > 11 || j < 5 || j > 9; };
    std::vector<LayerSolid> layers;
    layers.push_back({1,
                      0,
                      {"a", "made ground", "#c8a050"},
                      test::slab({.n = 20, .size = 1000, .top = wavy, .has_cell = holed})});
    layers.push_back({2, 0, {"b", "Argile à blocs", "#4060c0"}, islands});
    layers.push_back({3, 0, {"c", "lens", "#40a060"}, test::cone_lens(40, 5, 300, 4, 7)});
    return layers;
}

void expect_sound(const FreeCadSolid& solid, double volume, double unit_mm) {
    SCOPED_TRACE(solid.label);
    EXPECT_EQ(solid.shape_type, "Solid");
    EXPECT_EQ(solid.solids, 1u);
    EXPECT_TRUE(solid.valid);
    EXPECT_TRUE(solid.closed);
    const double expected = volume * std::pow(unit_mm, 3);
    EXPECT_NEAR(solid.volume_mm3, expected, 1e-6 * expected);
}

TEST(UsersPrograms, freecad_opens_our_step_as_valid_closed_solids_of_true_size) {
    REQUIRE_FREECAD();
    const TemporaryFolder folder("freecad");
    const auto layers = three_layers();
    for (const auto& [unit, mm] :
         {std::pair{"m", 1000.0}, {"ft", 304.8}, {"us-ft", 1200.0 / 3937.0 * 1000.0}}) {
        SCOPED_TRACE(unit);
        const auto step = folder.path() / "model.step";
        write_step(step, layers, {.length_unit = unit});
        const auto solids = test::open_in_freecad(step, folder.path());
        ASSERT_EQ(solids.size(), 4u);
        EXPECT_EQ(solids[0].label, "made ground");
        EXPECT_EQ(solids[1].label, "Argile à blocs");
        EXPECT_EQ(solids[2].label, "Argile à blocs, body 2");
        EXPECT_EQ(solids[3].label, "lens");
        expect_sound(solids[0], test::mesh_volume(layers[0].surface), mm);
        expect_sound(solids[1], 100 * 100 * 3, mm);
        expect_sound(solids[2], 200 * 200 * 4, mm);
        expect_sound(solids[3], test::mesh_volume(layers[2].surface), mm);
    }
}

TEST(UsersPrograms, meshlab_opens_our_ply_as_two_manifold_without_holes) {
    REQUIRE_MESHLAB();
    const TemporaryFolder folder("meshlab");
    const auto ply = folder.path() / "layer.ply";
    const int genus[] = {1, 0, 0}, components[] = {1, 2, 1};
    for (const auto& layer : three_layers()) {
        SCOPED_TRACE(layer.unit.name);
        write_mesh(ply, {layer.unit.name, layer.unit.color, &layer.surface});
        const auto report = test::open_in_meshlab(ply, folder.path());
        EXPECT_TRUE(report.two_manifold) << report.output;
        EXPECT_EQ(report.holes, 0);
        EXPECT_EQ(report.genus, genus[layer.order - 1]);
        EXPECT_EQ(report.components, components[layer.order - 1]);
        const double volume = test::mesh_volume(layer.surface);
        EXPECT_NEAR(report.volume.value_or(0), volume, 1e-5 * volume);
    }
}

// One borehole set and what `build` needs to be told of it; paths relative to the source tree.
struct BoreholeSet {
    const char* name;
    const char* arguments;
};

const BoreholeSet kShipped[] = {
    {"sighthill", "examples/sighthill/intervals.csv --collars examples/sighthill/collars.csv"},
    {"thesis_sample3", "examples/thesis_sample3.csv --spacing none"},
};

const BoreholeSet kOthers[] = {
    {"thesis_sample1", "../shared/data/thesis/thesis_sample1_wide_noheader.csv --spacing none"},
    {"thesis_sample2", "../shared/data/thesis/thesis_sample2_wide_noheader.csv --spacing none"},
    {"wigan_depot", "../shared/data/ags_uk/wigan_depot/wide_noheader.csv --spacing none"},
    {"teapot_dome", "../shared/data/teapot_dome/wide_shannon_noheader.csv --unit ft --spacing none"},
    {"louisiana", "../shared/data/louisiana_north/wide_claycap_noheader.csv --spacing none"},
    {"docklands",
     "../shared/data/ags_uk/dlr_city_airport/intervals.csv --collars "
     "../shared/data/ags_uk/dlr_city_airport/collars.csv --spacing none"},
    {"frontier", "../shared/data/teapot_dome/wide_frontier_noheader.csv --unit ft --spacing none"},
    {"bungendore",
     "../shared/data/bungendore/intervals.csv --collars ../shared/data/bungendore/collars.csv --spacing "
     "none"},
};

double millimetres(const std::string& unit) {
    if (unit == "m") return 1000;
    return unit == "ft" ? 304.8 : 1200.0 / 3937.0 * 1000.0;
}

// Bodies and volume of each unit, by its name in the STEP file.
struct Bodies {
    std::size_t count = 0;
    double volume_mm3 = 0;
};

std::map<std::string, Bodies> bodies_of(const std::vector<FreeCadSolid>& solids) {
    std::map<std::string, Bodies> result;
    for (const auto& solid : solids) {
        SCOPED_TRACE(solid.label);
        EXPECT_TRUE(solid.shape_type == "Solid" && solid.solids == 1);
        EXPECT_TRUE(solid.valid);
        EXPECT_TRUE(solid.closed);
        auto& bodies = result[solid.label.substr(0, solid.label.find(", body "))];
        ++bodies.count;
        bodies.volume_mm3 += solid.volume_mm3;
    }
    return result;
}

nlohmann::json build(const BoreholeSet& set, const std::string& formats, const test::fs::path& folder) {
    const auto out = folder / "model";
    const auto outcome =
        test::run(std::string("cd ") + test::quoted(STRATAREEB_SOURCE_DIR) + " && " +
                      test::quoted(STRATAREEB_PROGRAM) + " build " + set.arguments +
                      " --quiet --overwrite --formats " + formats + " -o " + test::quoted(out),
                  folder / "build.log");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return nlohmann::json::parse(test::text_of(out / "model.json"), nullptr, false);
}

void expect_freecad_agrees(const BoreholeSet& set, const std::string& unit) {
    SCOPED_TRACE(set.name);
    const TemporaryFolder folder(std::string("freecad_") + set.name);
    const auto model = build(set, "step", folder.path());
    ASSERT_TRUE(model.contains("units"));
    auto bodies = bodies_of(test::open_in_freecad(folder.path() / "model" / "model.step", folder.path()));
    for (const auto& layer : model["units"]) {
        const auto found = bodies[layer["name"]];
        EXPECT_EQ(found.count, layer["components"].get<std::size_t>()) << layer["name"];
        const double expected = layer["volume"].get<double>() * std::pow(millimetres(unit), 3);
        EXPECT_NEAR(found.volume_mm3, expected, 1e-6 * expected) << layer["name"];
    }
}

// Smooth solids: what `build` promises of them, seen by FreeCAD.
void expect_freecad_agrees_on_smooth(const BoreholeSet& set, const std::string& unit) {
    SCOPED_TRACE(set.name);
    const TemporaryFolder folder(std::string("freecad_smooth_") + set.name);
    const auto model = build(set, "step --step smooth", folder.path());
    ASSERT_TRUE(model.contains("units"));
    for (const auto& warning : model["warnings"])
        EXPECT_EQ(warning.get<std::string>().find("is made of facets"), std::string::npos) << warning;
    const auto solids = test::open_in_freecad(folder.path() / "model" / "model.step", folder.path());
    for (const auto& solid : solids) EXPECT_LE(solid.faces, 60u) << solid.label;
    auto bodies = bodies_of(solids);
    for (const auto& layer : model["units"]) {
        const auto found = bodies[layer["name"]];
        EXPECT_EQ(found.count, layer["components"].get<std::size_t>()) << layer["name"];
        const double expected = layer["volume"].get<double>() * std::pow(millimetres(unit), 3);
        EXPECT_NEAR(found.volume_mm3, expected, 2e-3 * expected) << layer["name"];
    }
}

// MeshLab keeps coordinates in float and prints six decimals: the volume of a thin layer is what that leaves of it.
void expect_meshlab_agrees(const BoreholeSet& set) {
    SCOPED_TRACE(set.name);
    const TemporaryFolder folder(std::string("meshlab_") + set.name);
    const auto model = build(set, "ply", folder.path());
    ASSERT_TRUE(model.contains("units"));
    for (const auto& layer : model["units"]) {
        if (layer["volume"] == 0) continue;
        SCOPED_TRACE(layer["name"].get<std::string>());
        const auto file = folder.path() / "model" / layer["solid"].get<std::string>();
        const auto report = test::open_in_meshlab(file, folder.path());
        EXPECT_TRUE(report.two_manifold) << report.output;
        EXPECT_EQ(report.holes, 0);
        EXPECT_EQ(report.components, layer["components"].get<int>());
        const double volume = layer["volume"];
        EXPECT_NEAR(report.volume.value_or(0), volume, 1e-4 * volume);
    }
}

TEST(UsersPrograms, freecad_agrees_with_build_on_the_shipped_boreholes) {
    REQUIRE_FREECAD();
    for (const auto& set : kShipped) expect_freecad_agrees(set, "m");
}

TEST(UsersPrograms, freecad_opens_smooth_solids_of_the_shipped_boreholes) {
    REQUIRE_FREECAD();
    expect_freecad_agrees_on_smooth({"thesis_sample3", "examples/thesis_sample3.csv --refine 1"}, "m");
}

// Solids of a model in FreeCAD, joined by twos.
struct Joined {
    int pairs = 0, valid = 0;
    double worst = 0;  // how far volumes are off the sum, as a share of it
    std::string output;
};

// \param load Python that makes a list of shapes of it: `parts`
Joined join_neighbours(const TemporaryFolder& folder, const std::string& load) {
    const auto script = folder.path() / "join.py";
    std::ofstream(script) << load << R"(
import os
def faces(part):
    return {face.hashCode() for face in part.Faces}
for i, a in enumerate(parts):
    for b in parts[i + 1:]:
        if share and not faces(a) & faces(b):
            continue
        both = a.fuse(b)
        if share or len(both.Solids) == 1:
            print("\nJOIN", int(both.isValid() and len(both.Solids) == 1),
                  both.Volume / (a.Volume + b.Volume) - 1, flush=True)
os._exit(0)
)";
    const auto outcome =
        test::run("FREECAD_USER_HOME=" + test::quoted(folder.path()) + " freecadcmd " + test::quoted(script),
                  folder.path() / "join.log");
    Joined result;
    result.output = outcome.output;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("JOIN")) continue;
        int valid = 0;
        double off = 1;
        std::istringstream(line.substr(4)) >> valid >> off;
        ++result.pairs;
        result.valid += valid;
        result.worst = std::max(result.worst, std::abs(off));
    }
    return result;
}

std::string python_text(const std::filesystem::path& path) {
    return nlohmann::json(path.string()).dump();
}

// Each two neighbours of smooth layers make one solid of the sum of their volumes.
TEST(UsersPrograms, freecad_joins_smooth_neighbours) {
    REQUIRE_FREECAD();
    const TemporaryFolder folder("freecad_join");
    const auto program = test::quoted(STRATAREEB_PROGRAM), wells = test::quoted(folder.path() / "wells.csv");
    ASSERT_EQ(
        test::run(program + " sample --holes 12 --layers 3 -o " + wells, folder.path() / "log").exit_code, 0);
    const auto built =
        test::run(program + " build " + wells + " --quiet --refine 1 --formats step --step smooth -o " +
                      test::quoted(folder.path() / "model"),
                  folder.path() / "log");
    ASSERT_EQ(built.exit_code, 0) << built.output;
    const Joined joined = join_neighbours(
        folder,
        "import FreeCAD, Import\nImport.insert(" + python_text(folder.path() / "model" / "model.step") +
            ", FreeCAD.newDocument('m').Name, merge=False, useLinkGroup=True)\n"
            "parts = [p.Shape for p in FreeCAD.ActiveDocument.Objects if p.TypeId == 'Part::Feature']\n"
            "share = False\n");
    EXPECT_GE(joined.pairs, 2) << joined.output;
    EXPECT_EQ(joined.valid, joined.pairs) << joined.output;
    EXPECT_LT(joined.worst, 1e-3) << joined.output;
}

// A rough survey with lenses; its bodies have faces in common in the BREP file.
TEST(UsersPrograms, freecad_joins_rough_neighbours_that_share_faces) {
    REQUIRE_FREECAD();
    const TemporaryFolder folder("freecad_join_brep");
    const auto model = build({"thesis_sample3", "examples/thesis_sample3.csv --refine 1 --step smooth"},
                             "brep", folder.path());
    ASSERT_TRUE(model.contains("cad"));
    EXPECT_EQ(model["cad"].size(), 11U);
    const Joined joined =
        join_neighbours(folder, "import Part\nmodel = Part.Shape()\nmodel.read(" +
                                    python_text(folder.path() / "model" / "model.brep") +
                                    ")\nparts = model.Solids\nassert len(parts) == 11\nshare = True\n");
    EXPECT_EQ(joined.pairs, 18) << joined.output;
    EXPECT_EQ(joined.valid, 18) << joined.output;
    EXPECT_LT(joined.worst, 2e-4) << joined.output;
}

TEST(UsersPrograms, meshlab_agrees_with_build_on_the_shipped_boreholes) {
    REQUIRE_MESHLAB();
    for (const auto& set : kShipped) expect_meshlab_agrees(set);
}

TEST(UsersPrograms, freecad_and_meshlab_agree_with_build_on_more_boreholes) {
    REQUIRE_FREECAD();
    REQUIRE_MESHLAB();
    if (!test::fs::exists(STRATAREEB_SOURCE_DIR "/../shared/data")) GTEST_SKIP() << "no ../shared/data";
    for (const auto& set : kOthers) {
        const bool is_in_feet = std::string(set.arguments).find("--unit ft") != std::string::npos;
        expect_freecad_agrees(set, is_in_feet ? "ft" : "m");
        expect_meshlab_agrees(set);
    }
}

}  // namespace
}  // namespace stratareeb
