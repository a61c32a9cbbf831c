// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_raster.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

const std::string kPlane =  // z = x + 10 y at cell centres, cells of 2 from (100, 200)
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -9999\n2131 2133 2135\n2111 "
    "2113 2115\n";

TEST(ReadRaster, plane_is_exact_between_cell_centres) {
    const TempFolder folder;
    const Raster raster = read_raster(folder.write("plane.asc", kPlane));
    EXPECT_EQ(raster.low(), (Point2{100, 200}));
    EXPECT_EQ(raster.high(), (Point2{106, 204}));
    for (double x = 101; x <= 105; x += 0.25)
        for (double y = 201; y <= 203; y += 0.25) EXPECT_NEAR(raster.sample(x, y).value(), x + 10 * y, 1e-9);
    EXPECT_NEAR(raster.sample(100, 200).value(), 2111, 1e-9);  // the outer half cell is level
    EXPECT_NEAR(raster.sample(106, 204).value(), 2135, 1e-9);
    EXPECT_FALSE(raster.sample(99.99, 202));
    EXPECT_FALSE(raster.sample(103, 204.01));
    EXPECT_FALSE(raster.sample(std::nan(""), 202));
}

TEST(ReadRaster, no_data_is_no_height) {
    const TempFolder folder;
    std::string text = kPlane;
    text.replace(text.find("2135"), 4, "-9999");
    const Raster raster = read_raster(folder.write("hole.asc", text));
    EXPECT_FALSE(raster.sample(104.5, 202.5));
    EXPECT_TRUE(raster.sample(102, 202.5));
    EXPECT_NEAR(raster.sample(103, 203).value(), 2133, 1e-9);  // exactly on a good centre
}

TEST(ReadRaster, what_is_no_raster_is_refused) {
    const TempFolder folder;
    EXPECT_THROW(read_raster(folder.path("missing.tif")), IoError);
    EXPECT_THROW(read_raster(folder.write("text.tif", "no raster")), IoError);
    EXPECT_THROW(read_raster(folder.write("empty.asc", "")), IoError);
}

}  // namespace
}  // namespace stratareeb
