// SPDX-License-Identifier: GPL-3.0-or-later
// The commands cells (with io/write_vtu and io/write_msh), volume, and voxels (with io/write_voxels).
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/cell_files.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

using nlohmann::json;

//! A square of 100 with 2 of sand everywhere and 3 of clay, which a hole in the middle lacks.
class BuiltModel : public ::testing::Test {
 protected:
    BuiltModel() {
        folder_.file("holes.csv",
                     "hole,x,y,ground,Sand,Clay\n"
                     "A,0,0,10,2,3\nB,100,0,10,2,3\nC,100,100,10,2,3\nD,0,100,10,2,3\nE,50,50,10,2,0\n");
        const auto result = run("build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    double model_volume(std::size_t layer) const {
        const json model = json::parse(content_of(folder_ / "model/model.json"));
        return model["units"][layer]["volume"];
    }
    TemporaryFolder folder_;
};

using CellsCommand = BuiltModel;

TEST_F(CellsCommand, writes_what_others_read) {
    for (const std::string options :
         {"", " --tetrahedra", " --sublayers 2", " --tetrahedra --max-thickness 1"}) {
        const auto result = run("cells model -o cells.vtu -o cells.msh --json --overwrite" + options);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const json report = json::parse(result.out);
        EXPECT_LT(report["volume_error"].get<double>(), 1e-12);
        const auto vtu = testing::read_vtu(content_of(folder_ / "cells.vtu"));
        const auto msh = testing::read_msh(content_of(folder_ / "cells.msh"));
        ASSERT_EQ(vtu.cells.size(), report["cells"]);
        ASSERT_EQ(msh.cells.size(), report["cells"]);
        EXPECT_EQ(vtu.points, msh.points);
        EXPECT_EQ(msh.faces.size(), report["outer_faces"]);
        EXPECT_EQ(msh.groups, (std::vector<std::string>{"2 3 \"ground\"", "2 4 \"base\"", "2 5 \"sides\"",
                                                        "3 1 \"Sand\"", "3 2 \"Clay\""}));
        std::map<int, double> volume;
        for (std::size_t i = 0; i < msh.cells.size(); ++i) {
            const double v = testing::volume(msh, msh.cells[i].nodes);
            EXPECT_GT(v, 0);
            volume[msh.cells[i].layer] += v;
            EXPECT_NEAR(vtu.data.at("volume")[i], v, 1e-9);
            EXPECT_EQ(vtu.data.at("MaterialIDs")[i] + 1, vtu.cells[i].layer);
            // VTK's prism starts with the upper triangle.
            auto nodes = vtu.cells[i].nodes;
            if (nodes.size() == 6) std::rotate(nodes.begin(), nodes.begin() + 3, nodes.end());
            EXPECT_EQ(nodes, msh.cells[i].nodes);
            EXPECT_EQ(vtu.cells[i].layer, msh.cells[i].layer);
            EXPECT_EQ(vtu.cells[i].type, nodes.size() == 4 ? 10 : nodes.size() == 5 ? 14 : 13);
        }
        EXPECT_NEAR(volume[1], model_volume(0), 1e-9 * 5e4);
        EXPECT_NEAR(volume[2], model_volume(1), 1e-9 * 5e4);
        double ground = 0;
        for (const auto& face : msh.faces)
            if (face.layer == 3) {
                const auto &a = msh.points[face.nodes[0]], &b = msh.points[face.nodes[1]],
                           &c = msh.points[face.nodes[2]];
                ground += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
            }
        EXPECT_NEAR(ground, 1e4, 1e-6);
    }
}

TEST_F(CellsCommand, says_what_is_wrong) {
    EXPECT_EQ(run("cells model").exit_code, 2);
    EXPECT_EQ(run("cells model -o cells.vtk").exit_code, 2);
    EXPECT_EQ(run("cells model -o cells.vtu --sublayers 0").exit_code, 2);
    EXPECT_EQ(run("cells nothing -o cells.vtu").exit_code, 1);
    EXPECT_EQ(run("cells model -o nowhere/cells.vtu").exit_code, 1);
    EXPECT_EQ(run("cells model -o cells.vtu").exit_code, 0);
    const auto again = run("cells model -o cells.vtu");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
    const auto thin = run("cells model -o thin.vtu --min-thickness 1");
    EXPECT_EQ(thin.exit_code, 0) << thin.err;
    EXPECT_NE(thin.out.find("in the model"), std::string::npos);
}

using VolumeCommand = BuiltModel;

TEST_F(VolumeCommand, adds_up_over_windows) {
    const auto volumes = [&](const std::string& options) {
        const auto result = run("volume model --json " + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const json report = json::parse(result.out);
        return std::array<double, 3>{report["layers"][0]["volume"], report["layers"][1]["volume"],
                                     report["plan_area"]};
    };
    const auto all = volumes("");
    EXPECT_NEAR(all[0], 2e4, 1e-6);
    EXPECT_NEAR(all[1], model_volume(1), 1e-6);
    EXPECT_NEAR(all[2], 1e4, 1e-6);
    const auto upper = volumes("--between 7,10"), lower = volumes("--between 0,7"),
               deep = volumes("--below-ground 3,10");
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(upper[i] + lower[i], all[i], 1e-6);
        EXPECT_NEAR(lower[i], deep[i], 1e-6);  // the ground is level, at 10
    }
    folder_.file("west.csv", "x,y\n-5,-5\n40,-5\n40,105\n-5,105\n");
    EXPECT_NEAR(volumes("--inside west.csv")[0], 8e3, 1e-6);
    EXPECT_NEAR(volumes("--inside west.csv --between 9,20")[0], 4e3, 1e-6);
}

TEST_F(VolumeCommand, prints_a_table_with_uncertainty_and_says_what_is_wrong) {
    const auto result = run("volume model");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("± (95 %)"), std::string::npos) << result.out;
    EXPECT_EQ(run("volume model --no-uncertainty").out.find("±"), std::string::npos);
    EXPECT_EQ(run("volume model --between 3").exit_code, 2);
    EXPECT_EQ(run("volume model --between 1,2 --below-ground 1,2").exit_code, 2);
    EXPECT_EQ(run("volume model --between 2,1").exit_code, 1);
    EXPECT_EQ(run("volume model --inside nothing.gpkg").exit_code, 1);
    folder_.file("far.csv", "x,y\n500,500\n600,500\n600,600\n");
    const auto far = run("volume model --inside far.csv");
    EXPECT_EQ(far.exit_code, 1);
    EXPECT_NE(far.err.find("outside the model's footprint"), std::string::npos) << far.err;
}

