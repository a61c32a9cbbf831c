// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/mesh_report.h"
#include "io/read_mesh.h"

namespace stratareeb {
namespace {

struct CheckOptions {
    std::vector<std::string> meshes;
    bool json = false;
};

class Check {
 public:
    explicit Check(const CheckOptions& options) : options_(options) {}

    //! True if every part of every file is watertight.
    bool run() {
        for (const auto& file : options_.meshes) check_file(file);
        if (options_.json) print(json_text(results_));
        return all_watertight_;
    }

 private:
    void check_file(const std::string& file) {
        try {
            const auto parts = read_mesh_parts(file);
            if (parts.empty()) report(file, {}, 1);
            for (const auto& part : parts) report(file, part, parts.size());
        } catch (const std::exception& error) {
            all_watertight_ = false;
            results_.push_back({{"file", file}, {"error", error.what()}, {"watertight", false}});
            std::fprintf(stderr, "stratareeb: %s\n", error.what());
        }
    }

    void report(const std::string& file, const PartData& part, std::size_t parts) {
        const auto result = analyze(part.soup);
        all_watertight_ = all_watertight_ && result.watertight;
        if (!options_.json) return print(report_text(part_label(file, part.name, parts), result));
        auto json = report_json(result);
        json["file"] = file;
        if (parts > 1) json["part"] = part.name;
        results_.push_back(std::move(json));
    }

    static void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

    const CheckOptions& options_;
    bool all_watertight_ = true;
    nlohmann::json results_ = nlohmann::json::array();
};

}  // namespace

void add_check_command(CLI::App& program) {
    const auto options = std::make_shared<CheckOptions>();
    auto* const command =
        program.add_subcommand("check", "Report the health of meshes; fails unless all are watertight");
    command->add_option("MESH", options->meshes, "Mesh files: .ply .obj .stl .off .glb .3mf")->required();
    command->add_flag("--json", options->json, "Print one JSON list instead of text");
    command->callback([options] {
        if (!Check(*options).run()) throw CommandFailed();
    });
}

}  // namespace stratareeb
