// SPDX-License-Identifier: GPL-3.0-or-later
// The command build as a user runs it: files, JSON, exit codes, and every shared borehole set.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/run_program.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Sand everywhere, clay absent in two holes, gravel unknown in one; the last hole ends inside the clay.
constexpr const char* kWide =
    "x,y,ground,Sand,Clay,Gravel\n"
    "0,0,10,2,3,1\n"
    "100,0,11,2,0,1\n"
    "100,100,12,2,3,1\n"
    "0,100,10,2,3,1\n"
    "50,40,10,2,3,1\n"
    "20,70,10.5,2,0,1\n"
    "80,60,10.5,2,3,\n";

constexpr const char* kAllFormats = "ply,stl,obj,off,glb,3mf,mlp,step,png";

bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

//! Every file of a folder with its content, by relative name.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            contents[entry.path().lexically_relative(folder).generic_string()] = content_of(entry.path());
    return contents;
}

std::set<std::string> names_of(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& [name, content] : contents_of(folder)) names.insert(name);
    return names;
}

class BuildCommand : public testing::Test {
 protected:
    BuildCommand() { folder_.file("holes.csv", kWide); }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    //! The build must fail with the code, say the words, and leave the folder as it was.
    void expect_failure(const std::string& arguments, int exit_code,
                        const std::vector<std::string>& words) const {
        const auto before = contents_of(folder_.path());
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, exit_code) << arguments;
        EXPECT_EQ(result.out, "") << arguments;
        for (const std::string& word : words)
            EXPECT_TRUE(says(result.err, word)) << word << "\n" << result.err;
        EXPECT_EQ(contents_of(folder_.path()), before) << arguments;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            EXPECT_FALSE(says(entry.path().filename().string(), ".part")) << entry.path();
    }

    TemporaryFolder folder_;
};

