// SPDX-License-Identifier: GPL-3.0-or-later
// What the users' own programs, FreeCAD and MeshLab, say about a file.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace stratareeb::test {

namespace fs = std::filesystem;

inline std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline std::string quoted(const fs::path& path) {
    std::string result = "'";
    for (const char c : path.string()) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

inline bool has_program(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

struct Outcome {
    int exit_code = -1;
    std::string output;  // stdout and stderr
};

inline Outcome run(const std::string& command, const fs::path& log) {
    const int status = std::system((command + " >" + quoted(log) + " 2>&1").c_str());
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1, .output = text_of(log)};
}

//! A folder that lives as long as the object.
class TemporaryFolder {
 public:
    explicit TemporaryFolder(const std::string& name)
        : path_(fs::temp_directory_path() / (name + "_" + std::to_string(::getpid()))) {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

//! A part of a STEP file as FreeCAD shows it; lengths in millimetres.
struct FreeCadSolid {
    std::string label, shape_type;
    bool valid = false, closed = false;
    double volume_mm3 = 0;
    std::size_t solids = 0, faces = 0;
};

constexpr const char* kFreeCadScript = R"(
import json, FreeCAD, Import
# Without these two, FreeCAD 0.20 crashes on any file of several parts when it runs without windows.
Import.insert(PATH, FreeCAD.newDocument("model").Name, merge=False, useLinkGroup=True)
for part in FreeCAD.ActiveDocument.Objects:
    if part.TypeId == "Part::Feature":
        shape = part.Shape
        print("\nPART " + json.dumps({"label": part.Label, "type": shape.ShapeType, "valid": shape.isValid(),
              "closed": shape.isClosed(), "volume": shape.Volume, "solids": len(shape.Solids), "faces": len(shape.Faces)}))
)";

inline std::vector<FreeCadSolid> open_in_freecad(const fs::path& step, const fs::path& folder) {
    const auto script = folder / "open.py";
    std::string text = kFreeCadScript;
    text.replace(text.find("PATH"), 4, nlohmann::json(fs::absolute(step).string()).dump());
    std::ofstream(script) << text;
    const auto outcome =
        run("FREECAD_USER_HOME=" + quoted(folder) + " freecadcmd " + quoted(script), folder / "freecad.log");
    std::vector<FreeCadSolid> solids;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("PART ")) continue;
        const auto part = nlohmann::json::parse(line.substr(5));
        solids.push_back({part["label"], part["type"], part["valid"], part["closed"], part["volume"],
                          part["solids"], part["faces"]});
    }
    EXPECT_FALSE(solids.empty()) << outcome.output;
    return solids;
}

//! What MeshLab measures; it keeps coordinates in float.
struct MeshLabReport {
    bool two_manifold = false;
    std::optional<int> holes, components, genus;
    std::optional<double> volume;
    std::string output;
};

inline MeshLabReport open_in_meshlab(const fs::path& mesh, const fs::path& folder) {
    const auto filter = folder / "measure.mlx";
    std::ofstream(filter) << "<!DOCTYPE FilterScript>\n<FilterScript>\n"
                             " <filter name=\"Compute Topological Measures\"/>\n"
                             " <filter name=\"Compute Geometric Measures\"/>\n</FilterScript>\n";
    MeshLabReport report;
    report.output =
        run("xvfb-run -a meshlabserver -i " + quoted(mesh) + " -s " + quoted(filter), folder / "meshlab.log")
            .output;
    const auto number_in = [&](const char* pattern) -> std::optional<double> {
        std::smatch found;
        if (!std::regex_search(report.output, found, std::regex(pattern))) return {};
        return std::stod(found[1]);
    };
    report.two_manifold = report.output.find("Mesh is two-manifold") != std::string::npos;
    report.holes = number_in("Mesh has (\\d+) holes");
    report.components = number_in("composed by (\\d+) connected");
    report.genus = number_in("Genus is (\\d+)");
    report.volume = number_in("Mesh Volume\\s+is (-?[0-9.]+)");
    return report;
}

}  // namespace stratareeb::test
