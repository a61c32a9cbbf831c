// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/progress.h"
#include "boreholes/errors.h"
#include "io/read_model.h"
#include "io/staged_folder.h"
#include "io/write_aside.h"
#include "io/write_mesh.h"
#include "io/write_model.h"
#include "io/write_picture.h"
#include "mesh/analysis.h"
#include "mesh/slabs.h"
#include "reeb/collapse_plateaus.h"

namespace stratareeb {
namespace {

using nlohmann::ordered_json;

struct SplitArguments {
    std::string folder, output, format = "ply";
    std::size_t count = 20;
    std::vector<double> at;
    bool pictures = false, json = false, quiet = false, overwrite = false;
};

constexpr const char* kRecord = "split.json";

//! A layer's part of a slab.
struct Piece {
    std::size_t layer = 0;
    std::string file;
    MeshReport report;
    std::size_t nodes = 0, arcs = 0, loops = 0;  // of the Reeb graph of its height
};

class Split {
 public:
    explicit Split(const SplitArguments& arguments)
        : arguments_(arguments), progress_("split", arguments.quiet ? std::optional(false) : std::nullopt) {}

    void run() {
        StagedFolder folder(arguments_.output, arguments_.overwrite);
        progress_.step("reading the model", 0);
        const SavedModel saved = read_model(arguments_.folder);
        model_ = &saved.model;
        progress_.step("cutting", 0.05);
        const SlabCutter cutter(
            saved.model, arguments_.at.empty() ? even_levels(saved.model, arguments_.count) : arguments_.at);
        record_ = {{"length_unit", saved.model.length_unit},
                   {"origin", {saved.model.origin.x, saved.model.origin.y, saved.model.origin.z}},
                   {"levels", cutter.levels()},
                   {"slabs", ordered_json::array()}};
        volumes_.assign(saved.model.units.size(), 0);
        for (std::size_t i = 0; i < cutter.size(); ++i) {
            progress_.step("slabs", 0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(cutter.size()));
            write_slab(folder, cutter.slab(i), i + 1);
        }
        check_volumes();
        const std::filesystem::path file = folder.add(kRecord);
        record_["files"] = folder.files();
        const std::string text = record_.dump(2) + "\n";
        write_aside(file, [&](std::ostream& stream) { stream << text; });
        folder.commit(listed_files(std::filesystem::path(arguments_.output) / kRecord));
        progress_.clear();
        if (arguments_.json)
            std::fputs(text.c_str(), stdout);
        else
            print(folder.files().size());
    }

 private:
    void write_slab(StagedFolder& folder, const Slab& slab, std::size_t number) {
        std::vector<LayerSolid> solids;
        ordered_json pieces = ordered_json::array();
        for (std::size_t i = 0; i < slab.model.units.size(); ++i) {
            for (LayerSolid& solid : build_block_solids(slab.model, i)) {
                if (solid.surface.n_faces() == 0) continue;
                const Piece piece = write_piece(folder, solid, i, number);
                volumes_[i] += piece.report.volume;
                pieces.push_back(piece_json(piece));
                solids.push_back(std::move(solid));
            }
        }
        ordered_json entry{{"low", slab.low}, {"high", slab.high}, {"layers", std::move(pieces)}};
        if (arguments_.pictures && !solids.empty()) {
            const std::string name = fmt::format("slab_{:02}.png", number);
            PictureOptions options;
            options.explode = 0;
            options.length_unit = slab.model.length_unit;
            options.title = fmt::format("{:.6g} to {:.6g} {}", slab.low, slab.high, slab.model.length_unit);
            write_picture(folder.add(name), solids, options);
            entry["picture"] = name;
        }
        record_["slabs"].push_back(std::move(entry));
    }