using VoxelsCommand = BuiltModel;

TEST_F(VoxelsCommand, writes_the_same_block_as_netcdf_and_geotiff) {
    for (const char* file : {"block.nc", "block.tif"}) {
        const auto result =
            run(std::string("voxels model --cell 10 --height 0.5 --crs EPSG:27700 --json -o ") + file);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const json block = json::parse(result.out);
        EXPECT_EQ(block["levels"], 10);
        EXPECT_EQ(block["layers"][0]["cells"], 400);
        EXPECT_NEAR(block["layers"][0]["error"].get<double>(), 0, 1e-6);
    }
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> tif(
        GDALDataset::Open((folder_ / "block.tif").c_str(), GDAL_OF_RASTER), &GDALClose);
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> nc(
        GDALDataset::Open((folder_ / "block.nc").c_str(), GDAL_OF_MULTIDIM_RASTER), &GDALClose);
    ASSERT_TRUE(tif);
    ASSERT_TRUE(nc);
    ASSERT_EQ(tif->GetRasterCount(), 10);
    EXPECT_STREQ(tif->GetRasterBand(1)->GetDescription(), "z 9.75");
    EXPECT_STREQ(tif->GetMetadataItem("UNIT_2"), "Clay");
    EXPECT_TRUE(tif->GetSpatialRef());
    const auto unit = nc->GetRootGroup()->OpenMDArray("unit");
    ASSERT_TRUE(unit);
    EXPECT_TRUE(unit->GetSpatialRef());
    EXPECT_STREQ(unit->GetAttribute("flag_meanings")->ReadAsString(), "none Sand Clay");
    EXPECT_EQ(unit->GetAttribute("flag_values")->ReadAsIntArray(), (std::vector<int>{0, 1, 2}));
    double z[10], y[10];
    const GUInt64 zero[3] = {0, 0, 0};
    const std::size_t ten = 10, all[3] = {10, 10, 10};
    const auto real = GDALExtendedDataType::Create(GDT_Float64),
               number = GDALExtendedDataType::Create(GDT_UInt16);
    ASSERT_TRUE(nc->GetRootGroup()->OpenMDArray("z")->Read(zero, &ten, nullptr, nullptr, real, z));
    ASSERT_TRUE(nc->GetRootGroup()->OpenMDArray("y")->Read(zero, &ten, nullptr, nullptr, real, y));
    EXPECT_EQ(z[0], 5.25);
    EXPECT_EQ(z[9], 9.75);
    EXPECT_EQ(y[0], 5);
    std::vector<std::uint16_t> units(1000), band(100);
    ASSERT_TRUE(unit->Read(zero, all, nullptr, nullptr, number, units.data()));
    for (std::size_t b = 0; b < 10; ++b) {
        ASSERT_EQ(tif->GetRasterBand(static_cast<int>(b) + 1)
                      ->RasterIO(GF_Read, 0, 0, 10, 10, band.data(), 10, 10, GDT_UInt16, 0, 0, nullptr),
                  CE_None);
        for (std::size_t row = 0; row < 10; ++row)
            for (std::size_t column = 0; column < 10; ++column) {
                const auto found = band[row * 10 + column];
                EXPECT_EQ(found, units[((9 - b) * 10 + 9 - row) * 10 + column]);
                if (b < 4) {
                    EXPECT_EQ(found, 1);  // 2 of sand
                } else {
                    EXPECT_NE(found, 1);
                }
            }
    }
    EXPECT_EQ(std::ranges::count(units, 2) > 100, true);
}

TEST_F(VoxelsCommand, says_what_is_wrong) {
    EXPECT_EQ(run("voxels model -o block.nc").exit_code, 2);
    EXPECT_EQ(run("voxels model --cell 10 -o block.vti").exit_code, 2);
    EXPECT_EQ(run("voxels model --cell 1e-4 -o block.nc").exit_code, 1);
    EXPECT_EQ(run("voxels model --cell 10 -o block.nc --crs nonsense").exit_code, 1);
    EXPECT_EQ(run("voxels model --cell 10 -o nowhere/block.nc").exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "block.nc"));
    EXPECT_EQ(run("voxels model --cell 10 -o block.nc").exit_code, 0);
    EXPECT_EQ(run("voxels model --cell 10 -o block.nc").exit_code, 1);
}

}  // namespace
}  // namespace stratareeb
