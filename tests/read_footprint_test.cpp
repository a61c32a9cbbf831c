// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_footprint.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

double area(const std::vector<Point2>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

const char* const kSquareWithHole =
    R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}},
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
      [[[0,0],[0,10],[10,10],[10,0],[0,0]],[[2,2],[4,2],[4,4],[2,4],[2,2]]]}}]})";

TEST(ReadFootprint, table_of_points_is_one_ring_counter_clockwise) {
    const TempFolder folder;
    for (const char* text :
         {"x,y\n0,0\n0,4\n3,4\n3,0\n", "0,0\n0,4\n3,4\n3,0\n0,0\n", "UTM_Y,UTM_X\n0,0\n0,3\n4,3\n4,0\n"}) {
        const auto rings = read_footprint(folder.write("f.csv", text));
        ASSERT_EQ(rings.size(), 1u);
        EXPECT_EQ(rings[0].size(), 4u);
        EXPECT_EQ(area(rings[0]), 12);
    }
}

TEST(ReadFootprint, largest_polygon_with_its_holes) {
    const TempFolder folder;
    const auto rings = read_footprint(folder.write("f.geojson", kSquareWithHole));
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(area(rings[0]), 100);
    EXPECT_EQ(area(rings[1]), -4);
}

TEST(ReadFootprint, what_bounds_no_area_is_refused) {
    const TempFolder folder;
    EXPECT_THROW(read_footprint(folder.write("two.csv", "x,y\n0,0\n1,1\n")), InvalidInput);
    EXPECT_THROW(read_footprint(folder.write("flat.csv", "x,y\n0,0\n1,1\n2,2\n")), InvalidInput);
    EXPECT_THROW(read_footprint(folder.write("bow.csv", "x,y\n0,0\n2,2\n2,0\n0,3\n")), InvalidInput);
    EXPECT_THROW(read_footprint(folder.write("spike.csv", "x,y\n0,0\n4,0\n4,4\n9,4\n4,4\n0,4\n")),
                 InvalidInput);
    EXPECT_THROW(read_footprint(folder.write("text.csv", "x,y\n0,0\n4,zero\n4,4\n")), InvalidInput);
    EXPECT_THROW(read_footprint(folder.path("missing.gpkg")), IoError);
}

TEST(ReadFootprint, outline_that_touches_itself_in_far_coordinates_is_found) {
    const TempFolder folder;
    EXPECT_THROW(read_footprint(folder.write("f.csv",
                                             "x,y\n5000000,5000000\n5000010,5000000\n5000010,5000010\n"
                                             "5000005,5000000\n5000000,5000010\n")),
                 InvalidInput);
}

}  // namespace
}  // namespace stratareeb
