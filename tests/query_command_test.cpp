// SPDX-License-Identifier: GPL-3.0-or-later
// A saved model read back (io/read_model, io/model_holes), and asked through the command query (io/read_places).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/read_boreholes.h"
#include "io/read_model.h"
#include "mesh/model_summary.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kHoles =
    "hole,x,y,ground,Sand,Clay,Gravel\n"
    "A,500000,0,10,2,3,1\n"
    "B,500100,0,11,2,0,1\n"
    "C,500100,100,12,2,3,1\n"
    "D,500000,100,10,2,3,1\n"
    "E,500050,40,10,2,3,>1.5\n"
    "F,500080,60,10.5,2,3,\n";

class QueryCommand : public testing::Test {
 protected:
    QueryCommand() {
        folder_.file("holes.csv", kHoles);
        const auto result = run_program(folder_, "build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    json query(const std::string& arguments) const {
        const auto result = run("query model --json " + arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out);
    }
    void expect_failure(const std::string& arguments, int exit_code, const std::string& words) const {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, exit_code) << arguments;
        EXPECT_EQ(result.out, "") << arguments;
        EXPECT_NE(result.err.find(words), std::string::npos) << arguments << ": " << result.err;
    }
    //! What reading the folder says after one of its files was changed.
    std::string complaint() const {
        try {
            read_model(folder_ / "model");
        } catch (const InvalidInput& error) {
            return error.what();
        } catch (const IoError& error) {
            return error.what();
        }
        return "";
    }
    void change(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = content_of(folder_ / "model" / name);
        const auto at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        std::ofstream(folder_ / "model" / name, std::ios::binary) << text.replace(at, from.size(), to);
    }

    TemporaryFolder folder_;
};

TEST_F(QueryCommand, a_saved_model_reads_back_as_it_was) {
    const SavedModel saved = read_model(folder_ / "model");
    const Survey survey = read_boreholes({(folder_ / "holes.csv").string()}, {}).survey;
    const LayerModel model = build_layer_model(survey);
    EXPECT_EQ(saved.model.origin, model.origin);
    EXPECT_EQ(saved.model.length_unit, "m");
    EXPECT_EQ(saved.model.horizons, model.horizons);
    EXPECT_EQ(saved.model.plan.hole_vertex, model.plan.hole_vertex);
    EXPECT_EQ(saved.model.regions.in_face, model.regions.in_face);
    EXPECT_EQ(saved.model.regions.zero_at, model.regions.zero_at);
    ASSERT_EQ(saved.survey.holes.size(), survey.holes.size());
    for (std::size_t h = 0; h < survey.holes.size(); ++h) {
        const Borehole &a = saved.survey.holes[h], &b = survey.holes[h];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.at, b.at);
        EXPECT_EQ(a.row, b.row);
        EXPECT_EQ(a.horizons, b.horizons);
        for (std::size_t i = 0; i < survey.units.size(); ++i) {
            EXPECT_EQ(a.layers[i].knowledge, b.layers[i].knowledge);
            EXPECT_EQ(a.layers[i].thickness, b.layers[i].thickness);
        }
    }
    std::vector<UnitSummary> units;
    for (std::size_t i = 0; i < survey.units.size(); ++i)
        units.push_back(summarize_unit(saved.model, build_layer_solid(saved.model, i), saved.survey));
    for (const ModelCheck& check : check_model(saved.model, saved.survey, units))
        EXPECT_TRUE(check.ok) << check.name << ": " << check.detail;
}

TEST_F(QueryCommand, gives_the_log_at_a_place) {
    const json log = query("--at 500000,0");
    EXPECT_EQ(log["x"], 500000);
    ASSERT_EQ(log["units"].size(), 3u);
    EXPECT_NEAR(log["units"][0]["top"].get<double>(), 10, 1e-9);
    EXPECT_NEAR(log["units"][1]["thickness"].get<double>(), 3, 1e-9);
    EXPECT_NEAR(log["units"][2]["base"].get<double>(), 4, 1e-9);
    EXPECT_FALSE(log.contains("unit"));
    EXPECT_EQ(query("--at 500100,0")["units"][1]["thickness"], 0.0);
    EXPECT_EQ(query("--at 500000,0,6")["unit"], "Clay");
    EXPECT_EQ(query("--at 500000,0,4.5")["unit"], "Gravel");
    EXPECT_EQ(query("--at 500000,0,11")["unit"], nullptr);
    const auto text = run("query model --at 500000,0,3");
    EXPECT_NE(text.out.find("base [m]"), std::string::npos);
    EXPECT_NE(text.out.find("at z 3: below the model"), std::string::npos);
}

