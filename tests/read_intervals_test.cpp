// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_intervals.h"

#include <gtest/gtest.h>

#include "boreholes/errors.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

//! Three holes at (0 0), (10 0), (0 10), ground 100, with these intervals.
class Intervals : public testing::Test {
 protected:
    BoreholeTable read(const std::string& rows, ReadBoreholesOptions options = {}) {
        options.collars = folder_.write("collars.csv", "hole,x,y,z\nA,0,0,100\nB,10,0,100\nC,0,10,100\n");
        return read_boreholes({folder_.write("logs.csv", "hole,from,to,unit\n" + rows)}, options);
    }
    static const Borehole& hole(const BoreholeTable& table, const std::string& id) {
        for (const Borehole& hole : table.survey.holes)
            if (hole.id == id) return hole;
        throw std::runtime_error("no hole " + id);
    }
    TempFolder folder_;
};

TEST_F(Intervals, unit_missed_above_is_absent_below_is_unknown_and_the_last_is_a_lower_bound) {
    const auto table = read("A,0,1,top\nA,1,3,mid\nA,3,6,low\nB,0,2,top\nB,2,5,low\nC,0,4,top\n");
    EXPECT_EQ(table.layout, TableLayout::Intervals);
    EXPECT_EQ(codes(table.survey), "top mid low");
    EXPECT_EQ(told(hole(table, "A")), "1 2 >3");
    EXPECT_EQ(elevations(hole(table, "A")), "100 99 97 _");
    EXPECT_EQ(told(hole(table, "B")), "2 0 >3");
    EXPECT_EQ(elevations(hole(table, "B")), "100 98 98 _");
    EXPECT_EQ(told(hole(table, "C")), ">4 ? ?");
    EXPECT_EQ(table.audit.warning_count(), 0u);
}

TEST_F(Intervals, rows_may_come_in_any_order_and_equal_neighbours_are_one) {
    const auto table = read("A,3,6,low\nA,1,3,top\nA,0,1,top\n");
    EXPECT_EQ(told(hole(table, "A")), "3 >3");
}

TEST_F(Intervals, gap_leaves_the_units_between_unknown_and_its_ends_known) {
    const auto table = read("A,0,1,top\nA,1,2,mid\nA,2,3,low\nB,0,2,top\nB,5,7,low\n");
    EXPECT_EQ(told(hole(table, "B")), "2 ? >2");
    EXPECT_EQ(elevations(hole(table, "B")), "100 98 95 _");
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:6: hole B: nothing is said of 2 to 5"), 1u);
}

TEST_F(Intervals, gap_that_no_unit_fits_makes_both_neighbours_lower_bounds) {
    const auto table = read("A,0,2,top\nA,5,7,low\nA,7,9,rock\nB,0,2,top\nB,2,4,low\nB,4,5,rock\n");
    EXPECT_EQ(told(hole(table, "A")), ">2 >2 >2");
    EXPECT_EQ(elevations(hole(table, "A")), "100 _ 93 _");
}

TEST_F(Intervals, gap_within_one_unit_closes) {
    EXPECT_EQ(told(hole(read("A,0,2,top\nA,5,7,top\nA,7,8,low\n"), "A")), "7 >1");
}

TEST_F(Intervals, row_without_unit_is_a_gap) {
    const auto table = read("A,0,1,top\nA,1,2,\nA,2,3,low\nB,0,1,top\nB,1,2,mid\nB,2,3,low\n");
    EXPECT_EQ(told(hole(table, "A")), "1 ? >1");
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:3: hole A: 1 to 2 has no unit"), 1u);
}