    Piece write_piece(StagedFolder& folder, const LayerSolid& solid, std::size_t layer, std::size_t number) {
        Piece piece{.layer = layer, .file = {}, .report = analyze(solid.surface)};
        if (!piece.report.watertight)
            throw GeometryError(fmt::format(
                "slab {}, layer '{}': {}; choose other levels with --at", number, solid.unit.name,
                piece.report.problems.empty() ? "not watertight" : piece.report.problems.front()));
        const ReebGraph graph = collapse_plateaus(reeb_graph(solid.surface, height_field(solid.surface)));
        piece.nodes = graph.nodes.size();
        piece.arcs = graph.arcs.size();
        piece.loops = graph.loops();
        piece.file =
            fmt::format("slab_{:02}/{}{}.{}", number, numbered_name(layer + 1, solid.unit.name),
                        solid.block > 0 ? fmt::format("_block_{}", solid.block) : "", arguments_.format);
        write_mesh(folder.add(piece.file), {solid.unit.name, solid.unit.color, &solid.surface});
        return piece;
    }

    ordered_json piece_json(const Piece& piece) const {
        return {{"order", piece.layer + 1},
                {"code", model_->units[piece.layer].code},
                {"solid", piece.file},
                {"volume", piece.report.volume},
                {"components", piece.report.components},
                {"genus", piece.report.genus.value_or(0)},
                {"reeb", {{"nodes", piece.nodes}, {"arcs", piece.arcs}, {"loops", piece.loops}}}};
    }

    //! What was parted must be whole again.
    void check_volumes() {
        double sum = 0;
        for (const double volume : volumes_) sum += volume;
        const double whole = envelope_volume(*model_);
        constexpr double kTolerance = 1e-9;
        if (std::abs(sum - whole) > kTolerance * whole)
            throw GeometryError(fmt::format("the slabs' volumes add up to {:.12g} of {:.12g}", sum, whole));
    }

    void print(std::size_t files) const {
        const std::string& u = model_->length_unit;
        fmt::print("{:>4} {:>12} {:>12} {:>7} {:>14}  Reeb graphs\n", "slab", fmt::format("from [{}]", u),
                   fmt::format("to [{}]", u), "layers", fmt::format("volume [{}³]", u));
        std::size_t number = 0;
        for (const auto& slab : record_["slabs"]) {
            double volume = 0;
            std::size_t nodes = 0, loops = 0;
            for (const auto& piece : slab["layers"]) {
                volume += piece["volume"].get<double>();
                nodes += piece["reeb"]["nodes"].get<std::size_t>();
                loops += piece["reeb"]["loops"].get<std::size_t>();
            }
            fmt::print("{:>4} {:>12.6g} {:>12.6g} {:>7} {:>14.7g}  {} nodes, {} loops\n", ++number,
                       slab["low"].get<double>(), slab["high"].get<double>(), slab["layers"].size(), volume,
                       nodes, loops);
        }
        fmt::print("every solid watertight, volumes add up to the model's\n{} files in {}\n", files,
                   arguments_.output);
    }

    const SplitArguments& arguments_;
    Progress progress_;
    const LayerModel* model_ = nullptr;
    std::vector<double> volumes_;  // of each layer, so far
    ordered_json record_;
};

}  // namespace

void add_split_command(CLI::App& program) {
    const auto arguments = std::make_shared<SplitArguments>();
    CLI::App* command = program.add_subcommand("split", "Part a built model into slabs by elevation");
    command->add_option("DIR", arguments->folder, "Folder that build wrote")->required();
    command->add_option("-o,--output", arguments->output, "Folder for the slabs")->required();
    auto* count = command->add_option("--count", arguments->count, "So many slabs of equal height")
                      ->check(CLI::Range(1, 1000))
                      ->capture_default_str();
    command->add_option("--at", arguments->at, "Elevations to cut at instead, ascending: z,z,…")
        ->delimiter(',')
        ->excludes(count);
    command->add_option("--format", arguments->format, "Of the solids")
        ->check(CLI::IsMember({"ply", "obj", "stl", "off", "glb", "3mf"}))
        ->capture_default_str();
    command->add_flag("--pictures", arguments->pictures, "A picture of each slab too");
    command->add_flag("--json", arguments->json, "Print split.json");
    command->add_flag("--quiet", arguments->quiet, "No progress on standard error");
    command->add_flag("--overwrite", arguments->overwrite,
                      "Write into a folder that holds something already");
    command->callback([arguments] { Split(*arguments).run(); });
}

}  // namespace stratareeb
