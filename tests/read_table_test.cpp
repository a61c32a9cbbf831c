// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_table.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "boreholes/errors.h"
#include "io/read_boreholes.h"
#include "tests/borehole_files.h"

namespace stratareeb {
namespace {

std::string row_text(const TextTable& table, std::size_t row) {
    std::string text;
    for (std::size_t column = 0; column < table.cell_count(row); ++column)
        text.append(column ? "|" : "").append(table.cell(row, column));
    return text;
}

class Table : public testing::Test {
 protected:
    TextTable csv(const std::string& text) {
        return std::move(read_tables(folder_.write("t.csv", text)).front());
    }
    std::string refusal(const std::string& source) {
        try {
            read_boreholes({source});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "(read)";
    }
    TempFolder folder_;
};

TEST_F(Table, separators_line_ends_quotes_and_ragged_rows) {
    for (const char* end : {"\n", "\r\n", "\r"})
        for (const char separator : {',', ';', '\t', '|'}) {
            std::string text = fmt::format(
                "a{0}b{1}1{0}2{0}3{0}4{1}{1}\"x{0}y\"{0}\"he said \"\"no\"\"\"{0}{1}", separator, end);
            const TextTable table = csv(text);
            ASSERT_EQ(table.row_count(), 3u);
            EXPECT_EQ(row_text(table, 0), "a|b");
            EXPECT_EQ(row_text(table, 1), "1|2|3|4");
            EXPECT_EQ(row_text(table, 2), fmt::format("x{}y|he said \"no\"|", separator));
            EXPECT_EQ(table.line(2), 4u);
            EXPECT_EQ(table.column_count(), 4u);
        }
}

TEST_F(Table, quoted_line_ends_count_as_lines) {
    const TextTable table = csv("a,\"two\nlines\"\nb,c");
    EXPECT_EQ(table.line(1), 3u);
    EXPECT_EQ(row_text(table, 1), "b|c");
}

TEST_F(Table, encodings) {
    EXPECT_EQ(row_text(csv("\xef\xbb\xbfx,H\xc3\xb6he\n"), 0), "x|H\xc3\xb6he");
    EXPECT_EQ(row_text(csv("x,H\xf6he \x80\n"), 0), "x|H\xc3\xb6he \xe2\x82\xac");
    std::string wide("\xff\xfe", 2);
    for (const char c : std::string("x,\xe9\n1,2\n")) wide += {c, '\0'};
    EXPECT_EQ(row_text(csv(wide), 0), "x|\xc3\xa9");
    std::string big("\xfe\xff", 2);
    for (const char c : std::string("x,y\n")) big += {'\0', c};
    EXPECT_EQ(row_text(csv(big), 0), "x|y");
}

TEST_F(Table, decimal_commas) {
    EXPECT_TRUE(csv("x;y\n1,5;2\n").decimal_comma);
    EXPECT_TRUE(csv("x,y\n\"1,5\",2\n").decimal_comma);
    EXPECT_FALSE(csv("x,y\n\"1,500\",2\n").decimal_comma);
    EXPECT_FALSE(csv("x;y\n1,5;2.5\n").decimal_comma);
    const auto survey = read_boreholes({folder_.write("c.csv", "x;y;z;a\n0,5;1;2,25;3\n1;1;2;3,5\n")}).survey;
    EXPECT_EQ(survey.holes[0].at.x, 0.5);
    EXPECT_EQ(*survey.holes[0].horizons[0], 2.25);
}

TEST_F(Table, comments_titles_and_blank_lines_are_passed_over) {
    const auto table = read_boreholes(
        {folder_.write("c.csv", "# made by hand\nBorehole list\n\nx,y,z,a\n0,0,1,2\n1,0,1,2\n")});
    EXPECT_EQ(table.survey.holes[0].row, 5u);
}

//! Write rows into a workbook or database; numbers as numbers.
void write_rows(const char* driver, const std::string& path, const std::string& layer,
                const std::vector<std::vector<std::string>>& rows) {
    GDALAllRegister();
    GDALDriver* maker = GetGDALDriverManager()->GetDriverByName(driver);
    ASSERT_NE(maker, nullptr);
    GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    if (!data) data.reset(maker->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* sheet = data->CreateLayer(layer.c_str(), nullptr, wkbNone, nullptr);
    ASSERT_NE(sheet, nullptr);
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
        const bool number =
            rows.size() > 1 && rows[1][i].find_first_not_of("0123456789.-") == std::string::npos;
        OGRFieldDefn field(rows[0][i].c_str(), number ? OFTReal : OFTString);
        ASSERT_EQ(sheet->CreateField(&field), OGRERR_NONE);
    }
    for (std::size_t r = 1; r < rows.size(); ++r) {
        OGRFeature feature(sheet->GetLayerDefn());
        for (std::size_t i = 0; i < rows[r].size(); ++i)
            if (!rows[r][i].empty()) feature.SetField(static_cast<int>(i), rows[r][i].c_str());
        ASSERT_EQ(sheet->CreateFeature(&feature), OGRERR_NONE);
    }
}

const std::vector<std::vector<std::string>> kWideRows{{"id", "x", "y", "z", "sand", "clay"},
                                                      {"H1", "0.25", "0", "10", "1.125", "0"},
                                                      {"H2", "5", "0", "11", "2", ""},
                                                      {"H3", "0", "5", "12", "3", "4"}};

TEST_F(Table, workbooks_keep_cells_and_row_numbers) {
    for (const char* driver : {"XLSX", "ODS"}) {
        const std::string path = folder_.path(std::string("book.") + (driver[0] == 'X' ? "xlsx" : "ods"));
        write_rows(driver, path, "Holes", kWideRows);
        const auto table = read_boreholes({path});
        ASSERT_EQ(table.survey.holes.size(), 3u) << driver;
        EXPECT_EQ(codes(table.survey), "sand clay");
        EXPECT_EQ(table.survey.holes[0].at.x, 0.25);
        EXPECT_EQ(told(table.survey.holes[0]), "1.125 0");
        EXPECT_EQ(told(table.survey.holes[1]), ">2 ?");
        EXPECT_EQ(table.survey.holes[2].row, 4u);
    }
}

TEST_F(Table, sheet_that_fits_is_chosen_or_named) {
    const std::string path = folder_.path("book.xlsx");
    write_rows("XLSX", path, "Notes", {{"who", "what"}, {"me", "drilled"}});
    write_rows("XLSX", path, "Holes", kWideRows);
    const auto table = read_boreholes({path});
    EXPECT_EQ(table.survey.holes.size(), 3u);
    EXPECT_EQ(count_warnings(table.audit, "of 2 sheets or layers, Holes is read"), 1u);
    EXPECT_EQ(read_boreholes({path + ":Holes"}).audit.warning_count(), 0u);
    EXPECT_NE(refusal(path + ":Wells").find("no sheet or layer Wells; it has Notes, Holes"),
              std::string::npos);
}

TEST_F(Table, workbook_with_collars_and_intervals_needs_no_option) {
    const std::string path = folder_.path("site.xlsx");
    write_rows("XLSX", path, "Collars",
               {{"hole", "x", "y", "z"}, {"A", "0", "0", "9"}, {"B", "1", "0", "9"}});
    write_rows(
        "XLSX", path, "Logs",
        {{"hole", "from", "to", "unit"}, {"A", "0", "1", "s"}, {"A", "1", "2", "c"}, {"B", "0", "1", "s"}});
    const auto table = read_boreholes({path});
    EXPECT_EQ(told(table.survey.holes[0]), "1 >1");
    EXPECT_EQ(table.survey.holes.size(), 2u);
}

TEST_F(Table, database_layer_and_point_geometry) {
    const std::string path = folder_.path("holes.gpkg");
    GDALAllRegister();
    {
        GDALDatasetUniquePtr data(GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
            path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRLayer* layer = data->CreateLayer("contacts", nullptr, wkbPoint, nullptr);
        OGRFieldDefn z("z", OFTReal), unit("formation", OFTString);
        ASSERT_EQ(layer->CreateField(&z), OGRERR_NONE);
        ASSERT_EQ(layer->CreateField(&unit), OGRERR_NONE);
        for (int i = 0; i < 4; ++i) {
            OGRFeature feature(layer->GetLayerDefn());
            OGRPoint at(500000.125 + i / 2, 4649776.22483);
            feature.SetGeometry(&at);
            feature.SetField("z", 10.0 - 5 * (i % 2));
            feature.SetField("formation", i % 2 ? "low" : "high");
            ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
        }
    }
    const auto table = read_boreholes({path});
    ASSERT_EQ(table.survey.holes.size(), 2u);
    EXPECT_EQ(table.survey.holes[0].at, (Point2{500000.125, 4649776.22483}));
    EXPECT_EQ(elevations(table.survey.holes[1]), "10 5");
}

TEST_F(Table, what_is_no_table_is_refused_in_words) {
    EXPECT_NE(refusal(folder_.path("missing.csv")).find("no such file"), std::string::npos);
    EXPECT_NE(refusal(folder_.path("missing.gpkg")).find("can be opened"), std::string::npos);
    EXPECT_NE(refusal(folder_.path("")).find("directory"), std::string::npos);
    EXPECT_NE(refusal(folder_.write("empty.csv", "")).find("empty"), std::string::npos);
    EXPECT_NE(refusal(folder_.write("blank.csv", "\n\n \n")).find("no rows"), std::string::npos);
    EXPECT_NE(refusal(folder_.write("header.csv", "x,y,z,a\n")).find("no rows"), std::string::npos);
    EXPECT_NE(refusal(folder_.write("nul.csv", std::string("x,y\n1,\0002\n", 9))).find("NUL byte"),
              std::string::npos);
    EXPECT_NE(refusal(folder_.write("prose.csv", "It was a dark and stormy night.\nThe end.\n"))
                  .find("no borehole table"),
              std::string::npos);
    EXPECT_NE(refusal(folder_.write("quote.csv", "x,y,z,a\n1,\"2,3,4\n1,2,3,4\n")).find("never closes"),
              std::string::npos);
    EXPECT_NE(refusal(folder_.write("long.csv", std::string(5000000, 'x'))).find("more than 100000 bytes"),
              std::string::npos);
    EXPECT_NE(refusal(folder_.write("wide.csv", std::string(200000, ','))).find("more than 10000 cells"),
              std::string::npos);
    std::string junk;
    for (int i = 0; i < 100000; ++i) junk.push_back(static_cast<char>((i * 7919 + i / 13) % 255 + 1));
    EXPECT_NE(refusal(folder_.write("junk.csv", junk)), "(read)");
    for (const char* name : {"junk.xlsx", "junk.ods", "junk.xls", "junk.gpkg", "junk.bin"})
        EXPECT_NE(refusal(folder_.write(name, junk)), "(read)") << name;
}

}  // namespace
}  // namespace stratareeb
