// SPDX-License-Identifier: GPL-3.0-or-later
// The commands report and deliver and what they stand on: io/report_figures, io/write_report, io/model_tables, io/read_record,
// io/html_table, io/base64, reeb/readable_graph.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "io/base64.h"
#include "io/html_table.h"
#include "io/read_record.h"
#include "reeb/readable_graph.h"
#include "tests/run_program.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(Base64, the_vectors_of_rfc_4648) {
    const std::map<std::string, std::string> vectors{{"", ""},
                                                     {"f", "Zg=="},
                                                     {"fo", "Zm8="},
                                                     {"foo", "Zm9v"},
                                                     {"foob", "Zm9vYg=="},
                                                     {"fooba", "Zm9vYmE="},
                                                     {"foobar", "Zm9vYmFy"},
                                                     {"\xff\xfe", "//4="}};
    for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
}

TEST(HtmlTable, numbers_are_written_in_full_with_parted_thousands) {
    EXPECT_EQ(grouped_number(2910519.4, 6), "2\u202f910\u202f519");
    EXPECT_EQ(grouped_number(-52643.74, 6), "-52\u202f643.7");
    EXPECT_EQ(grouped_number(9999, 4), "9999");
    EXPECT_EQ(grouped_number(0.15774, 4), "0.158");
    EXPECT_EQ(grouped_number(0, 4), "0.000");
    EXPECT_EQ(grouped_number(1.25e-7, 3), "1.25e-07");
    EXPECT_EQ(grouped_number(NAN, 3), "–");
}

TEST(ReadableGraph, keeps_the_loops_and_drops_what_is_small) {
    const TriMesh ring = half_edge_mesh(shapes::torus(3, 1, 60, 40));
    const ReadableGraph upright = readable_graph(ring, height_field(ring, {1, 0, 0}), 60);
    EXPECT_EQ(upright.share, 0);
    EXPECT_EQ(upright.graph.loops(), 1U);
    EXPECT_EQ(upright.graph.nodes.size(), 4U);
    ScalarField rough = height_field(ring, {1, 0, 0});  // a range of 8
    for (std::size_t v = 0; v < rough.size(); ++v)
        rough[v] += 0.2 * std::sin(12.9898 * static_cast<double>(v));
    const ReadableGraph readable = readable_graph(ring, rough, 10);
    EXPECT_GT(readable.fine.nodes.size(), 40U);
    EXPECT_LE(readable.graph.nodes.size(), 10U);
    EXPECT_GT(readable.share, 0);
    EXPECT_EQ(readable.graph.loops(), 1U);
}

// A survey whose names would break a page that does not escape them.
class ReportCommand : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        std::ofstream table(*folder_ / "t.csv");
        table << "id,x,y,ground,<b>&loam,sand,</style><script>\n";
        for (int i = 0; i < 5; ++i)
            for (int k = 0; k < 5; ++k)
                table << "H" << i << k << ',' << 100 * i + 7 * k << ',' << 90 * k - 5 * i << ',' << 50 + i - k
                      << ',' << 2 + i % 3 << ',' << (i < 2 ? 0 : 1 + k) << ',' << 4 + (i * k) % 3 << '\n';
        table.close();
        const ProgramResult built = run_program(*folder_, "build t.csv -o model --refine 0");
        ASSERT_EQ(built.exit_code, 0) << built.err;
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }
    static TemporaryFolder* folder_;
};
TemporaryFolder* ReportCommand::folder_ = nullptr;

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

TEST_F(ReportCommand, writes_one_page_that_needs_nothing_else) {
    const ProgramResult run = run_program(*folder_, "report model --title 'A <i>title</i>'");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string html = content_of(*folder_ / "model/report.html");
    EXPECT_NE(html.find("A &lt;i&gt;title"), std::string::npos);
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<b>&loam"), std::string::npos);
    EXPECT_EQ(count_of(html, "</style>"), 1U);
    const std::regex source("src=\"([^\"]{0,40})");
    std::size_t images = 0;
    for (std::sregex_iterator it(html.begin(), html.end(), source), end; it != end; ++it, ++images)
        EXPECT_TRUE((*it)[1].str().starts_with("data:image/")) << (*it)[1];
    // The model, 3 layers, 2 sections, 2 maps and 2 for each layer, 2 of errors, 3 graphs.
    EXPECT_EQ(images, 1U + 3 + 2 + 2 + 6 + 2 + 3);
    EXPECT_EQ(count_of(html, "data:image/png;base64,iVBOR"), 7U);  // PNG's first bytes
    EXPECT_EQ(count_of(html, ">passed<"), read_record(*folder_ / "model").record.checks.size());
    for (const char* hole : {"H00", "H44"}) EXPECT_NE(html.find(hole), std::string::npos);
    for (const auto& entry : fs::directory_iterator(*folder_ / "model"))
        EXPECT_EQ(entry.path().string().find(".figures"), std::string::npos) << "scratch files stay";

    const ProgramResult again = run_program(*folder_, "report model");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_NE(again.err.find("report.html"), std::string::npos);
    ASSERT_EQ(run_program(*folder_, "report model --title 'A <i>title</i>' --overwrite").exit_code, 0);
    EXPECT_EQ(content_of(*folder_ / "model/report.html"), html);
}

