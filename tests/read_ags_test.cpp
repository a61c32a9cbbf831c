// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ags.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include "boreholes/errors.h"
#include "io/ags_file.h"
#include "io/read_boreholes.h"
#include "tests/borehole_files.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

const std::string kThird = STRATAREEB_SOURCE_DIR "/examples/ags/meadow_ags3.ags";
const std::string kFourth = STRATAREEB_SOURCE_DIR "/examples/ags/meadow_ags4.ags";

//! Every fact of a survey, a line per hole.
std::string facts(const Survey& survey, bool names = true) {
    std::string text = codes(survey) + "\n";
    if (names)
        for (const Unit& unit : survey.units) text += unit.name + ";";
    for (const Borehole& hole : survey.holes)
        text += "\n" + hole.id + " " + std::to_string(hole.at.x) + " " + std::to_string(hole.at.y) + ": " +
                told(hole) + " | " + elevations(hole);
    return text;
}

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
    EXPECT_NE(text.find(what), std::string::npos) << what;
    return std::regex_replace(
        text, std::regex(std::regex_replace(what, std::regex(R"([*?.()\[\]$^|+\\])"), R"(\$&)")), by);
}

//! The text of the error that reading gives.
std::string refusal(const std::vector<std::string>& files, const ReadBoreholesOptions& options = {}) {
    try {
        read_boreholes(files, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "read without complaint";
}

TEST(ReadAgs, both_editions_tell_the_same_site) {
    const auto third = read_boreholes({kThird}), fourth = read_boreholes({kFourth});
    EXPECT_EQ(third.audit.findings().size(), 0u) << third.audit.text();
    EXPECT_EQ(fourth.audit.findings().size(), 0u) << fourth.audit.text();
    EXPECT_EQ(facts(third.survey), facts(fourth.survey));
    EXPECT_EQ(codes(third.survey), "TS ALV RTD MMG");
    EXPECT_EQ(third.survey.units[2].name, "River terrace deposits");
    ASSERT_EQ(third.survey.holes.size(), 5u);
    EXPECT_EQ(third.survey.holes[0].at, (Point2{452100, 331200}));
    EXPECT_EQ(told(third.survey.holes[0]), "0.4 4.2 4.6 >2.8");
    EXPECT_EQ(elevations(third.survey.holes[0]), "61.2 60.8 56.6 52 _");
    EXPECT_EQ(told(third.survey.holes[2]), "0.5 0 6.5 >2.5");
    EXPECT_EQ(told(third.survey.holes[4]), "0.4 >2.6 ? ?");
    EXPECT_EQ(third.layout, TableLayout::Intervals);
    EXPECT_EQ(third.survey.length_unit, "m");
}

TEST(ReadAgs, continued_headings_and_values_are_put_together) {
    Audit audit;
    const AgsFile file = read_ags_file(kThird, audit);
    EXPECT_EQ(file.edition, 3);
    const AgsGroup& holes = *file.all("HOLE").front();
    EXPECT_EQ(holes.headings.size(), 7u);
    EXPECT_EQ(holes.headings[4], "HOLE_GL");
    EXPECT_EQ(holes.units[4], "m");
    EXPECT_EQ(holes.cell(holes.rows[0], holes.column("HOLE_REM")),
              "Groundwater was met at 3.1 m and rose to 2.8 m in 20 minutes.");
    const AgsGroup& strata = *file.all("GEOL").front();
    EXPECT_EQ(strata.headings.back(), "GEOL_NOTE");  // user-defined: *?
    EXPECT_EQ(strata.cell(strata.rows[1], strata.column("GEOL_DESC")),
              "Firm brown CLAY, becoming grey with depth");
    const AgsFile fourth = read_ags_file(kFourth, audit);
    EXPECT_EQ(fourth.edition, 4);
    const AgsGroup& geology = *fourth.all("GEOL").front();
    EXPECT_EQ(geology.cell(geology.rows[5], geology.column("GEOL_DESC")), "Soft grey \"fat\" CLAY");
    EXPECT_EQ(audit.findings().size(), 0u) << audit.text();
}

TEST(ReadAgs, line_ends_and_encodings_change_nothing) {
    const TemporaryFolder folder;
    for (const std::string& source : {kThird, kFourth}) {
        const std::string expected = facts(read_boreholes({source}).survey);
        std::string text = content_of(source);
        text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
        const std::string crlf = std::regex_replace(text, std::regex("\n"), "\r\n");
        const std::string degrees = replaced(text, "nobody", "M\xfcller 20\xb0");  // Latin-1
        std::string wide = "\xff\xfe";
        for (const char c : text) wide += c, wide += '\0';
        int number = 0;
        for (const std::string& variant :
             {text, crlf, "\xef\xbb\xbf" + crlf, "\r\n\n" + text, degrees, wide}) {
            const auto file = folder.file("v" + std::to_string(number++) + ".ags", variant);
            EXPECT_TRUE(is_ags_file(file));
            EXPECT_EQ(facts(read_boreholes({file}).survey), expected) << file;
        }
    }
}

TEST(ReadAgs, is_known_by_content_not_by_name) {
    const TemporaryFolder folder;
    const auto named = folder.file("site.txt", content_of(kFourth));
    EXPECT_EQ(facts(read_boreholes({named}).survey), facts(read_boreholes({kFourth}).survey));
    EXPECT_TRUE(is_ags_file(folder.file("bare.ags", "GROUP,PROJ\nHEADING,PROJ_ID\n")));
    EXPECT_FALSE(is_ags_file(folder.file("a.csv", "hole,x,y\n")));
    EXPECT_FALSE(is_ags_file(folder.file("b.csv", "group,x\n")));
    EXPECT_FALSE(is_ags_file(folder.file("empty.ags", "")));
    EXPECT_FALSE(is_ags_file((folder / "nothing.ags").string()));
}

TEST(ReadAgs, units_are_of_the_heading_that_is_filled_or_stated) {
    const auto stated = read_boreholes({kFourth}, {.columns = {{"unit", "GEOL_LEG"}}});
    EXPECT_EQ(codes(stated.survey), "101 201 501 801");
    EXPECT_EQ(stated.survey.units[3].name, "Mudstone");
    const TemporaryFolder folder;
    std::string text = content_of(kFourth);
    for (const char* code : {"TS", "ALV", "RTD", "MMG"})
        text = replaced(text, std::string(",\"") + code + "\"\r", ",\"\"\r");
    const auto legend = read_boreholes({folder.file("legend.ags", text)});
    EXPECT_EQ(codes(legend.survey), "101 201 501 801");
    EXPECT_EQ(count_warnings(legend.audit, "units are the codes in GEOL_LEG"), 1u);
    EXPECT_NE(refusal({kFourth}, {.columns = {{"unit", "GEOL_XXX"}}})
                  .find("no such heading in group GEOL; it has LOCA_ID"),
              std::string::npos);
    EXPECT_NE(refusal({kFourth}, {.columns = {{"depth", "GEOL_TOP"}}}).find("only x, y, ground and unit"),
              std::string::npos);
}

TEST(ReadAgs, places_and_strata_may_stand_in_two_files) {
    const TemporaryFolder folder;
    const std::string text = content_of(kFourth);
    const auto strata = text.find("\"GROUP\",\"GEOL\""), places = text.find("\"GROUP\",\"LOCA\"");
    const auto a = folder.file("a.ags", text.substr(0, places)).string();
    const auto b = folder.file("b.ags", text.substr(places, strata - places)).string();
    const auto c = folder.file("c.ags", text.substr(strata)).string();
    const std::string expected = facts(read_boreholes({kFourth}).survey);
    EXPECT_EQ(facts(read_boreholes({a, b, c}).survey), expected);
    EXPECT_EQ(facts(read_boreholes({c, a, b}).survey), expected);
    EXPECT_NE(refusal({a, c}).find("no group LOCA or HOLE"), std::string::npos);
    EXPECT_NE(refusal({a, b}).find("no group GEOL"), std::string::npos);
    EXPECT_NE(refusal({kFourth, folder.file("t.csv", "x,y,z,1,2\n").string()}).find("can't be read together"),
              std::string::npos);
    // The same holes once more, in the other edition: nothing new.
    EXPECT_EQ(read_boreholes({kThird, b}).survey.holes.size(), 5u);
    EXPECT_EQ(read_boreholes({kThird, b}).audit.findings().size(), 0u);
}

TEST(ReadAgs, holes_without_coordinates_are_named_or_taken_from_collars) {
    const TemporaryFolder folder;
    const auto file =
        folder.file("gap.ags", replaced(content_of(kFourth), "\"452180.00\",\"331210.00\"", "\"\",\"\""))
            .string();
    const auto table = read_boreholes({file});
    EXPECT_EQ(table.survey.holes.size(), 4u);
    EXPECT_EQ(
        count_warnings(table.audit,
                       "gap.ags:51: column LOCA_NATE, LOCA_NATN: group LOCA: hole BH2 has no coordinates"),
        1u)
        << table.audit.text();
    const auto collars =
        folder.file("collars.csv", "hole,x,y,z\nBH2,452180,331210,60.85\nBH1,1,2,3\n").string();
    EXPECT_EQ(facts(read_boreholes({file}, {.collars = collars}).survey),
              facts(read_boreholes({kFourth}).survey));
}

TEST(ReadAgs, local_coordinates_are_used_where_there_are_no_others) {
    const TemporaryFolder folder;
    std::string text = replaced(content_of(kThird), "*HOLE_NATE\",\"*HOLE_NATN", "*HOLE_LOCX\",\"*HOLE_LOCY");
    const auto table = read_boreholes({folder.file("local.ags", text)});
    EXPECT_EQ(table.survey.holes[0].at, (Point2{452100, 331200}));
    EXPECT_EQ(*table.survey.holes[0].horizons[0], 61.2);
    EXPECT_EQ(count_warnings(table.audit, "no hole has national grid coordinates"), 1u);
}

TEST(ReadAgs, lengths_in_other_units_are_converted) {
    const TemporaryFolder folder;
    std::string text = content_of(kFourth);
    text = replaced(text, "\"UNIT\",\"\",\"m\",\"m\",\"\",\"\",\"\"",
                    "\"UNIT\",\"\",\"mm\",\"mm\",\"\",\"\",\"\"");
    const auto table = read_boreholes({folder.file("mm.ags", text)});
    EXPECT_EQ(told(table.survey.holes[0]), "0.0004 0.0042 0.0046 >0.0028");
    const auto odd = replaced(text, "\"mm\",\"mm\"", "\"fathom\",\"mm\"");
    EXPECT_NE(refusal({folder.file("odd.ags", odd)}).find("its unit \"fathom\" is no length"),
              std::string::npos);
    EXPECT_NE(refusal({kFourth}, {.length_unit = "ft"}).find("leave --unit"), std::string::npos);
    EXPECT_NE(refusal({kFourth}, {.layout = TableLayout::Wide}).find("leave --layout out"),
              std::string::npos);
}

TEST(ReadAgs, errors_name_line_heading_group_hole_value_and_way_out) {
    const TemporaryFolder folder;
    const std::string text = content_of(kThird);
    const auto says = [&](const std::string& what, const std::string& by, const std::string& expected) {
        const std::string message = refusal({folder.file("bad.ags", replaced(text, what, by)).string()});
        EXPECT_NE(message.find(expected), std::string::npos) << message;
    };
    says("\"9.20\",\"12.00\"", "\"9.20\",\"deep\"",
         "bad.ags:24: column GEOL_BASE: group GEOL: hole BH1: \"deep\" is no number; correct it, or leave it "
         "empty");
    says("\"331290.00\",\"62.10\"", "\"331290.00\",\"n.k.\"",
         "bad.ags:13: column HOLE_GL: group HOLE: hole BH3: \"n.k.\"");
    says("\"TOPSOIL\",\"101\",\"TS\",\"\"", "\"TOPSOIL\",\"101\",\"TS\",\"\",\"extra\"",
         "bad.ags:25: group GEOL: 8 values under 7 headings; the last is \"extra\"");
    says("\"**PROJ\"", "\"**PROJ\"\n\"<CONT>\",\"x\"", "<CONT> with no row before it");
    // All at once, not the first alone.
    const auto both =
        folder.file("two.ags", replaced(replaced(text, "\"7.00\"", "\"7,0,0\""), "\"8.40\"", "\"?x\""));
    const std::string message = refusal({both});
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 3) << message;
}

TEST(ReadAgs, faults_that_can_be_worked_around_are_warned_of) {
    const TemporaryFolder folder;
    const std::string text = content_of(kFourth);
    const auto warns = [&](const std::string& what, const std::string& by, const std::string& expected) {
        const auto table = read_boreholes({folder.file("odd.ags", replaced(text, what, by)).string()});
        EXPECT_EQ(count_warnings(table.audit, expected), 1u) << expected << "\n" << table.audit.text();
    };
    warns("\"DATA\",\"TP5\",\"TP\"", "\"DATA\",\"TP6\",\"TP\"",
          "hole TP5 is not among the holes of the file; its 2 strata");
    warns("\"2.00\",\"8.40\"", "\"2.00\",\"\"",
          "column GEOL_BASE: group GEOL: hole BH4: empty; the stratum is left out");
    warns("\"DATA\",\"TP5\",\"TP\"", "\"DATA\",\"\",\"TP\"", "no hole id; the row is left out");
    warns("Weak red MUDSTONE\",\"801\",\"MMG\"\r\n\"DATA\",\"BH2\"",
          "Weak red\r\nMUDSTONE\",\"801\",\"MMG\"\r\n\"DATA\",\"BH2\"", "a value goes on in the next line");
    warns("\"GROUP\",\"LOCA\"", "\"GROUP\",\"GEOL\"\r\n\r\n\"GROUP\",\"LOCA\"",
          "group GEOL stands in the file again");
    warns("\"11.00\",\"\"\r", "\"11.00\"\r", "1 rows have fewer values than headings, the first in line 53");
    warns("\"0.50\",\"TOPSOIL\",", "\"0.50\",\"TOPSOIL,",
          "1 rows have fewer values than headings, the first in line");
}

TEST(ReadAgs, an_inclined_hole_is_named) {
    const TemporaryFolder folder;
    std::string text =
        replaced(content_of(kThird), "\"*HOLE_GL\",\"*HOLE_FDEP\"", "\"*HOLE_GL\",\"*HOLE_INCL\"");
    text = replaced(text, "\"60.85\",\"10.00\"", "\"60.85\",\"-90\"");
    const auto table = read_boreholes({folder.file("dips.ags", text)});
    EXPECT_EQ(count_warnings(table.audit, "hole BH1 dips by 12 degrees; it is taken as vertical"), 1u);
    EXPECT_EQ(count_warnings(table.audit, "hole BH2 dips"), 0u);
}

TEST(ReadAgs, cut_off_anywhere_it_is_read_or_refused_never_worse) {
    const TemporaryFolder folder;
    for (const std::string& source : {kThird, kFourth}) {
        const std::string text = content_of(source);
        for (std::size_t size = 0; size < text.size(); size += 61) {
            const auto file = folder.file("cut.ags", text.substr(0, size)).string();
            try {
                const auto table = read_boreholes({file});
                EXPECT_GT(table.survey.holes.size(), 0u);
            } catch (const InvalidInput& error) {
                EXPECT_NE(std::string(error.what()).find("cut.ags"), std::string::npos) << error.what();
            } catch (const IoError&) {
            }
        }
    }
}

std::string data(const std::string& name) {
    return STRATAREEB_SOURCE_DIR "/../shared/data/ags_uk/" + name;
}

struct RealSite {
    const char *folder, *file, *unit_column;
    std::size_t holes, with_strata;
};

//! Public files beside the source tree, against tables that were made from them by other means.
TEST(ReadAgs, real_sites_equal_their_converted_tables) {
    if (!std::filesystem::exists(data("sighthill"))) GTEST_SKIP() << "no data beside the source tree";
    for (const RealSite& site :
         {RealSite{"sighthill", "AGS3__GCC_19934-2_Sighthill_Phase1SI_14.02.13_gINT.ags", "legend_code", 123,
                   123},
          {"wigan_depot", "Wigan_Depot.ags", "geology_code", 105, 81},
          {"dlr_city_airport", "Docklands_Light_Railway_London_City_Airport_Extension.ags", "legend_code",
           100, 100}}) {
        const std::string folder = site.folder;
        Audit audit;
        const ReadBoreholesOptions plain;
        TableContext context{plain, audit};
        const AgsLogs ags = read_ags({data(folder + "/original/" + site.file)}, nullptr, context);
        EXPECT_EQ(audit.error_count(), 0u) << audit.text();
        EXPECT_EQ(ags.logs.holes.size(), site.holes);
        EXPECT_EQ(std::ranges::count_if(ags.logs.holes,
                                        [](const HoleLog& hole) { return !hole.intervals.empty(); }),
                  static_cast<std::ptrdiff_t>(site.with_strata));

        const auto table = read_boreholes(
            {data(folder + "/intervals.csv")},
            {.collars = data(folder + "/collars.csv"), .columns = {{"unit", site.unit_column}}});
        const auto direct = read_boreholes({data(folder + "/original/" + site.file)});
        std::map<std::string, std::string> expected, found;
        for (const Borehole& hole : table.survey.holes)
            expected[hole.id] = told(hole) + "|" + elevations(hole);
        for (const Borehole& hole : direct.survey.holes)
            if (told(hole).find_first_not_of("? ") != std::string::npos || expected.contains(hole.id))
                found[hole.id] = told(hole) + "|" + elevations(hole);
        EXPECT_EQ(found, expected) << folder;
        EXPECT_EQ(codes(direct.survey), codes(table.survey)) << folder;
    }
}

}  // namespace
}  // namespace stratareeb
