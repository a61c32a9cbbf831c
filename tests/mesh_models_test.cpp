// SPDX-License-Identifier: GPL-3.0-or-later
// Public meshes with known topology: the report, against numbers that two other programs agreed on.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/read_mesh.h"
#include "mesh/analysis.h"

namespace stratareeb {
namespace {

const std::filesystem::path kModels = STRATAREEB_SOURCE_DIR "/../shared/data/models";

struct Row {
    std::string file;
    std::size_t vertices = 0, triangles = 0, components = 0, loops = 0;
    long long euler = 0;
    std::string genus;
};

// The table of the README: | mesh | vertices | triangles | components | Euler | boundary loops | genus | …
std::vector<Row> table() {
    std::vector<Row> rows;
    std::ifstream readme(kModels / "README.md");
    for (std::string line; std::getline(readme, line);) {
        if (line.find(".ply |") == std::string::npos) continue;
        std::replace(line.begin(), line.end(), '|', ' ');
        Row row;
        std::istringstream(line) >> row.file >> row.vertices >> row.triangles >> row.components >>
            row.euler >> row.loops >> row.genus;
        rows.push_back(row);
    }
    return rows;
}

TEST(MeshModels, have_the_counts_that_are_known_of_them) {
    if (!std::filesystem::exists(kModels)) GTEST_SKIP() << "the shared models are not here";
    const auto rows = table();
    EXPECT_GE(rows.size(), 27u);
    for (const auto& row : rows) {
        SCOPED_TRACE(row.file);
        const auto r = analyze(read_mesh(kModels / row.file));
        EXPECT_EQ(r.vertices, row.vertices);
        EXPECT_EQ(r.triangles, row.triangles);
        EXPECT_EQ(r.components, row.components);
        EXPECT_EQ(r.euler, row.euler);
        EXPECT_EQ(r.boundary_loops, row.loops);
        EXPECT_TRUE(r.manifold);
        EXPECT_EQ(r.closed, row.loops == 0);
        EXPECT_EQ(r.degenerate_triangles, 0u);
        const bool one_sided = row.file == "mobius.ply";
        EXPECT_EQ(r.orientable, !one_sided);
        EXPECT_EQ(r.oriented, !one_sided);
        if (one_sided)
            EXPECT_FALSE(r.genus.has_value());
        else
            EXPECT_EQ(r.genus, std::stoul(row.genus));
        EXPECT_EQ(r.watertight, r.problems.empty());
    }
}

}  // namespace
}  // namespace stratareeb