TEST_F(BuildCommand, records_what_auto_compared) {
    const auto result = run("build holes.csv -o out --interpolator auto --rule Gravel=base --spacing 20");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto record = nlohmann::json::parse(content_of(folder_ / "out/model.json"));
    EXPECT_EQ(record["auto"]["candidates"].size(), 6u);
    EXPECT_EQ(record["auto"]["quantities"].size(), 6u);
    EXPECT_TRUE(says(record["warnings"].dump(), record["auto"]["reason"].get<std::string>()));
    EXPECT_TRUE(says(content_of(folder_ / "out/auto.csv"), "quantity,held_out,linear,natural,"));
    EXPECT_TRUE(says(record["files"].dump(), "auto.csv"));
    ASSERT_EQ(run("build holes.csv -o out --overwrite --spacing 20").exit_code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/auto.csv")) << "of an earlier model";
}

TEST_F(BuildCommand, leaves_out_triangles_of_every_block_between_faults) {
    const std::string graben = STRATAREEB_SOURCE_DIR "/examples/graben/";
    const auto plan_triangles = [&](const std::string& options) {
        const auto result = run("build '" + graben + "holes.csv' --faults '" + graben +
                                "faults.geojson' -o out --overwrite --json --refine 0" + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(result.out)["plan_triangles"].get<std::size_t>();
    };
    ASSERT_GT(plan_triangles(""), 1000u);
    const std::size_t left = plan_triangles(" --decimate-to 500");
    EXPECT_GT(left, 450u);
    EXPECT_LT(left, 800u);  // with what joins the blocks
}

TEST_F(BuildCommand, makes_horizons_layers_and_a_record) {
    const auto result = run("build holes.csv -o out");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(names_of(folder_ / "out"),
              (std::set<std::string>{"boreholes.json", "model.json", "horizons/00_ground.ply",
                                     "horizons/01_Sand.ply", "horizons/02_Clay.ply", "horizons/03_Gravel.ply",
                                     "unrefined/00_ground.ply", "unrefined/01_Sand.ply",
                                     "unrefined/02_Clay.ply", "unrefined/03_Gravel.ply", "layers/01_Sand.ply",
                                     "layers/02_Clay.ply", "layers/03_Gravel.ply"}));
    EXPECT_TRUE(says(result.out, "7 boreholes, 3 layers")) << result.out;
    EXPECT_EQ(folder_.size(), 2u) << "nothing beside the table and the model";
}

TEST_F(BuildCommand, makes_every_format_asked_for) {
    const auto result = run(std::string("build holes.csv -o out --spacing 20 --formats ") + kAllFormats);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto names = names_of(folder_ / "out");
    for (const char* name :
         {"model.obj", "model.mtl", "model.glb", "model.3mf", "model.mlp", "model.step", "model.png"})
        EXPECT_TRUE(names.contains(name)) << name;
    for (const char* layer : {"01_Sand", "02_Clay", "03_Gravel"})
        for (const char* format : {"ply", "stl", "off"})
            EXPECT_TRUE(names.contains(std::string("layers/") + layer + "." + format)) << layer << format;
    const json record = json::parse(content_of(folder_ / "out/model.json"));
    EXPECT_EQ(std::set<std::string>(record["files"].begin(), record["files"].end()), names);
}

TEST_F(BuildCommand, makes_solids_that_check_finds_watertight) {
    ASSERT_EQ(run("build holes.csv -o out --formats stl,off").exit_code, 0);
    EXPECT_EQ(run("check out/layers/01_Sand.ply out/layers/02_Clay.ply out/layers/03_Gravel.ply").exit_code,
              0);
    EXPECT_EQ(run("check out/layers/*.stl out/layers/*.off").exit_code, 0);
    EXPECT_EQ(run("check out/horizons/00_ground.ply").exit_code, 1) << "an open surface";
}

TEST_F(BuildCommand, prints_the_record_as_json_and_nothing_else) {
    const auto result = run("build holes.csv -o out --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, content_of(folder_ / "out/model.json"));
    const json record = json::parse(result.out);
    EXPECT_EQ(record["boreholes"], 7);
    EXPECT_EQ(record["origin"].size(), 3u);
    double sum = 0;
    for (std::size_t i = 0; i < record["units"].size(); ++i) {
        const json& unit = record["units"][i];
        for (const char* key : {"order", "code", "name", "color", "volume", "area", "components", "genus",
                                "solid", "top", "base", "holes_present", "holes_absent", "holes_unknown"})
            EXPECT_TRUE(unit.contains(key)) << key;
        for (const char* path : {"solid", "top", "base"})
            EXPECT_TRUE(fs::exists(folder_ / "out" / unit[path].get<std::string>())) << unit[path];
        sum += unit["volume"].get<double>();
    }
    EXPECT_NEAR(sum, record["envelope_volume"].get<double>(), 1e-9 * sum);
    EXPECT_EQ(record["units"][1]["holes_present"], 5);
    EXPECT_EQ(record["units"][1]["holes_absent"], 2);
    EXPECT_EQ(record["units"][2]["holes_unknown"], 1);
    for (const json& check : record["checks"]) EXPECT_EQ(check["ok"], true) << check;
    EXPECT_LE(record["misfit"]["max"].get<double>(), 1e-9 * 100);
    EXPECT_TRUE(record["misfit"].contains("rms"));
}

TEST_F(BuildCommand, measures_what_check_measures_in_its_files) {
    const json record = json::parse(run("build holes.csv -o out --json").out);
    const json report = json::parse(
        run("check out/layers/01_Sand.ply out/layers/02_Clay.ply out/layers/03_Gravel.ply --json").out);
    for (std::size_t i = 0; i < 3; ++i)
        for (const char* key : {"volume", "area"})
            EXPECT_NEAR(record["units"][i][key].get<double>(), report[i][key].get<double>(),
                        1e-9 * report[i][key].get<double>());
    EXPECT_NEAR(record["units"][0]["volume"].get<double>(), 100 * 100 * 2, 1e-5)
        << "sand is 2 thick everywhere";
}

// Two layers in two bodies each: what goes by address in memory shows as another order of their colours.
TEST_F(BuildCommand, gives_the_same_bytes_each_time) {
    std::string table = "x,y,ground,Sand,Clay,Silt\n";
    for (const int x : {0, 50, 100})
        for (const int y : {0, 50, 100}) {
            const std::string place = std::to_string(x) + "," + std::to_string(y);
            table += place + ",10,1," + (x == 50 ? "0,1\n" : y == 50 ? "2,0\n" : "2,1\n");
        }
    folder_.file("bodies.csv", table);
    const std::string options = std::string(" --overwrite --spacing 40 --formats ") + kAllFormats;
    ASSERT_EQ(run("build bodies.csv -o one" + options).exit_code, 0);
    const auto one = contents_of(folder_ / "one");
    for (int again = 0; again < 3; ++again) {
        ASSERT_EQ(run("build bodies.csv -o two" + options).exit_code, 0);
        const auto two = contents_of(folder_ / "two");
        ASSERT_EQ(one.size(), two.size());
        for (const auto& [name, content] : one) EXPECT_TRUE(content == two.at(name)) << name;
    }
}

TEST_F(BuildCommand, is_quiet_in_a_pipe) {
    folder_.file("plain.csv", "x,y,ground,Sand\n0,0,5,1\n9,0,5,1\n0,9,5,1\n9,9,5,1\n4,5,5,2\n");
    const auto result = run("build plain.csv -o out");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_FALSE(says(result.out, "\r"));
    EXPECT_FALSE(says(result.out, "\x1b"));
}

TEST_F(BuildCommand, refuses_a_folder_that_is_there_unless_told) {
    ASSERT_EQ(run("build holes.csv -o out").exit_code, 0);
    expect_failure("build holes.csv -o out", 1, {"out: is there already", "--overwrite"});
    EXPECT_EQ(run("build holes.csv -o out --overwrite").exit_code, 0);
}

TEST_F(BuildCommand, overwriting_removes_its_own_old_files_and_keeps_the_users) {
    ASSERT_EQ(run("build holes.csv -o out --spacing 30 --formats stl").exit_code, 0);
    folder_.file("out/notes.txt", "mine");
    ASSERT_EQ(run("build holes.csv -o out --spacing 30 --overwrite").exit_code, 0);
    const auto names = names_of(folder_ / "out");
    EXPECT_FALSE(names.contains("layers/01_Sand.stl"));
    EXPECT_TRUE(names.contains("layers/01_Sand.ply"));
    EXPECT_EQ(content_of(folder_ / "out/notes.txt"), "mine");
}

TEST_F(BuildCommand, leaves_an_earlier_model_alone_when_it_fails) {
    ASSERT_EQ(run("build holes.csv -o out --spacing 30").exit_code, 0);
    folder_.file("bad.csv", "x,y,ground,Sand\n0,0,5,1\n9,0,five,1\n0,9,5,1\n");
    expect_failure("build bad.csv -o out --overwrite", 1, {"bad.csv:3"});
}

TEST_F(BuildCommand, names_file_and_row_of_what_it_cannot_use) {
    folder_.file("bad.csv", "x,y,ground,Sand,Clay\n0,0,5,1,1\n9,0,five,1,1\n0,9,5,-1,1\n9,9,5,1,1\n");
    expect_failure("build bad.csv -o out", 1, {"bad.csv:3", "five", "bad.csv:4", "-1"});
    expect_failure("build none.csv -o out", 1, {"none.csv"});
    folder_.file("line.csv", "x,y,ground,Sand\n0,0,5,1\n5,5,5,1\n9,9,5,1\n");
    expect_failure("build line.csv -o out", 1, {"line"});
    folder_.file("empty.csv", "");
    expect_failure("build empty.csv -o out", 1, {"empty.csv"});
}

TEST_F(BuildCommand, calls_wrong_usage_by_exit_code_2) {
    expect_failure("build", 2, {});
    expect_failure("build holes.csv", 2, {"--output"});
    expect_failure("build holes.csv -o out --interpolator cubic", 2, {"--interpolator"});
    expect_failure("build holes.csv -o out --pinch-out tenth", 2, {"--pinch-out"});
    expect_failure("build holes.csv -o out --spacing -3", 2, {"--spacing"});
    expect_failure("build holes.csv -o out --formats ply,dwg", 2, {"--formats"});
    expect_failure("build holes.csv -o out --no-such-option", 2, {"--no-such-option"});
}

TEST_F(BuildCommand, refuses_a_run_beyond_all_memory_before_it_starts) {
    expect_failure("build holes.csv -o out --spacing 0.00001", 1, {"GiB", "--spacing", "--ignore-memory"});
}

TEST_F(BuildCommand, refuses_output_that_cannot_be) {
    expect_failure("build holes.csv -o holes.csv", 1, {"is a file, not a folder"});
    expect_failure("build holes.csv -o holes.csv/out", 1, {"can't be made"});
}

TEST_F(BuildCommand, warns_of_what_it_worked_around_and_can_be_told_not_to) {
    folder_.file("twice.csv", std::string(kWide) + "0,0,10,2,3,1\n");
    const auto loud = run("build twice.csv -o out --spacing 30"),
               quiet = run("build twice.csv -o two --spacing 30 --quiet");
    EXPECT_EQ(loud.exit_code, 0) << loud.err;
    EXPECT_TRUE(says(loud.err, "warning: twice.csv:9")) << loud.err;
    EXPECT_EQ(quiet.err, "");
    EXPECT_FALSE(json::parse(content_of(folder_ / "two/model.json"))["warnings"].empty());
}

TEST_F(BuildCommand, takes_a_box_and_a_polygon_as_footprint) {
    const auto sand = [&](const std::string& options) {
        const auto result = run("build holes.csv -o out --overwrite --json --spacing 10 " + options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out)["units"][0]["volume"].get<double>();
    };
    EXPECT_NEAR(sand("--footprint box --margin 5"), 110 * 110 * 2, 1e-6);
    folder_.file("outline.geojson",
                 R"({"type":"Polygon","coordinates":[[[10,10],[60,10],[60,60],[10,60],[10,10]]]})");
    EXPECT_NEAR(sand("--footprint outline.geojson"), 50 * 50 * 2, 1e-6);
}

TEST_F(BuildCommand, drapes_the_model_on_a_ground_raster) {
    std::string grid = "ncols 4\nnrows 4\nxllcorner -50\nyllcorner -50\ncellsize 50\n";
    for (int row = 0; row < 4; ++row) grid += "70 70 70 70\n";
    folder_.file("ground.asc", grid);
    folder_.file("bare.csv", "x,y,Sand\n0,0,2\n100,0,2\n100,100,2\n0,100,2\n");
    const auto result = run("build bare.csv -o out --ground ground.asc --json --spacing 20");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json report = json::parse(run("check out/layers/01_Sand.ply --json").out);
    EXPECT_NEAR(report[0]["box"][1][2].get<double>() + json::parse(result.out)["origin"][2].get<double>(), 70,
                1e-9);
}

TEST_F(BuildCommand, reads_interval_tables_with_collars) {
    folder_.file("collars.csv", "hole,x,y,ground\nA,0,0,10\nB,50,0,10\nC,0,50,10\nD,50,50,10\n");
    folder_.file("intervals.csv",
                 "hole,from,to,unit\nA,0,2,sand\nA,2,5,clay\nB,0,2,sand\nB,2,5,clay\nC,0,2,sand\nC,2,5,clay\n"
                 "D,0,2,sand\nD,2,5,clay\n");
    const auto result = run("build intervals.csv --collars collars.csv -o out --json --spacing 20");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json record = json::parse(result.out);
    EXPECT_EQ(record["units"][0]["code"], "sand");
    EXPECT_NEAR(record["units"][0]["volume"].get<double>(), 5000, 1e-6);
}

// All shared borehole sets.

struct SharedSet {
    const char* name;
    const char* arguments;  // D/ is the data folder
};

void PrintTo(const SharedSet& set, std::ostream* stream) {
    *stream << set.arguments;
}

class SharedSets : public testing::TestWithParam<SharedSet> {
 protected:
    static fs::path data() { return STRATAREEB_SOURCE_DIR "/../shared/data"; }
    static std::string arguments(const std::string& text) {
        std::string result;
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text.compare(i, 2, "D/") == 0 && (i == 0 || text[i - 1] == ' '))
                result += fs::weakly_canonical(data()).string() + "/", ++i;
            else
                result += text[i];
        return result;
    }
    TemporaryFolder folder_;
};

double size_of(const json& reports) {
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    for (const json& report : reports)
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], report["box"][0][k].get<double>());
            high[k] = std::max(high[k], report["box"][1][k].get<double>());
        }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