TEST_F(Intervals, few_late_starts_are_gaps_many_make_an_overburden) {
    const std::string others = "B,0,1,top\nB,1,4,low\nC,0,1,top\nC,1,4,low\n";
    const std::string more = "D,0,1,top\nD,1,4,low\nE,0,1,top\nE,1,4,low\n";
    ReadBoreholesOptions options;
    const auto few = [&] {
        const auto file =
            folder_.write("own.csv",
                          "hole,x,y,z,from,to,unit\nA,0,0,9,2,3,low\nB,5,0,9,0,1,top\nB,5,0,9,1,4,low\n"
                          "C,0,5,9,0,1,top\nD,5,5,9,0,1,top\nE,9,9,9,0,1,top\n");
        return read_boreholes({file});
    }();
    EXPECT_EQ(codes(few.survey), "top low");
    EXPECT_EQ(told(hole(few, "A")), "? >1");
    EXPECT_EQ(elevations(hole(few, "A")), "9 7 _");
    EXPECT_EQ(count_warnings(few.audit, "the log begins at 2"), 1u);

    const auto many = read("A,2,3,top\nA,3,5,low\nB,0,1,top\nB,1,4,low\nC,4,5,low\n");
    EXPECT_EQ(codes(many.survey), "overburden top low");
    EXPECT_EQ(told(hole(many, "A")), "2 1 >2");
    EXPECT_EQ(told(hole(many, "B")), "0 1 >3");
    EXPECT_EQ(told(hole(many, "C")), "? ? >1");
    EXPECT_EQ(elevations(hole(many, "C")), "100 _ 96 _");
}

TEST_F(Intervals, faulty_intervals_are_left_out_and_named) {
    const auto table = read("A,0,1,top\nA,3,2,mid\nA,2,2,mid\nA,1,3,low\nA,-2,-1,top\nZ,0,1,top\nB,0,,top\n");
    EXPECT_EQ(told(hole(table, "A")), "1 0 >2");
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:3: hole A: from 3 is below to 2"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:4: hole A: from and to are both 2"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:6: hole A: from -2 is above the ground"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:7: hole Z has no usable collar"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "logs.csv:8: hole B: no to"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "collars.csv:4: hole C has no intervals; only its ground is used"),
              1u);
    EXPECT_EQ(elevations(hole(table, "C")), "100 _ _ _");
}

TEST_F(Intervals, overlap_is_cut_at_the_lower_top) {
    const auto table = read("A,0,3,top\nA,2,5,low\nB,0,1,top\nB,0,1,top\nB,0,4,low\n");
    EXPECT_EQ(told(hole(table, "A")), "2 >3");
    EXPECT_EQ(told(hole(table, "B")), "1 >3");
    EXPECT_EQ(count_warnings(table.audit, "overlaps"), 3u);
}

TEST_F(Intervals, order_is_that_of_most_holes_and_contradictions_are_named) {
    const auto table = read("A,0,1,clay\nA,1,2,sand\nB,0,1,clay\nB,1,2,sand\nC,0,1,sand\nC,1,3,clay\n");
    EXPECT_EQ(codes(table.survey), "clay sand");
    EXPECT_EQ(
        count_warnings(table.audit,
                       "clay lies above sand in the order taken; 1 of 3 holes with both have it below (C)"),
        1u);
    EXPECT_EQ(told(hole(table, "C")), ">3 ?");  // the metre of sand goes to the clay
}

TEST_F(Intervals, cycle_is_reported) {
    const auto table = read("A,0,1,a\nA,1,2,b\nB,0,1,b\nB,1,2,c\nC,0,1,c\nC,1,2,a\n");
    EXPECT_EQ(codes(table.survey), "c a b");  // equal votes: the pairs met first win
    EXPECT_EQ(count_warnings(table.audit, "cycle"), 1u);
}

TEST_F(Intervals, repeated_unit_is_absorbed_or_split) {
    const std::string rows =
        "A,0,5,sand\nA,5,6,clay\nA,6,7,sand\nA,7,9,rock\nB,0,2,sand\nB,2,5,clay\nB,5,6,rock\n";
    const auto absorbed = read(rows);
    EXPECT_EQ(codes(absorbed.survey), "sand clay rock");
    EXPECT_EQ(told(hole(absorbed, "A")), "5 2 >2");
    EXPECT_EQ(
        count_warnings(absorbed.audit, "logs.csv:4: hole A: sand at 6 to 7 is out of order; taken as clay"),
        1u);
    ReadBoreholesOptions options;
    options.repeats = RepeatRule::Split;
    const auto split = read(rows, options);
    EXPECT_EQ(codes(split.survey), "sand clay sand (2) rock");
    EXPECT_EQ(told(hole(split, "A")), "5 1 1 >2");
    EXPECT_EQ(told(hole(split, "B")), "2 3 0 >1");
}

