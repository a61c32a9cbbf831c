// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_wide.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

class Wide : public testing::Test {
 protected:
    BoreholeTable read(const std::string& text, const ReadBoreholesOptions& options = {}) {
        return read_boreholes({folder_.write("wide.csv", text)}, options);
    }
    std::string refusal(const std::string& text, const ReadBoreholesOptions& options = {}) {
        try {
            read(text, options);
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "(read)";
    }
    TempFolder folder_;
};

TEST_F(Wide, pairs_without_a_header_as_in_the_thesis) {
    const auto table = read("0,0,120,1,10.5,2,0,3,30\n10,0,43,1,5,2,6,3,7\n0,10,5,1,1,2,2,3,0\n");
    EXPECT_EQ(table.layout, TableLayout::Wide);
    EXPECT_EQ(table.values, TableValues::Thickness);
    EXPECT_EQ(codes(table.survey), "1 2 3");
    EXPECT_EQ(told(table.survey.holes[0]), "10.5 0 30");
    EXPECT_EQ(elevations(table.survey.holes[0]), "120 109.5 109.5 79.5");
    EXPECT_EQ(table.survey.holes[1].at, (Point2{10, 0}));
    EXPECT_EQ(table.survey.holes[2].row, 3u);
}

TEST_F(Wide, short_row_ends_in_its_last_layer) {
    const auto table = read("0,0,9,1,2\n5,0,9,1,2,2,0\n0,5,9,1,2,2,3,3,4\n5,5,9,1,0,2,1,3,\n9,9,9\n");
    EXPECT_EQ(told(table.survey.holes[0]), ">2 ? ?");
    EXPECT_EQ(elevations(table.survey.holes[0]), "9 _ _ _");
    EXPECT_EQ(told(table.survey.holes[1]), "2 0 ?");
    EXPECT_EQ(elevations(table.survey.holes[1]), "9 7 7 _");
    EXPECT_EQ(told(table.survey.holes[2]), "2 3 4");
    EXPECT_EQ(told(table.survey.holes[3]), "0 >1 ?");
    EXPECT_EQ(told(table.survey.holes[4]), "? ? ?");
}

TEST_F(Wide, absent_unknown_and_at_least_stay_three_facts) {
    const auto table = read(
        "id,x,y,z,a,b,c\nH1,0,0,5,1,0,2\nH2,1,0,5,1,,2\nH3,0,1,5,1,>3,-\nH4,1,1,5,1,2+,?\nH5,2,2,5,,NA,\n");
    EXPECT_EQ(told(table.survey.holes[0]), "1 0 2");
    EXPECT_EQ(told(table.survey.holes[1]), "1 ? 2");
    EXPECT_EQ(elevations(table.survey.holes[1]), "5 4 _ _");
    EXPECT_EQ(told(table.survey.holes[2]), "1 >3 ?");
    EXPECT_EQ(told(table.survey.holes[3]), "1 >2 ?");
    EXPECT_EQ(told(table.survey.holes[4]), "? ? ?");
}

TEST_F(Wide, hole_ids_may_lead_a_headerless_row) {
    const auto text = read("BH1,0,0,5,1,2,2,3\nBH2,1,0,5,1,2,2,3\nBH3,0,1,5,1,2,2,3\n");
    EXPECT_EQ(text.survey.holes[1].id, "BH2");
    const auto numbers = read("1,0,0,5,1,2,2,3\n2,1,0,5,1,2,2,3\n3,0,1,5,1,2,2,3\n");
    EXPECT_EQ(numbers.survey.holes[1].at, (Point2{1, 0}));
    EXPECT_EQ(told(numbers.survey.holes[0]), "2 3");
}

TEST_F(Wide, columns_about_the_hole_are_not_layers_and_are_named) {
    const auto table = read(
        "hole_id,Easting,Northing,z_ground,clay (m),sand_thickness,times_drawn,operator\n"
        "H1,0,0,5,1,2,7,Jo\nH2,1,0,5,1,2,7,Jo\n");
    EXPECT_EQ(codes(table.survey), "clay sand");
    EXPECT_EQ(count_warnings(table.audit, "columns not used: times_drawn, operator"), 1u);
}

TEST_F(Wide, pairs_with_a_header) {
    const auto table =
        read("row,A_x,B_y,C_z,D_code1,E_thickness1,F_code2,G_thickness2\n1,0,0,5,a,1,b,2\n2,1,0,5,a,1,b,2\n");
    EXPECT_EQ(codes(table.survey), "a b");
    EXPECT_EQ(told(table.survey.holes[0]), "1 2");
}

TEST_F(Wide, order_of_codes_is_inferred_from_rows_that_list_them_differently) {
    const auto table = read("0,0,5,b,1,c,2\n1,0,5,a,1,b,1\n0,1,5,a,1,c,4\n1,1,5,a,1,b,2,c,3\n");
    EXPECT_EQ(codes(table.survey), "a b c");
    EXPECT_EQ(told(table.survey.holes[0]), "0 1 2");
    EXPECT_EQ(told(table.survey.holes[1]), "1 >1 ?");
    EXPECT_EQ(told(table.survey.holes[2]), "1 0 4");
}

TEST_F(Wide, repeated_code_in_a_row_is_absorbed_or_split) {
    const std::string text = "0,0,9,s,5,c,1,s,1,r,2\n1,0,9,s,1,c,2,r,3\n0,1,9,s,1,c,2,r,3\n";
    const auto absorbed = read(text);
    EXPECT_EQ(codes(absorbed.survey), "s c r");
    EXPECT_EQ(told(absorbed.survey.holes[0]), "5 2 2");
    EXPECT_EQ(elevations(absorbed.survey.holes[0]), "9 4 2 0");
    EXPECT_EQ(count_warnings(absorbed.audit, "wide.csv:1: hole row 1: s (1) is out of order"), 1u);
    ReadBoreholesOptions options;
    options.repeats = RepeatRule::Split;
    const auto split = read(text, options);
    EXPECT_EQ(codes(split.survey), "s c s (2) r");
    EXPECT_EQ(told(split.survey.holes[0]), "5 1 1 2");
    EXPECT_EQ(told(split.survey.holes[1]), "1 2 0 3");
}

TEST_F(Wide, stated_order_picks_the_layer_columns) {
    ReadBoreholesOptions options;
    options.order = {"sand", "clay"};
    const auto table = read("id,x,y,z,clay,note,sand,total\nH,0,0,5,1,x,2,3\nI,1,0,5,1,y,2,3\n", options);
    EXPECT_EQ(codes(table.survey), "sand clay");
    EXPECT_EQ(told(table.survey.holes[0]), "2 1");
    EXPECT_EQ(count_warnings(table.audit, "columns not used: note, total"), 1u);
}

TEST_F(Wide, depths_of_bases) {
    ReadBoreholesOptions options;
    options.values = TableValues::Depth;
    const auto table = read(
        "id,x,y,z,a,b,c\nH1,0,0,10,1,1,4\nH2,1,0,10,1,,4\nH3,0,1,10,1,3,\nH4,1,1,10,5,3,6\nH5,2,1,,2,3,6\n",
        options);
    EXPECT_EQ(told(table.survey.holes[0]), "1 0 3");
    EXPECT_EQ(elevations(table.survey.holes[0]), "10 9 9 6");
    EXPECT_EQ(told(table.survey.holes[1]), "1 ? ?");
    EXPECT_EQ(elevations(table.survey.holes[1]), "10 9 _ 6");
    EXPECT_EQ(told(table.survey.holes[2]), "1 >2 ?");
    EXPECT_EQ(elevations(table.survey.holes[2]), "10 9 _ _");
    EXPECT_EQ(count_warnings(table.audit, "wide.csv:5: hole H4: "), 1u);
    EXPECT_EQ(told(table.survey.holes[4]), "2 1 3");
    EXPECT_EQ(elevations(table.survey.holes[4]), "_ _ _ _");
}

TEST_F(Wide, elevations_of_bases) {
    const auto table = read("id,x,y,z,a_elevation,b_elevation\nH1,0,0,10,8,3\nH2,1,0,,8,3\n");
    EXPECT_EQ(table.values, TableValues::Elevation);
    EXPECT_EQ(told(table.survey.holes[0]), "2 5");
    EXPECT_EQ(elevations(table.survey.holes[0]), "10 8 3");
    EXPECT_EQ(told(table.survey.holes[1]), "? 5");
    EXPECT_EQ(elevations(table.survey.holes[1]), "_ 8 3");
}

TEST_F(Wide, depths_of_tops_put_an_overburden_on_top) {
    ReadBoreholesOptions options;
    options.values = TableValues::Depth;
    options.points_mark = PointsMark::Top;
    options.collars = folder_.write("c.csv", "hole_id,x,y,z\nH1,0,0,100\nH2,5,0,100\n");
    const auto table = read("hole_id,F1,F2,F3\nH1,10,30,60\nH2,10,,\n", options);
    EXPECT_EQ(codes(table.survey), "overburden F1 F2");
    EXPECT_EQ(told(table.survey.holes[0]), "10 20 30");
    EXPECT_EQ(elevations(table.survey.holes[0]), "100 90 70 40");
    EXPECT_EQ(told(table.survey.holes[1]), "10 ? ?");
    EXPECT_EQ(elevations(table.survey.holes[1]), "100 90 _ _");
}

TEST_F(Wide, missing_ground_is_predicted_or_zero) {
    const auto some = read("x,y,z,a,b\n0,0,,1,2\n1,0,7,1,2\n");
    EXPECT_EQ(elevations(some.survey.holes[0]), "_ _ _");
    EXPECT_EQ(count_warnings(some.audit, "wide.csv:2: hole row 2 has no ground elevation"), 1u);
    const auto none = read("x,y,z,a,b\n0,0,,1,2\n1,0,,1,2\n");
    EXPECT_EQ(elevations(none.survey.holes[0]), "0 -1 -3");
    EXPECT_EQ(count_warnings(none.audit, "ground is taken as 0"), 1u);
    ReadBoreholesOptions options;
    options.has_ground_raster = true;
    const auto raster = read("x,y,z,a,b\n0,0,,1,2\n1,0,,1,2\n", options);
    EXPECT_EQ(elevations(raster.survey.holes[0]), "_ _ _");
    EXPECT_EQ(raster.audit.warning_count(), 0u);
}

TEST_F(Wide, units_of_length_are_kept_and_vertical_ones_converted) {
    ReadBoreholesOptions options;
    options.length_unit = "m";
    options.vertical_unit = "ft";
    const auto mixed = read("x,y,z,a\n0,0,10,1\n1,0,10,2\n", options);
    EXPECT_DOUBLE_EQ(mixed.survey.holes[0].layers[0].thickness, 0.3048);
    EXPECT_DOUBLE_EQ(*mixed.survey.holes[0].horizons[0], 3.048);
    options.length_unit = "ft";
    EXPECT_EQ(read("x,y,z,a\n0,0,10,1\n1,0,10,2\n", options).survey.holes[0].layers[0].thickness, 1);
    EXPECT_EQ(read("x,y,z,a\n0,0,10,1\n1,0,10,2\n", options).survey.length_unit, "ft");
    options.length_unit = "cubit";
    EXPECT_NE(refusal("x,y,z,a\n0,0,10,1\n", options).find("cubit"), std::string::npos);
}

TEST_F(Wide, every_bad_cell_is_an_error_with_its_place) {
    const std::string text =
        refusal("id,x,y,z,a,b\nH1,0,0,5,one,2\nH2,1,q,5,1,-2\nH3,2,0,5,inf,1\nH4,3,3,5,1,2\n");
    EXPECT_NE(text.find("wide.csv:2: column a: \"one\" is not a finite number"), text.npos) << text;
    EXPECT_NE(text.find("wide.csv:3: column y: \"q\""), text.npos);
    EXPECT_NE(text.find("wide.csv:3: column b: thickness -2 is negative"), text.npos);
    EXPECT_NE(text.find("wide.csv:4: column a: \"inf\""), text.npos);
}

TEST_F(Wide, holes_without_a_place_and_repeated_ids_are_warned_of) {
    const auto table = read("id,x,y,z,a\nH1,0,0,5,1\nH2,,0,5,1\nH1,5,5,5,1\n");
    EXPECT_EQ(table.survey.holes.size(), 2u);
    EXPECT_EQ(count_warnings(table.audit, "wide.csv:3: hole H2 has no x, y"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "wide.csv:4: hole id H1 stands in row 2 already"), 1u);
}

TEST_F(Wide, columns_can_be_stated) {
    ReadBoreholesOptions options;
    options.columns = {{"x", "ost"}, {"y", "3"}, {"ground", "H\xc3\xb6he"}, {"hole", "Nr"}};
    const auto table = read("Nr,ost,nord,H\xc3\xb6he,a\n1,0,7,5,1\n2,1,7,5,1\n", options);
    EXPECT_EQ(table.survey.holes[1].at, (Point2{1, 7}));
    EXPECT_EQ(*table.survey.holes[1].horizons[0], 5);
    options.columns["x"] = "west";
    EXPECT_NE(refusal("Nr,ost,nord,H\xc3\xb6he,a\n1,0,7,5,1\n", options).find("west"), std::string::npos);
    options.columns = {{"colour", "a"}};
    EXPECT_NE(refusal("x,y,z,a\n1,0,7,5\n", options).find("no such role"), std::string::npos);
}

TEST_F(Wide, value_without_a_code_is_an_error) {
    EXPECT_NE(refusal("0,0,5,a,1,,3\n1,0,5,a,1,b,2\n").find("wide.csv:1: column F: a value without the code"),
              std::string::npos);
}

}  // namespace
}  // namespace stratareeb
