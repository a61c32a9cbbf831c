// SPDX-License-Identifier: GPL-3.0-or-later
// The command map and what it stands on: mesh/plan_areas, mesh/model_grid, io/model_maps, io/write_plan_map, io/write_grid.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/model_maps.h"
#include "io/write_grid.h"
#include "mesh/model_column.h"
#include "mesh/model_grid.h"
#include "mesh/plan_areas.h"
#include "mesh/ring_stitching.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Dataset = std::unique_ptr<GDALDataset, decltype(&GDALClose)>;

LayerModel random_model(std::uint64_t seed, Point2 corner = {}) {
    return build_layer_model(random_survey({.holes = 40,
                                            .layers = 5,
                                            .seed = seed,
                                            .corner = corner,
                                            .truth = TruthKind::Lens,
                                            .pinch_outs = true,
                                            .zero_share = 0.3}));
}

double area_of(const std::vector<std::vector<Point2>>& rings) {
    double sum = 0;
    for (const auto& ring : rings) sum += ring_area(ring);
    return sum;
}

TEST(PlanAreas, units_at_the_ground_tile_the_plan) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const LayerModel model = random_model(seed, {1e5, 2e5});
        double sum = 0;
        for (const PlanArea& part : geological_map(model)) {
            EXPECT_GT(ring_area(part.rings[0]), 0);
            for (std::size_t i = 1; i < part.rings.size(); ++i) EXPECT_LT(ring_area(part.rings[i]), 0);
            sum += area_of(part.rings);
        }
        const auto bare = plan_areas(model, [&](std::size_t face) {
            return model.regions.in_face[face].none() ? std::size_t{0} : kNoLabel;
        });
        for (const PlanArea& part : bare) sum += area_of(part.rings);
        EXPECT_NEAR(sum, 9e4, 1e-5);
        EXPECT_NEAR(area_of(plan_outline(model)), 9e4, 1e-5);
    }
}

TEST(ContourLines, of_what_is_the_same_everywhere_but_for_rounding_are_none) {
    LayerModel model = random_model(3);
    auto& ground = model.horizons[0];
    for (std::size_t v = 0; v < ground.size(); ++v) ground[v] = 1000 + 1e-12 * static_cast<double>(v % 7);
    EXPECT_EQ(suitable_interval(ground, {}), 1);
    EXPECT_TRUE(contour_lines(model, MapSubject::Ground, 0, 1).empty());
    EXPECT_TRUE(contour_lines(model, MapSubject::Ground, 0, 2e-13).empty());
}

TEST(PlanAreas, the_topmost_unit_is_the_one_of_the_column) {
    const LayerModel model = random_model(3);
    const auto areas = geological_map(model);
    const ColumnQuery query(model);
    for (double x = 1.7; x < 300; x += 7.9)
        for (double y = 2.3; y < 300; y += 8.3) {
            const auto column = query.column({x, y});
            ASSERT_TRUE(column);
            std::size_t top = 0;
            while (top < 5 && column->thickness(top) == 0) ++top;
            std::vector<std::size_t> found;
            for (const PlanArea& part : areas)
                if (is_inside(part.rings, {x, y})) found.push_back(part.label);
            if (top == 5)
                EXPECT_EQ(found, std::vector<std::size_t>{});
            else
                EXPECT_EQ(found, std::vector{top});
        }
}

TEST(ModelMaps, lines_lie_at_their_value) {
    const LayerModel model = random_model(2, {5e6, 4.9e6});
    const ColumnQuery query(model);
    std::size_t lines_seen = 0;
    for (const MapSubject subject :
         {MapSubject::Ground, MapSubject::Top, MapSubject::Base, MapSubject::Thickness})
        for (std::size_t layer = 0; layer < 5; ++layer) {
            const auto lines = contour_lines(model, subject, layer, 0.7);
            lines_seen += lines.size();
            for (const ContourLine& line : lines) {
                EXPECT_NEAR(line.value / 0.7, std::round(line.value / 0.7), 1e-9);
                for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
                    const Point2 &a = line.points[i], &b = line.points[i + 1];
                    const auto column = query.column({(a.x + b.x) / 2, (a.y + b.y) / 2});
                    if (!column) continue;  // off the outline by rounding
                    const double value = subject == MapSubject::Ground      ? column->horizons[0]
                                         : subject == MapSubject::Thickness ? column->thickness(layer)
                                         : subject == MapSubject::Base      ? column->horizons[layer + 1]
                                                                            : column->horizons[layer];
                    EXPECT_NEAR(value, line.value, 1e-5);
                }
            }
        }
    EXPECT_GT(lines_seen, 30u);
    EXPECT_THROW(contour_lines(model, MapSubject::Thickness, 0, 0), InvalidInput);
    EXPECT_THROW(contour_lines(model, MapSubject::Thickness, 0, 1e-9), InvalidInput);
}