TEST_F(Intervals, stated_order_wins_and_strange_units_go_to_the_unit_above) {
    ReadBoreholesOptions options;
    options.order = {"sand", "clay", "gold"};
    const auto table = read("A,0,1,clay\nA,1,5,sand\nA,5,6,peat\nA,6,7,clay\n", options);
    EXPECT_EQ(codes(table.survey), "sand clay");
    EXPECT_EQ(told(hole(table, "A")), "6 >1");
    EXPECT_EQ(count_warnings(table.audit, "gold"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "unit peat is not in the order given"), 1u);
}

TEST_F(Intervals, elevations_become_depths) {
    const auto file =
        folder_.write("e.csv",
                      "hole,x,y,z,top_elevation,base_elevation,unit\nA,0,0,50,50,48,a\nA,0,0,50,48,40,b\n"
                      "B,1,0,,30,29,a\nB,1,0,,35,30,a\nB,1,0,,29,28,b\nC,0,1,50,50,48,a\n");
    const auto table = read_boreholes({file});
    EXPECT_EQ(table.values, TableValues::Elevation);
    EXPECT_EQ(elevations(hole(table, "A")), "50 48 _");
    EXPECT_EQ(elevations(hole(table, "B")), "35 29 _");
    EXPECT_EQ(count_warnings(table.audit, "hole B has no ground elevation; the top of its log, 35, is taken"),
              1u);
}

TEST_F(Intervals, all_unusable_cells_are_reported_at_once) {
    try {
        read("A,0,one,top\nA,x,2,top\nA,nan,3,top\n");
        FAIL();
    } catch (const InvalidInput& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("logs.csv:2: column to: \"one\" is not a finite number"), text.npos) << text;
        EXPECT_NE(text.find("logs.csv:3: column from: \"x\""), text.npos);
        EXPECT_NE(text.find("logs.csv:4: column from: \"nan\""), text.npos);
    }
}

TEST_F(Intervals, need_a_collar_table_and_recognise_one_among_the_sources) {
    const auto logs = folder_.write("l.csv", "hole,from,to,unit\nA,0,1,a\nA,1,2,b\n");
    try {
        read_boreholes({logs});
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("--collars"), std::string::npos);
    }
    const auto collars =
        folder_.write("c.csv", "hole,x,y,z,depth\nA,0,0,7,2\nA,0,0,7,2\nB,,,7,2\n,1,1,7,2\n");
    for (const auto& sources : {std::vector{logs, collars}, std::vector{collars, logs}}) {
        const auto table = read_boreholes(sources);
        EXPECT_EQ(told(hole(table, "A")), "1 >1");
        EXPECT_EQ(count_warnings(table.audit, "c.csv:3: hole A stands in row 2 already"), 1u);
        EXPECT_EQ(count_warnings(table.audit, "c.csv:4: hole B has no x, y"), 1u);
        EXPECT_EQ(count_warnings(table.audit, "c.csv:5: no hole id"), 1u);
    }
}

TEST_F(Intervals, without_a_header_go_by_place) {
    ReadBoreholesOptions options;
    options.collars = folder_.write("c.csv", "A,0,0,7\nB,1,0,7\n");
    const auto table = read_boreholes({folder_.write("l.csv", "A,0,1,a\nA,1,2,b\nB,0,2,a\n")}, options);
    EXPECT_EQ(told(hole(table, "A")), "1 >1");
    EXPECT_EQ(elevations(hole(table, "B")), "7 _ _");
}

}  // namespace
}  // namespace stratareeb