TEST_P(SharedSets, make_sound_models_through_every_contact) {
    if (!fs::exists(data())) GTEST_SKIP() << "no shared data here";
    const auto built = run_program(folder_, "build " + arguments(GetParam().arguments) + " -o out --json");
    ASSERT_EQ(built.exit_code, 0) << built.err.substr(0, 2000);
    const json record = json::parse(built.out);
    for (const json& check : record["checks"]) EXPECT_EQ(check["ok"], true) << check;
    EXPECT_GT(record["misfit"]["contacts"].get<int>(), 0);

    const auto checked = run_program(folder_, "check out/layers/*.ply --json");
    EXPECT_EQ(checked.exit_code, 0);
    const json reports = json::parse(checked.out);
    for (const json& report : reports) EXPECT_EQ(report["watertight"], true) << report["file"];
    EXPECT_LE(record["misfit"]["max"].get<double>(), 1e-9 * size_of(reports));

    std::size_t solids = 0;
    for (const json& unit : record["units"]) {
        if (unit["solid"].is_null()) continue;
        const auto report = std::ranges::find_if(reports, [&](const json& r) {
            return fs::path(r["file"].get<std::string>()).filename() ==
                   fs::path(unit["solid"].get<std::string>()).filename();
        });
        ASSERT_NE(report, reports.end()) << unit["solid"];
        EXPECT_EQ((*report)["components"], unit["components"]) << unit["solid"];
        EXPECT_EQ((*report)["genus"], unit["genus"]) << unit["solid"];
        EXPECT_NEAR((*report)["volume"].get<double>(), unit["volume"].get<double>(),
                    1e-9 * unit["volume"].get<double>());
        ++solids;
    }
    EXPECT_EQ(solids, reports.size());
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedSets,
    testing::Values(
        SharedSet{"thesis_1", "D/thesis/thesis_sample1_wide_noheader.csv"},
        SharedSet{"thesis_1_header", "D/thesis/thesis_sample1.csv"},
        SharedSet{"thesis_1_xlsx", "D/thesis/thesis_sample1.xlsx"},
        SharedSet{"thesis_2", "D/thesis/thesis_sample2_wide_noheader.csv"},
        SharedSet{"thesis_3", "D/thesis/thesis_sample3_wide_noheader.csv"},
        SharedSet{"thesis_3_bare",
                  "D/thesis/thesis_sample3_wide_noheader.csv --spacing none --interpolator linear "
                  "--pinch-out at-hole"},
        SharedSet{"thesis_table_4_1", "D/thesis/table_4_1_wide_noheader.csv"},
        SharedSet{"thesis_table_4_1_xlsx", "D/thesis/table_4_1.xlsx"},
        SharedSet{"sighthill_xlsx", "D/ags_uk/sighthill/wide.xlsx"},
        SharedSet{"sighthill_intervals",
                  "D/ags_uk/sighthill/intervals.csv --collars D/ags_uk/sighthill/collars.csv"},
        SharedSet{"sighthill_stratigraphy",
                  "D/ags_uk/sighthill/stratigraphy.csv --collars D/ags_uk/sighthill/collars.csv"},
        SharedSet{"wigan_intervals",
                  "D/ags_uk/wigan_depot/intervals.csv --collars D/ags_uk/wigan_depot/collars.csv"},
        SharedSet{"wigan_wide", "D/ags_uk/wigan_depot/wide_noheader.csv"},
        SharedSet{"dlr_city_airport",
                  "D/ags_uk/dlr_city_airport/intervals.csv --collars D/ags_uk/dlr_city_airport/collars.csv"},
        SharedSet{"teapot_shannon", "D/teapot_dome/wide_shannon.csv --unit ft"},
        SharedSet{"teapot_shannon_noheader", "D/teapot_dome/wide_shannon_noheader.csv --unit ft"},
        SharedSet{"teapot_frontier", "D/teapot_dome/wide_frontier.csv --unit ft"},
        SharedSet{"teapot_intervals",
                  "D/teapot_dome/intervals.csv --collars D/teapot_dome/collars.csv --unit ft --spacing 1500"},
        SharedSet{"teapot_points", "D/teapot_dome/top_points.csv --unit ft --spacing 1500"},
        SharedSet{"llobregat", "D/llobregat_delta/intervals.csv --collars D/llobregat_delta/collars.csv"},
        SharedSet{"louisiana", "D/louisiana_north/intervals.csv --collars D/louisiana_north/collars.csv"},
        SharedSet{"louisiana_split",
                  "D/louisiana_north/intervals.csv --collars D/louisiana_north/collars.csv --repeats split"},
        SharedSet{"louisiana_wide", "D/louisiana_north/wide_claycap_noheader.csv"},
        SharedSet{"bungendore", "D/bungendore/intervals.csv --collars D/bungendore/collars.csv"},
        SharedSet{"bungendore_terrain",
                  "D/bungendore/intervals.csv --collars D/bungendore/collars.csv --ground "
                  "D/bungendore/dem.asc"},
        SharedSet{"claudius", "D/points_models/claudius.csv --spacing 400"},
        SharedSet{"turner_syncline", "D/points_models/turner_syncline.csv"},
        SharedSet{"perth_basin", "D/points_models/perth_basin.csv"},
        SharedSet{"ales", "D/points_models/ales.csv"},
        SharedSet{"hamersley", "D/points_models/hamersley_contacts.csv"}),
    [](const auto& set) { return std::string(set.param.name); });

TEST_F(BuildCommand, refuses_a_surface_that_overhangs_and_names_the_place) {
    const fs::path points = STRATAREEB_SOURCE_DIR "/../shared/data/points_models/moureze.csv";
    if (!fs::exists(points)) GTEST_SKIP() << "no shared data here";
    expect_failure("build '" + points.string() + "' -o out", 1, {"moureze.csv:", "overhang"});
}

}  // namespace
}  // namespace stratareeb