TEST(ModelGrid, cells_have_the_values_of_columns) {
    const LayerModel model = random_model(4, {1000, 2000});
    const PlanGrid grid = grid_over(model, 3.1);
    const auto values = rasterized(model, grid, {&model.horizons[0], &model.horizons[3]});
    const ColumnQuery query(model);
    std::size_t inside = 0;
    for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
            const Point2 p{grid.north_west.x + (static_cast<double>(column) + 0.5) * 3.1,
                           grid.north_west.y - (static_cast<double>(row) + 0.5) * 3.1};
            const auto found = query.column(p);
            const double value = values[0][row * grid.columns + column];
            ASSERT_EQ(found.has_value(), !std::isnan(value)) << p.x << ", " << p.y;
            if (!found) continue;
            ++inside;
            EXPECT_NEAR(value + model.origin.z, found->horizons[0], 1e-9);
            EXPECT_NEAR(values[1][row * grid.columns + column] + model.origin.z, found->horizons[3], 1e-9);
        }
    EXPECT_NEAR(static_cast<double>(inside) * 3.1 * 3.1, 9e4, 3e3);
    EXPECT_THROW(grid_over(model, 0), InvalidInput);
    EXPECT_THROW(grid_over(model, 1e-6), InvalidInput);
}

TEST(WriteGrid, reads_back_with_place_values_and_reference) {
    const TemporaryFolder folder;
    GDALAllRegister();
    const Grid grid{.north_west = {500000, 200000},
                    .cell = 2.5,
                    .columns = 3,
                    .rows = 2,
                    .bands = {{"depth", {1.1, 2.2, std::nan(""), 4.4, -5.5, 1.0 / 3}}}};
    for (const char* name : {"g.tif", "g.asc"}) {
        write_grid(folder / name, grid, "EPSG:27700");
        const Dataset file(GDALDataset::Open((folder / name).c_str(), GDAL_OF_RASTER), &GDALClose);
        ASSERT_TRUE(file) << name;
        double transform[6];
        ASSERT_EQ(file->GetGeoTransform(transform), CE_None);
        EXPECT_EQ(transform[0], 500000);
        EXPECT_EQ(transform[3], 200000);
        EXPECT_EQ(transform[1], 2.5);
        EXPECT_EQ(transform[5], -2.5);
        std::vector<double> values(6);
        GDALRasterBand* band = file->GetRasterBand(1);
        ASSERT_EQ(band->RasterIO(GF_Read, 0, 0, 3, 2, values.data(), 3, 2, GDT_Float64, 0, 0, nullptr),
                  CE_None);
        EXPECT_EQ(values[2], band->GetNoDataValue());
        EXPECT_NEAR(values[5], 1.0 / 3, std::string(name) == "g.tif" ? 0 : 1e-6);
        if (std::string(name) == "g.tif") {
            EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "27700");
        }
    }
    EXPECT_THROW(write_grid(folder / "g.xyz", grid), IoError);
    EXPECT_THROW(write_grid(folder / "h.tif", grid, "nonsense"), InvalidInput);
    EXPECT_FALSE(fs::exists(folder / "h.tif"));
}

class MapCommand : public testing::Test {
 protected:
    MapCommand() {
        GDALAllRegister();
        folder_.file("holes.csv",
                     "hole,x,y,ground,Sand,Clay\n"
                     "A,0,0,10,0,3\nB,100,0,10,2,3\nC,100,100,12,2,3\nD,0,100,10,2,3\nE,50,50,10,2,0\n");
        const auto result = run("build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    void expect_failure(const std::string& arguments, int exit_code, const std::string& words) const {
        const auto result = run("map model " + arguments);
        EXPECT_EQ(result.exit_code, exit_code) << arguments;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_NE(result.err.find(words), std::string::npos) << arguments << ": " << result.err;
    }
    TemporaryFolder folder_;
};

TEST_F(MapCommand, writes_every_kind_of_map_in_every_format) {
    for (const std::string show : {"--show geology", "--show ground", "--show top --unit Clay",
                                   "--show base --unit 1", "--show thickness --unit Clay"}) {
        std::string outputs;
        for (const char* extension : {"svg", "pdf", "png", "gpkg", "dxf", "geojson", "tif", "asc"})
            outputs += std::string(" -o map.") + extension;
        const auto result = run("map model --overwrite --json " + show + outputs);
        ASSERT_EQ(result.exit_code, 0) << show << result.err;
        const json map = json::parse(result.out);
        EXPECT_TRUE(map.contains(show == "--show geology" ? "units" : "lines")) << show;
        const Dataset grid(GDALDataset::Open((folder_ / "map.tif").c_str(), GDAL_OF_RASTER), &GDALClose);
        ASSERT_TRUE(grid) << show;
        EXPECT_GE(grid->GetRasterXSize(), 500) << show;
    }
    const json areas = json::parse(run("map model --json").out);
    EXPECT_NEAR(areas["units"][0]["area"].get<double>() + areas["units"][1]["area"].get<double>(), 1e4, 1e-6);
    EXPECT_GT(areas["units"][1]["area"].get<double>(), 0);  // clay crops out around A
}

TEST_F(MapCommand, says_what_is_wrong) {
    expect_failure("--show top", 2, "--unit");
    expect_failure("--unit Clay", 2, "--unit");
    expect_failure("--show top --unit Chalk", 1, "no unit 'Chalk'; it has Sand, Clay");
    expect_failure("--show weather", 2, "weather");
    expect_failure("-o map.doc", 2, "map.doc");
    expect_failure("--show ground --interval 1e-9", 1, "give a larger one");
    expect_failure("--interval -1", 2, "--interval");
    expect_failure("-o map.gpkg --crs EPSG:nonsense", 1, "EPSG:nonsense");
    EXPECT_FALSE(fs::exists(folder_ / "map.gpkg"));
    folder_.file("there.svg", "mine");
    expect_failure("-o there.svg", 1, "--overwrite");
    EXPECT_EQ(content_of(folder_ / "there.svg"), "mine");
}

std::vector<double> values_of(const fs::path& file) {
    const Dataset grid(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER), &GDALClose);
    EXPECT_TRUE(grid) << file;
    EXPECT_STREQ(grid->GetSpatialRef()->GetAuthorityCode(nullptr), "27700");
    const int columns = grid->GetRasterXSize(), rows = grid->GetRasterYSize();
    std::vector<double> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    EXPECT_EQ(grid->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows,
                                               GDT_Float64, 0, 0, nullptr),
              CE_None);
    return values;
}

