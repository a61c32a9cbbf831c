// SPDX-License-Identifier: GPL-3.0-or-later
// The command grid and io/write_modflow.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "boreholes/random_survey.h"
#include "io/write_modflow.h"
#include "mesh/model_column.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

using nlohmann::json;

TEST(FlowGrid, has_no_gap_no_negative_thickness_and_passes_through_where_units_are_absent) {
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        const Survey survey = random_survey({.holes = 40,
                                             .layers = 5,
                                             .seed = seed,
                                             .corner = {1e5, 2e5},
                                             .truth = seed % 2 ? TruthKind::Lens : TruthKind::Random,
                                             .pinch_outs = true,
                                             .zero_share = 0.3});
        const LayerModel model = build_layer_model(survey);
        const FlowGrid grid = flow_grid(model, grid_over(model, 7.3));
        const ColumnQuery query(model);
        for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
            const double column = static_cast<double>(cell % grid.plan.columns);
            const double row = static_cast<double>(cell / grid.plan.columns);
            const auto found = query.column(
                {grid.plan.north_west.x + (column + 0.5) * 7.3, grid.plan.north_west.y - (row + 0.5) * 7.3});
            for (std::size_t i = 0; i < 5; ++i) {
                const int domain = grid.idomain[i][cell];
                ASSERT_EQ(domain == 0, !found);
                if (!found) continue;
                ASSERT_GE(grid.thickness(i, cell), 0);
                ASSERT_EQ(domain == 1, grid.thickness(i, cell) > 0);
                EXPECT_NEAR(grid.thickness(i, cell), found->thickness(i), 1e-9);
                EXPECT_NEAR(grid.bottom[i][cell], found->horizons[i + 1], 1e-9);
            }
        }
    }
}

TEST(FlowGrid, volumes_converge_to_the_solids) {
    const LayerModel model = build_layer_model(random_survey({.holes = 30, .seed = 7}));
    double last = 1;
    for (const double cell : {20.0, 10.0, 5.0, 2.5}) {
        const FlowGrid grid = flow_grid(model, grid_over(model, cell));
        double volume = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t c = 0; c < grid.cells(); ++c)
                if (grid.idomain[i][c] == 1) volume += grid.thickness(i, c) * cell * cell;
        const double error = std::abs(volume / envelope_volume(model) - 1);
        EXPECT_LT(error, last / 2);
        last = error;
    }
    EXPECT_LT(last, 1e-4);
}

class GridCommand : public testing::Test {
 protected:
    GridCommand() {
        folder_.file("holes.csv",
                     "hole,x,y,ground,Sand,Clay\n"
                     "A,0,0,10,2,3\nB,100,0,10,2,3\nC,100,100,10,2,3\nD,0,100,10,2,3\nE,50,50,10,2,0\n");
        const auto result = run("build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    std::vector<double> numbers(const std::string& name) const {
        std::istringstream text(content_of(folder_ / name));
        std::vector<double> values;
        for (double value = 0; text >> value;) values.push_back(value);
        return values;
    }
    TemporaryFolder folder_;
};

TEST_F(GridCommand, writes_what_modflow_reads) {
    const auto result = run("grid model --cell 10 --modflow flow -o horizons.tif --crs EPSG:27700 --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json grid = json::parse(result.out);
    EXPECT_EQ(grid["columns"], 10);
    EXPECT_EQ(grid["rows"], 10);
    EXPECT_NEAR(grid["layers"][0]["volume"].get<double>(), 2e4, 1e-6);
    EXPECT_EQ(grid["layers"][0]["active_cells"], 100);
    EXPECT_GT(grid["layers"][1]["pass_through_cells"].get<int>(), 4);
    const std::string dis = content_of(folder_ / "flow/model.dis");
    for (const char* words : {"LENGTH_UNITS METERS", "NLAY 2", "NROW 10", "NCOL 10", "XORIGIN 0",
                              "CONSTANT 10", "OPEN/CLOSE botm_02.txt", "OPEN/CLOSE idomain_01.txt"})
        EXPECT_NE(dis.find(words), std::string::npos) << words;
    const auto top = numbers("flow/top.txt"), sand = numbers("flow/botm_01.txt"),
               clay = numbers("flow/botm_02.txt"), active = numbers("flow/idomain_02.txt");
    ASSERT_EQ(top.size(), 100u);
    ASSERT_EQ(clay.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_NEAR(top[i], 10, 1e-12);
        EXPECT_NEAR(sand[i], 8, 1e-12);
        EXPECT_LE(clay[i], sand[i]);
        EXPECT_EQ(active[i], clay[i] < sand[i] ? 1 : -1);
    }
    EXPECT_NE(content_of(folder_ / "flow/layers.csv").find("2,Clay,Clay"), std::string::npos);
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> tif(
        GDALDataset::Open((folder_ / "horizons.tif").c_str(), GDAL_OF_RASTER), &GDALClose);
    ASSERT_TRUE(tif);
    EXPECT_EQ(tif->GetRasterCount(), 3);
    EXPECT_STREQ(tif->GetRasterBand(2)->GetDescription(), "base of Sand");
}

TEST_F(GridCommand, says_what_is_wrong) {
    EXPECT_EQ(run("grid model --cell 10").exit_code, 2);
    EXPECT_EQ(run("grid model --modflow flow").exit_code, 2);
    EXPECT_EQ(run("grid model --cell 0 --modflow flow").exit_code, 2);
    EXPECT_EQ(run("grid model --cell 10 -o grid.txt").exit_code, 2);
    const auto tiny = run("grid model --cell 1e-6 --modflow flow");
    EXPECT_EQ(tiny.exit_code, 1);
    EXPECT_NE(tiny.err.find("give a larger size"), std::string::npos);
    EXPECT_EQ(run("grid model --cell 10 --modflow flow").exit_code, 0);
    EXPECT_EQ(run("grid model --cell 10 --modflow flow").exit_code, 1);  // there already
    EXPECT_EQ(run("grid model --cell 10 --modflow flow --overwrite").exit_code, 0);
}

}  // namespace
}  // namespace stratareeb