TEST_F(QueryCommand, answers_a_table_of_places) {
    folder_.file("places.csv", "Name;Easting;Northing;z\none;500000;0;6\ntwo;500050,5;50;\nfar;1;1;5\n");
    EXPECT_EQ(run("query model --points places.csv -o answers.csv").exit_code, 0);
    const std::string answers = content_of(folder_ / "answers.csv");
    EXPECT_EQ(answers.substr(0, answers.find('\n')), "id,x,y,z,unit,ground,Sand,Clay,Gravel,base");
    EXPECT_NE(answers.find("\none,500000,0,6,Clay,10,2,3,1,4\n"), std::string::npos) << answers;
    EXPECT_NE(answers.find("\nfar,1,1,5,,,,,,\n"), std::string::npos) << answers;
    const json list = query("--points places.csv");
    ASSERT_EQ(list.size(), 3u);
    EXPECT_EQ(list[0]["unit"], "Clay");
    EXPECT_EQ(list[1]["id"], "two");
    EXPECT_EQ(list[1]["x"], 500050.5);
    EXPECT_EQ(list[2]["inside"], false);
    expect_failure("query model --points places.csv -o answers.csv", 1, "--overwrite");
    EXPECT_EQ(content_of(folder_ / "answers.csv"), answers);
}

TEST_F(QueryCommand, says_what_is_wrong_with_a_question) {
    const auto outside = run("query model --at 0,0");
    EXPECT_EQ(outside.exit_code, 1);
    EXPECT_NE(outside.out.find("outside the model's footprint"), std::string::npos);
    expect_failure("query model", 2, "--at x,y[,z] or --points FILE");
    expect_failure("query model --at 1", 2, "x,y or x,y,z");
    expect_failure("query model --at 1,nan", 2, "finite");
    expect_failure("query nothing --at 1,2", 1, "not a folder");
    expect_failure("query . --at 1,2", 1, "no model.json");
    folder_.file("bad.csv", "x,y\n1,2\n3,there\n,4\n");
    expect_failure("query model --points bad.csv -o a.csv", 1, "bad.csv:3: column y: \"there\" is no number");
    expect_failure("query model --points bad.csv -o a.csv", 1, "bad.csv:4: column x: is empty");
    folder_.file("other.csv", "a,b\n1,2\n");
    expect_failure("query model --points other.csv -o a.csv", 1, "the columns are a, b");
    folder_.file("none.csv", "x,y\n");
    expect_failure("query model --points none.csv -o a.csv", 1, "none.csv");
    EXPECT_FALSE(fs::exists(folder_ / "a.csv"));
}

TEST_F(QueryCommand, refuses_a_damaged_model_with_the_file_and_the_place) {
    change("boreholes.json", "\"vertex\":1,", "\"vertex\":999999,");
    EXPECT_NE(complaint().find("holes[1].vertex: is 999999"), std::string::npos) << complaint();
    change("boreholes.json", "\"vertex\":999999,", "\"vertex\":1,");
    change("boreholes.json", "\"layers\":[2.0,0.0,1.0]", "\"layers\":[2.0,0.0]");
    EXPECT_NE(complaint().find("holes[1].layers: has 2 entries (expected 3)"), std::string::npos)
        << complaint();
    fs::remove(folder_ / "model" / "boreholes.json");
    EXPECT_EQ(complaint(), "");
    EXPECT_TRUE(read_model(folder_ / "model").survey.holes.empty());

    fs::rename(folder_ / "model/horizons/00_ground.ply", folder_ / "ground.ply");
    EXPECT_NE(complaint().find("00_ground.ply"), std::string::npos) << complaint();
    fs::copy(folder_ / "model/horizons/03_Gravel.ply", folder_ / "model/horizons/00_ground.ply");
    EXPECT_NE(complaint().find("above the horizon over it"), std::string::npos) << complaint();
    folder_.file("model/horizons/00_ground.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                 "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_NE(complaint().find("not the same points in x, y and triangles"), std::string::npos)
        << complaint();
    change("model.json", "\"origin\": [", "\"origin\": [1, ");
    EXPECT_NE(complaint().find("origin"), std::string::npos) << complaint();
    folder_.file("model/model.json", "[]");
    EXPECT_NE(complaint().find("expected a model"), std::string::npos) << complaint();
}

}  // namespace
}  // namespace stratareeb