TEST_F(ReportCommand, says_which_borehole_of_a_fence_is_not_there_and_writes_nothing) {
    const ProgramResult run = run_program(*folder_, "report model -o fence.html --through H00,H99");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("H99"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(*folder_ / "fence.html"));
    const ProgramResult good =
        run_program(*folder_, "report model -o fence.html --through H00,H22,H44 --no-validation");
    ASSERT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(content_of(*folder_ / "fence.html").find("Fence through H00, H22, H44"), std::string::npos);
}

TEST_F(ReportCommand, delivers_a_folder_whose_files_open_and_agree) {
    GDALAllRegister();
    const ProgramResult run =
        run_program(*folder_, "deliver model -o given --crs EPSG:27700 --through H00,H44");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const fs::path given = *folder_ / "given";
    std::istringstream list(content_of(given / "files.txt"));
    std::size_t files = 0;
    for (std::string file; std::getline(list, file); ++files) {
        ASSERT_TRUE(fs::is_regular_file(given / file)) << file;
        EXPECT_GT(fs::file_size(given / file), 0U) << file;
        if (file.ends_with(".pdf")) {
            EXPECT_TRUE(content_of(given / file).starts_with("%PDF-")) << file;
        }
        if (!file.ends_with(".gpkg") && !file.ends_with(".dxf")) continue;
        const std::unique_ptr<GDALDataset, decltype(&GDALClose)> opened(
            GDALDataset::Open((given / file).c_str(), GDAL_OF_VECTOR), &GDALClose);
        ASSERT_TRUE(opened) << file;
        EXPECT_GT(opened->GetLayer(0)->GetFeatureCount(), 0) << file;
        const OGRSpatialReference* crs = opened->GetLayer(0)->GetSpatialRef();
        if (file.ends_with(".gpkg")) {
            ASSERT_TRUE(crs) << file;
            EXPECT_STREQ(crs->GetAuthorityCode(nullptr), "27700");
        }
    }
    EXPECT_GT(files, 50U);
    const std::string html = content_of(given / "index.html");
    const std::regex address("(?:src|href)=\"([^\"]*)\"");
    for (std::sregex_iterator it(html.begin(), html.end(), address), end; it != end; ++it)
        EXPECT_TRUE(fs::exists(given / (*it)[1].str())) << (*it)[1];
}

using Rows = std::vector<std::map<std::string, std::string>>;
Rows rows_of(const fs::path& file) {
    std::istringstream lines(content_of(file));
    std::string line;
    std::getline(lines, line);
    const auto split = [](const std::string& text) {
        std::vector<std::string> cells{""};
        bool quoted = false;
        for (const char c : text) {
            if (c == '"')
                quoted = !quoted;
            else if (c == ',' && !quoted)
                cells.emplace_back();
            else
                cells.back() += c;
        }
        return cells;
    };
    const auto names = split(line);
    Rows rows;
    while (std::getline(lines, line)) {
        const auto cells = split(line);
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
    }
    return rows;
}

TEST_F(ReportCommand, tables_hold_the_models_volumes_and_logs) {
    ASSERT_EQ(run_program(*folder_, "deliver model -o tables_given --no-validation").exit_code, 0);
    const fs::path tables = *folder_ / "tables_given/tables";
    const json model = json::parse(content_of(*folder_ / "model/model.json"));
    double sum = 0;
    for (const auto& row : rows_of(tables / "volumes.csv")) sum += std::stod(row.at("volume_m3"));
    EXPECT_NEAR(sum, model["envelope_volume"].get<double>(), 1e-9 * sum);
    std::map<std::pair<std::string, std::string>, double> drilled;
    for (const auto& row : rows_of(tables / "logs.csv"))
        drilled[{row.at("hole"), row.at("order")}] = std::stod(row.at("base"));
    EXPECT_EQ(drilled.size(), 25U * 3 - 10);  // ten holes lack the sand
    std::size_t compared = 0;
    for (const auto& row : rows_of(tables / "model_logs.csv"))
        if (const auto found = drilled.find({row.at("hole"), row.at("order")}); found != drilled.end()) {
            EXPECT_NEAR(std::stod(row.at("base")), found->second, 1e-9);
            ++compared;
        }
    EXPECT_EQ(compared, drilled.size());
}

TEST_F(ReportCommand, delivering_again_clears_its_own_files_and_no_others) {
    ASSERT_EQ(run_program(*folder_, "deliver model -o twice --no-validation --through H00,H11").exit_code, 0);
    std::ofstream(*folder_ / "twice/letter.txt") << "mine";
    EXPECT_EQ(run_program(*folder_, "deliver model -o twice --no-validation").exit_code, 1);
    EXPECT_TRUE(fs::exists(*folder_ / "twice/sections/fence_1.svg"));
    ASSERT_EQ(run_program(*folder_, "deliver model -o twice --no-validation --overwrite").exit_code, 0);
    EXPECT_FALSE(fs::exists(*folder_ / "twice/sections/fence_1.svg"));
    EXPECT_EQ(content_of(*folder_ / "twice/letter.txt"), "mine");
}

TEST_F(ReportCommand, a_damaged_record_is_refused_with_its_place) {
    fs::copy(*folder_ / "model", *folder_ / "damaged", fs::copy_options::recursive);
    json model = json::parse(content_of(*folder_ / "model/model.json"));
    model["units"][1]["volume"] = "much";
    model["checks"] = 3;
    std::ofstream(*folder_ / "damaged/model.json") << model;
    const ProgramResult run = run_program(*folder_, "report damaged -o damaged.html");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("units[1].volume"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("checks"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(*folder_ / "damaged.html"));
}

}  // namespace
}  // namespace stratareeb
