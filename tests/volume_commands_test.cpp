// SPDX-License-Identifier: GPL-3.0-or-later
// The command cells with io/write_vtu and io/write_msh.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cell_files.h"
#include "tests/run_program.h"

namespace stratareeb {
namespace {

using nlohmann::json;

//! A square of 100 with 2 of sand everywhere and 3 of clay, which a hole in the middle lacks.
class BuiltModel : public ::testing::Test {
 protected:
    BuiltModel() {
        folder_.file("holes.csv",
                     "hole,x,y,ground,Sand,Clay\n"
                     "A,0,0,10,2,3\nB,100,0,10,2,3\nC,100,100,10,2,3\nD,0,100,10,2,3\nE,50,50,10,2,0\n");
        const auto result = run("build holes.csv -o model --quiet --refine 0");
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
    ProgramResult run(const std::string& arguments) const { return run_program(folder_, arguments); }
    double model_volume(std::size_t layer) const {
        const json model = json::parse(content_of(folder_ / "model/model.json"));
        return model["units"][layer]["volume"];
    }
    TemporaryFolder folder_;
};

using CellsCommand = BuiltModel;

TEST_F(CellsCommand, writes_what_others_read) {
    for (const std::string options :
         {"", " --tetrahedra", " --sublayers 2", " --tetrahedra --max-thickness 1"}) {
        const auto result = run("cells model -o cells.vtu -o cells.msh --json --overwrite" + options);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const json report = json::parse(result.out);
        EXPECT_LT(report["volume_error"].get<double>(), 1e-12);
        const auto vtu = testing::read_vtu(content_of(folder_ / "cells.vtu"));
        const auto msh = testing::read_msh(content_of(folder_ / "cells.msh"));
        ASSERT_EQ(vtu.cells.size(), report["cells"]);
        ASSERT_EQ(msh.cells.size(), report["cells"]);
        EXPECT_EQ(vtu.points, msh.points);
        EXPECT_EQ(msh.faces.size(), report["outer_faces"]);
        EXPECT_EQ(msh.groups, (std::vector<std::string>{"2 3 \"ground\"", "2 4 \"base\"", "2 5 \"sides\"",
                                                        "3 1 \"Sand\"", "3 2 \"Clay\""}));
        std::map<int, double> volume;
        for (std::size_t i = 0; i < msh.cells.size(); ++i) {
            const double v = testing::volume(msh, msh.cells[i].nodes);
            EXPECT_GT(v, 0);
            volume[msh.cells[i].layer] += v;
            EXPECT_NEAR(vtu.data.at("volume")[i], v, 1e-9);
            EXPECT_EQ(vtu.data.at("MaterialIDs")[i] + 1, vtu.cells[i].layer);
            // VTK's prism starts with the upper triangle.
            auto nodes = vtu.cells[i].nodes;
            if (nodes.size() == 6) std::rotate(nodes.begin(), nodes.begin() + 3, nodes.end());
            EXPECT_EQ(nodes, msh.cells[i].nodes);
            EXPECT_EQ(vtu.cells[i].layer, msh.cells[i].layer);
            EXPECT_EQ(vtu.cells[i].type, nodes.size() == 4 ? 10 : nodes.size() == 5 ? 14 : 13);
        }
        EXPECT_NEAR(volume[1], model_volume(0), 1e-9 * 5e4);
        EXPECT_NEAR(volume[2], model_volume(1), 1e-9 * 5e4);
        double ground = 0;
        for (const auto& face : msh.faces)
            if (face.layer == 3) {
                const auto &a = msh.points[face.nodes[0]], &b = msh.points[face.nodes[1]],
                           &c = msh.points[face.nodes[2]];
                ground += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
            }
        EXPECT_NEAR(ground, 1e4, 1e-6);
    }
}

TEST_F(CellsCommand, says_what_is_wrong) {
    EXPECT_EQ(run("cells model").exit_code, 2);
    EXPECT_EQ(run("cells model -o cells.vtk").exit_code, 2);
    EXPECT_EQ(run("cells model -o cells.vtu --sublayers 0").exit_code, 2);
    EXPECT_EQ(run("cells nothing -o cells.vtu").exit_code, 1);
    EXPECT_EQ(run("cells model -o nowhere/cells.vtu").exit_code, 1);
    EXPECT_EQ(run("cells model -o cells.vtu").exit_code, 0);
    const auto again = run("cells model -o cells.vtu");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
    const auto thin = run("cells model -o thin.vtu --min-thickness 1");
    EXPECT_EQ(thin.exit_code, 0) << thin.err;
    EXPECT_NE(thin.out.find("in the model"), std::string::npos);
}

}  // namespace
}  // namespace stratareeb
