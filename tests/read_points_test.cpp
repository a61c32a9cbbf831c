// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_points.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

class Points : public testing::Test {
 protected:
    BoreholeTable read(const std::string& text, const ReadBoreholesOptions& options = {}) {
        return read_boreholes({folder_.write("points.csv", text)}, options);
    }
    std::string refusal(const std::string& text, const ReadBoreholesOptions& options = {}) {
        try {
            read(text, options);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "(read)";
    }
    //! Two level surfaces over a grid, the upper one moved aside so that no two points share a place.
    static std::string two_sheets() {
        std::string text = "x,y,z,formation\n";
        for (int i = 0; i < 10; ++i)
            for (int j = 0; j < 10; ++j)
                text += fmt::format("{},{},{},low\n{},{},{},high\n", i * 10, j * 10, -50 + i, i * 10 + 3,
                                    j * 10 + 4, -20 + i);
        return text;
    }
    TempFolder folder_;
};

TEST_F(Points, tops_at_one_place_make_one_hole) {
    const auto table = read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n0,0,1,c\n5,0,4,b\n0,5,8,a\n");
    EXPECT_EQ(table.layout, TableLayout::Points);
    EXPECT_TRUE(table.survey.contact_points);
    EXPECT_EQ(codes(table.survey), "a b");
    ASSERT_EQ(table.survey.holes.size(), 3u);
    EXPECT_EQ(elevations(table.survey.holes[0]), "9 5 1");
    EXPECT_EQ(told(table.survey.holes[0]), "? ?");
    EXPECT_EQ(elevations(table.survey.holes[1]), "_ 4 _");
    EXPECT_EQ(elevations(table.survey.holes[2]), "8 _ _");
    EXPECT_EQ(count_warnings(table.audit, "3 surfaces bound 2 layers; c has no base"), 1u);
}

TEST_F(Points, ground_raster_adds_an_overburden) {
    ReadBoreholesOptions options;
    options.has_ground_raster = true;
    const auto table = read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n5,0,4,b\n0,5,8,a\n", options);
    EXPECT_EQ(codes(table.survey), "overburden a");
    EXPECT_EQ(elevations(table.survey.holes[0]), "_ 9 5");
}

TEST_F(Points, bases_need_a_ground) {
    ReadBoreholesOptions options;
    options.points_mark = PointsMark::Base;
    EXPECT_NE(refusal("x,y,z,unit\n0,0,9,a\n0,0,5,b\n", options).find("--ground"), std::string::npos);
    options.has_ground_raster = true;
    const auto table = read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n5,0,4,b\n", options);
    EXPECT_EQ(codes(table.survey), "a b");
    EXPECT_EQ(elevations(table.survey.holes[0]), "_ 9 5");
}

TEST_F(Points, order_comes_from_neighbours_where_no_place_has_both) {
    EXPECT_EQ(codes(read(two_sheets()).survey), "high");
    ReadBoreholesOptions options;
    options.order = {"low", "high"};
    EXPECT_EQ(codes(read(two_sheets(), options).survey), "low");
}

TEST_F(Points, overhang_is_refused_with_place_and_both_heights) {
    const std::string text =
        refusal("x,y,z,unit\n0,0,0,s\n100,0,0,s\n0,100,0,s\n100,100,0,s\n50,50,10,s\n50.01,50,-10,s\n");
    EXPECT_NE(text.find("points.csv:7: s is at z -10"), text.npos) << text;
    EXPECT_NE(text.find("at z 10"), text.npos);
    EXPECT_NE(text.find("x 50.01, y 50"), text.npos);
}

TEST_F(Points, one_stray_height_among_many_is_left_out) {
    const auto table = read(two_sheets() + "10,10,900,low\n");
    EXPECT_EQ(count_warnings(table.audit, "low has two heights at x 10, y 10"), 1u);
    for (const Borehole& hole : table.survey.holes)
        for (const auto& z : hole.horizons) EXPECT_LT(z.value_or(0), 100);
}

TEST_F(Points, small_disagreement_at_one_place_is_averaged) {
    const auto table = read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n0,0,5.1,b\n50,0,4,b\n0,50,80,a\n");
    EXPECT_NEAR(*table.survey.holes[0].horizons[1], 5.05, 1e-12);
    EXPECT_EQ(count_warnings(table.audit, "mean height"), 1u);
}

TEST_F(Points, faults_are_left_out) {
    const auto table =
        read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n0,0,7,fault_left\n5,0,4,default\n3,3,3,Hypo_Fault_E\n");
    EXPECT_EQ(count_warnings(table.audit, "is a fault by its name"), 2u);
    EXPECT_EQ(codes(table.survey), "a b");
}

TEST_F(Points, heights_out_of_order_in_a_hole_are_left_out) {
    const auto table =
        read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n0,0,1,c\n5,0,9,a\n5,0,5,b\n5,0,1,c\n9,0,1,a\n9,0,5,b\n9,0,0,c\n");
    EXPECT_EQ(codes(table.survey), "a b");
    EXPECT_EQ(count_warnings(table.audit, "out of order with the other units at x 9, y 0"), 1u);
    int known = 0;
    for (const auto& z : table.survey.holes[2].horizons) known += z.has_value();
    EXPECT_EQ(known, 2);
}

TEST_F(Points, depths_in_holes_with_collars_know_the_ground) {
    ReadBoreholesOptions options;
    options.collars = folder_.write("c.csv", "API,Easting,Northing,Datum Elevation\n1,0,0,100\n2,5,0,90\n");
    const auto table = read("API,Formation,MD\n1,a,10\n1,b,30\n2,a,5\n2,b,-3\n9,a,1\n", options);
    EXPECT_EQ(codes(table.survey), "overburden a");
    EXPECT_EQ(elevations(table.survey.holes[0]), "100 90 70");
    EXPECT_EQ(elevations(table.survey.holes[1]), "90 85 _");
    EXPECT_EQ(count_warnings(table.audit, "points.csv:5: a depth above the ground"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "hole 9 has no usable collar"), 1u);
}

TEST_F(Points, headerless_rows_of_four) {
    EXPECT_EQ(codes(read("0,0,9,a\n0,0,5,b\n1,0,4,b\n").survey), "a");
}

TEST_F(Points, single_surface_bounds_no_layer_unless_a_ground_comes) {
    const std::string text = "x,y,z,formation,hole_id\n0,0,9,rock,A\n5,0,8,rock,B\n0,5,8,rock,C\n";
    EXPECT_EQ(codes(read(text).survey), "");
    ReadBoreholesOptions options;
    options.has_ground_raster = true;
    EXPECT_EQ(codes(read(text, options).survey), "overburden");
}

TEST_F(Points, bad_cells_are_errors_and_missing_ones_warnings) {
    const std::string text = refusal("x,y,z,unit\n0,0,high,a\n0,west,5,b\n");
    EXPECT_NE(text.find("points.csv:2: column z: \"high\""), text.npos);
    EXPECT_NE(text.find("points.csv:3: column y: \"west\""), text.npos);
    const auto table = read("x,y,z,unit\n0,0,9,a\n0,0,5,b\n,0,5,b\n0,0,,b\n0,0,5,\n");
    EXPECT_EQ(table.audit.warning_count(), 4u);
}

TEST_F(Points, samples_become_intervals_half_way_to_their_neighbours) {
    std::string text = "hole_id,x,y,elevation,class\n";
    for (int i = 0; i < 6; ++i)
        text += fmt::format("A,0,0,{},sand\nB,5,0,{},sand\nB,5,0,{},clay\n", 9 - i, 9 - i, 3 - i);
    for (int i = 0; i < 6; ++i) text += fmt::format("A,0,0,{},clay\n", -2 - i);  // nothing from 4 down to -2
    const auto table = read(text);
    EXPECT_EQ(table.layout, TableLayout::Samples);
    EXPECT_FALSE(table.survey.contact_points);
    EXPECT_EQ(codes(table.survey), "sand clay");
    EXPECT_EQ(told(table.survey.holes[1]), "6 >6");
    EXPECT_EQ(elevations(table.survey.holes[1]), "9.5 3.5 _");
    EXPECT_EQ(told(table.survey.holes[0]), ">6 >6");
    EXPECT_EQ(count_warnings(table.audit, "nothing is said of 6 to 11"), 1u);
}

}  // namespace
}  // namespace stratareeb