TEST_F(MapCommand, says_how_far_off_it_may_be_in_the_models_own_reference_system) {
    ASSERT_EQ(run("sample -o wells.csv --holes 40 --seed 3").exit_code, 0);
    ASSERT_EQ(run("build wells.csv -o wells --quiet --refine 0 --crs EPSG:27700").exit_code, 0);
    const auto map = [&](const std::string& kind) {
        const auto result = run("map wells --show thickness --unit 2 --cell 5 --uncertainty " + kind +
                                " --json -o " + kind + ".tif -o " + kind + ".svg -o " + kind + ".gpkg");
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(json::parse(result.out)["uncertainty"], kind);
        return values_of(folder_ / (kind + ".tif"));
    };
    const auto deviation = map("deviation"), interval = map("interval");
    ASSERT_EQ(deviation.size(), interval.size());
    double wider = 0, cells = 0;
    for (std::size_t i = 0; i < deviation.size(); ++i) {
        if (deviation[i] == -9999) continue;
        ASSERT_GE(deviation[i], 0);
        wider += interval[i] >= deviation[i];
        ++cells;
    }
    EXPECT_GT(cells, 3000);
    EXPECT_GT(wider, 0.99 * cells);  // 95 % lie within more than one deviation
    expect_failure("--uncertainty interval", 2, "--uncertainty");
    expect_failure("--show thickness --unit Clay --uncertainty interval", 1, "boreholes know it");
    expect_failure("--show ground --uncertainty doubt", 2, "--uncertainty");
}

TEST_F(MapCommand, takes_the_reference_system_that_a_layer_of_points_states) {
    std::string features;
    for (const auto& [name, x, y] : {std::tuple("A", 0, 0), {"B", 100, 0}, {"C", 100, 100}, {"D", 0, 100}})
        features += std::string(features.empty() ? "" : ",") + R"({"type":"Feature","properties":{"hole":")" +
                    name + R"(","ground":10,"Sand":2,"Clay":3},"geometry":{"type":"Point","coordinates":[)" +
                    std::to_string(x) + "," + std::to_string(y) + "]}}";
    const auto layer = [&](const std::string& crs) {
        return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:)" +
               crs + R"("}},"features":[)" + features + "]}";
    };
    folder_.file("holes.geojson", layer("EPSG::27700"));
    const auto built = run("build holes.geojson -o own --quiet --refine 0");
    ASSERT_EQ(built.exit_code, 0) << built.err;
    EXPECT_EQ(json::parse(content_of(folder_ / "own/model.json"))["crs"], "EPSG:27700");
    ASSERT_EQ(run("map own --show ground --cell 10 -o ground.tif").exit_code, 0);
    values_of(folder_ / "ground.tif");
    ASSERT_EQ(run("build holes.geojson -o other --quiet --refine 0 --crs EPSG:25832").exit_code, 0);
    EXPECT_EQ(json::parse(content_of(folder_ / "other/model.json"))["crs"], "EPSG:25832");
    folder_.file("degrees.geojson", layer("OGC:1.3:CRS84"));
    ASSERT_EQ(run("build degrees.geojson -o degrees --quiet --refine 0").exit_code, 0);
    EXPECT_NE(content_of(folder_ / "degrees/model.json").find("degrees"), std::string::npos);
    const auto unknown = run("build holes.geojson -o no --quiet --crs EPSG:nonsense");
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_NE(unknown.err.find("EPSG:nonsense"), std::string::npos) << unknown.err;
    EXPECT_FALSE(json::parse(content_of(folder_ / "model/model.json")).contains("crs"));
}

}  // namespace
}  // namespace stratareeb
