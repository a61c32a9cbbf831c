// SPDX-License-Identifier: GPL-3.0-or-later
// The command section, its drawings (io/write_section) and files for CAD and GIS (io/write_features).
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/read_table.h"
#include "io/write_features.h"
#include "mesh/analysis.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kHoles =
    "hole,x,y,ground,Sand,Clay\n"
    "A,0,0,10,2,3\nB,100,0,10,2,3\nC,100,100,10,2,3\nD,0,100,10,2,3\nE,50,50,10,2,0\n";

class SectionCommand : public testing::Test {
 protected:
    SectionCommand() {
        folder_.file("holes.csv", kHoles);
        const auto result = run("build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    void expect_failure(const std::string& arguments, int exit_code, const std::string& words) const {
        const auto result = run("section model " + arguments);
        EXPECT_EQ(result.exit_code, exit_code) << arguments;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_NE(result.err.find(words), std::string::npos) << arguments << ": " << result.err;
    }
    TemporaryFolder folder_;
};

TEST_F(SectionCommand, gives_areas_and_polygons) {
    const auto result = run("section model --along 0,0,100,0 --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json section = json::parse(result.out);
    EXPECT_EQ(section["length"], 100.0);
    EXPECT_NEAR(section["envelope_area"].get<double>(), 500, 1e-9);
    EXPECT_NEAR(section["units"][0]["area"].get<double>(), 200, 1e-9);
    EXPECT_NEAR(section["units"][1]["area"].get<double>(), 300, 1e-9);
    EXPECT_EQ(section["units"][0]["polygons"].size(), 1u);
    ASSERT_EQ(section["holes"].size(), 2u);
    EXPECT_EQ(section["holes"][1]["id"], "B");
    EXPECT_EQ(section["holes"][1]["along"], 100.0);
    // Clay is absent at E: two bodies on the diagonal.
    const json diagonal = json::parse(run("section model --through A,E,C --json").out);
    EXPECT_EQ(diagonal["units"][1]["polygons"].size(), 2u);
}

TEST_F(SectionCommand, draws_and_writes_for_cad_and_gis) {
    const std::string outputs = " -o s.svg -o s.pdf -o s.png -o s.dxf -o s.gpkg -o s.geojson";
    const auto result = run("section model --through A,E,C --title Fence" + outputs);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(content_of(folder_ / "s.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(content_of(folder_ / "s.png").substr(1, 3), "PNG");
    EXPECT_NE(content_of(folder_ / "s.svg").find("<svg"), std::string::npos);
    for (const char* name : {"s.dxf", "s.gpkg", "s.geojson"}) {
        GDALAllRegister();
        const std::unique_ptr<GDALDataset, decltype(&GDALClose)> file(
            GDALDataset::Open((folder_ / name).c_str(), GDAL_OF_VECTOR), &GDALClose);
        ASSERT_TRUE(file) << name;
        double areas = 0;
        for (const auto& feature : *file->GetLayer(0)) {
            const auto* geometry = feature->GetGeometryRef();
            if (const auto* polygon = dynamic_cast<const OGRSurface*>(geometry)) areas += polygon->get_Area();
        }
        const json section = json::parse(run("section model --through A,E,C --json").out);
        EXPECT_NEAR(areas, section["envelope_area"].get<double>(), 1e-6) << name;
    }
    EXPECT_EQ(run("section model --through A,E,C --title Fence -o again.svg").exit_code, 0);
    EXPECT_EQ(content_of(folder_ / "again.svg"), content_of(folder_ / "s.svg"));
    expect_failure("--through A,C -o s.svg", 1, "--overwrite");
}

TEST_F(SectionCommand, cuts_at_a_level) {
    const auto result = run("section model --at-z 7.5 --json -o level.svg -o level.gpkg --crs EPSG:27700");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json level = json::parse(result.out);
    EXPECT_EQ(level["units"][0]["area"], 0.0);
    EXPECT_GT(level["units"][1]["area"].get<double>(), 0);
    EXPECT_LT(level["units"][1]["area"].get<double>(), 1e4);  // clay is absent around E
    ASSERT_EQ(level["units"][1]["polygons"].size(), 1u);
    EXPECT_EQ(level["units"][1]["polygons"][0].size(), 2u);  // a ring and the hole in it
    EXPECT_NE(content_of(folder_ / "level.svg").find("<svg"), std::string::npos);
    const json sand = json::parse(run("section model --at-z 9 --json").out);
    EXPECT_NEAR(sand["units"][0]["area"].get<double>(), 1e4, 1e-6);
    expect_failure("--at-z 11", 1, "nothing of the model lies at z = 11");
    expect_failure("--at-z 1 --along 0,0,1,1", 2, "give one of");
}

// Level layers: all that happens is that the clay ends and the sand begins, and the sand ends.
TEST_F(SectionCommand, cuts_at_every_critical_height) {
    GDALAllRegister();
    const auto result = run("section model --critical -o levels.svg -o levels.gpkg --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json levels = json::parse(result.out)["levels"];
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0]["z"], 8.0);
    EXPECT_EQ(levels[1]["z"], 10.0);
    EXPECT_NEAR(levels[1]["units"][0]["area"].get<double>(), 1e4, 1e-6);
    EXPECT_EQ(levels[1]["units"][1]["area"], 0.0);
    EXPECT_TRUE(fs::exists(folder_ / "levels_01.svg"));
    EXPECT_TRUE(fs::exists(folder_ / "levels_02.svg"));
    EXPECT_FALSE(fs::exists(folder_ / "levels_03.svg"));
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> file(
        GDALDataset::Open((folder_ / "levels.gpkg").c_str(), GDAL_OF_VECTOR), &GDALClose);
    ASSERT_TRUE(file);
    std::vector<double> heights;
    for (const auto& feature : *file->GetLayer(0)) {
        heights.push_back(feature->GetFieldAsDouble("z"));
        EXPECT_EQ(feature->GetGeometryRef()->toPolygon()->getExteriorRing()->getZ(0), heights.back());
    }
    EXPECT_EQ(heights, (std::vector<double>{8, 10}));
    expect_failure("--critical -o levels.svg", 1, "levels_01.svg");
}

TEST_F(SectionCommand, writes_the_fence_as_a_mesh) {
    const auto result = run("section model --through A,E,C -o fence.obj -o fence.ply");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string obj = content_of(folder_ / "fence.obj");
    EXPECT_NE(obj.find("Sand"), std::string::npos);
    EXPECT_NE(obj.find("Clay"), std::string::npos);
    const json section = json::parse(run("section model --through A,E,C --json").out);
    EXPECT_NEAR(area(read_mesh(folder_ / "fence.ply")), section["envelope_area"].get<double>(), 1e-9);
    expect_failure("--at-z 9 -o level.obj", 2, "level.obj");
}

TEST_F(SectionCommand, says_what_is_wrong) {
    expect_failure("", 2, "--along x,y,x,y");
    expect_failure("--along 0,0,1", 2, "odd number");
    expect_failure("--along 0,0,1,1 --through A,B", 2, "--along");
    expect_failure("--along 0,0,0,0", 1, "not all the same");
    expect_failure("--along 500,500,600,600", 1, "outside the model's footprint");
    expect_failure("--through A,X", 1, "no borehole 'X'");
    expect_failure("--along 0,0,9,9 -o s.xyz", 2, "s.xyz");
    expect_failure("--along 0,0,9,9 -o nowhere/s.svg", 1, "nowhere/s.svg");
    EXPECT_FALSE(fs::exists(folder_ / "s.xyz"));
}

TEST(WriteFeatures, keeps_holes_heights_and_the_coordinate_system) {
    const TemporaryFolder folder;
    MapFeature area{.kind = MapFeature::Kind::Polygon,
                    .parts = {{{0, 0, 1}, {10, 0, 1}, {10, 10, 1}, {0, 10, 1}},
                              {{2, 2, 1}, {2, 4, 1}, {4, 4, 1}, {4, 2, 1}}},
                    .layer = "clay",
                    .color = "#ff0000",
                    .attributes = {{"unit", "Clay"}, {"order", 2.0}}};
    write_features(folder / "a.gpkg", {area}, {.table = "areas", .crs = "EPSG:27700", .flat = false});
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> file(
        GDALDataset::Open((folder / "a.gpkg").c_str(), GDAL_OF_VECTOR), &GDALClose);
    ASSERT_TRUE(file);
    OGRLayer* layer = file->GetLayerByName("areas");
    ASSERT_NE(layer, nullptr);
    EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "27700");
    const std::unique_ptr<OGRFeature> feature(layer->GetNextFeature());
    EXPECT_STREQ(feature->GetFieldAsString("unit"), "Clay");
    EXPECT_EQ(feature->GetFieldAsDouble("order"), 2);
    const auto* polygon = dynamic_cast<const OGRPolygon*>(feature->GetGeometryRef());
    ASSERT_NE(polygon, nullptr);
    EXPECT_EQ(polygon->get_Area(), 96);
    EXPECT_EQ(polygon->getExteriorRing()->getZ(0), 1);
    EXPECT_THROW(write_features(folder / "b.gpkg", {area}, {.crs = "EPSG:nonsense"}), InvalidInput);
    EXPECT_THROW(write_features(folder / "b.txt", {area}), IoError);
    EXPECT_FALSE(fs::exists(folder / "b.gpkg"));
}

TEST(WriteFeatures, without_a_coordinate_system_are_in_a_plane_not_in_degrees) {
    const TemporaryFolder folder;
    MapFeature line{.kind = MapFeature::Kind::Line,
                    .parts = {{{0, 0, 1}, {744, 60, 1}}},
                    .layer = "fence",
                    .color = "#ff0000",
                    .attributes = {}};
    write_features(folder / "a.gpkg", {line}, {.table = "lines", .crs = "", .flat = true});
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> file(
        GDALDataset::Open((folder / "a.gpkg").c_str(), GDAL_OF_VECTOR), &GDALClose);
    ASSERT_TRUE(file);
    OGRLayer* layer = file->GetLayerByName("lines");
    ASSERT_NE(layer, nullptr);
    EXPECT_EQ(layer->GetFeatureCount(), 1);
    const OGRSpatialReference* reference = layer->GetSpatialRef();
    EXPECT_TRUE(reference == nullptr || !reference->IsGeographic());
    EXPECT_EQ(read_tables((folder / "a.gpkg").string()).at(0).crs, "");  // it states none
}

}  // namespace
}  // namespace stratareeb
