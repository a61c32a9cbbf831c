// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command.h"
#include "apps/enhanced_reeb.h"
#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/layered_reeb.h"
#include "apps/progress.h"
#include "apps/reeb_report.h"
#include "boreholes/errors.h"
#include "io/drawing_page.h"
#include "io/mesh_format.h"
#include "io/write_arc_colors.h"
#include "io/write_graph.h"
#include "io/write_graph_drawing.h"
#include "io/write_graph_json.h"
#include "io/write_graph_lines.h"

namespace stratareeb {
namespace {

//! Whatever would stop the writing is asked before the work.
void check_outputs(const ReebArguments& arguments) {
    for (const std::string& file : {arguments.output, arguments.colored, arguments.loops})
        if (!file.empty()) keep_existing(file, arguments.overwrite);
    const std::string& output = arguments.output;
    if (!output.empty() && !is_graph_file(output) && !is_graph_lines_file(output) && !is_drawing_file(output))
        throw IoError(output +
                      ": graphs are written as .json, .dot, .graphml, .ply, .obj, .svg, .pdf or .png");
    if (!arguments.colored.empty() && mesh_format(arguments.colored) != MeshFormat::Ply)
        throw IoError(arguments.colored + ": a mesh coloured by arc is written as .ply");
    if (!arguments.loops.empty()) mesh_format(arguments.loops);
}

//! The field in words, for the axis of a drawing.
std::string label_of(const std::string& field) {
    if (field.starts_with("file:")) return std::filesystem::path(field.substr(5)).stem().string();
    if (field.starts_with("property:")) return field.substr(9);
    const std::string quantity = field.starts_with("distance:") ? "distance from (" + field.substr(9) + ")"
                                 : field.find(',') == std::string::npos ? field
                                                                        : "height along (" + field + ")";
    return quantity + ", in units of the mesh";
}

class Reeb {
 public:
    explicit Reeb(const ReebArguments& arguments) : arguments_(arguments) {}

    void run() {
        check_outputs(arguments_);
        progress_.step("reading", 0);
        input_ = read_input_mesh(arguments_.meshes.front(), arguments_.repair);
        progress_.step("field", 0.3);
        field_ = field_of(input_, arguments_.field);
        progress_.step("graph", 0.4);
        asked_ = asked_graph(input_.mesh, field_,
                             {.simplify = arguments_.simplify, .plateaus = arguments_.plateaus});
        if (arguments_.pairs) pairs_ = persistence_pairs(graph());
        progress_.step("writing", 0.6);
        write_files();
        progress_.step("report", 0.9);
        progress_.clear();
        arguments_.json ? print_json() : print_text();
    }

 private:
    const ReebGraph& graph() const { return asked_.graph(); }

    void write_files() const {
        const std::filesystem::path output = arguments_.output;
        const bool is_json = output.extension() == ".json";
        GraphDetails details{.pairs = pairs_, .loops = {}};
        if (is_json || !arguments_.loops.empty()) details.loops = loop_handles(input_.mesh, graph());
        if (is_graph_file(output))
            write_graph(output, graph(), input_.mesh, details);
        else if (!output.empty())
            write_picture_of_graph(output);
        if (!arguments_.colored.empty()) write_arc_colors(arguments_.colored, input_.mesh, graph());
        if (!arguments_.loops.empty()) write_loop_handles(arguments_.loops, input_.mesh, *details.loops);
    }

    void write_picture_of_graph(const std::filesystem::path& output) const {
        const ArcIndex index(input_.mesh, field_, asked_.fine);
        const ArcMembers members = arc_members(asked_.fine, graph());
        if (is_graph_lines_file(output)) {
            write_graph_lines(output, graph(), input_.mesh,
                              coarse_arc_curves(input_.mesh, asked_.fine, index, graph(), members));
            return;
        }
        const std::string title =
            fmt::format("{}: Reeb graph of {}, {}, {}",
                        std::filesystem::path(arguments_.meshes.front()).filename().string(),
                        counted(graph().nodes.size(), "node"), counted(graph().arcs.size(), "arc"),
                        counted(graph().loops(), "loop"));
        write_graph_drawing(output, {input_.mesh, field_, asked_.fine, index, graph(), members},
                            {.title = title,
                             .value_label = label_of(arguments_.field),
                             .direction = field_direction(arguments_.field)});
    }

    void print_json() const {
        auto json = reeb_json(input_.mesh, field_, asked_);
        if (pairs_) {
            json["pairs"] = nlohmann::ordered_json::array();
            for (const PersistencePair& pair : *pairs_)
                json["pairs"].push_back({{"kind", kind_name(pair.kind)},
                                         {"lower", pair.lower},
                                         {"upper", pair.upper},
                                         {"persistence", pair.persistence}});
        }
        fmt::print("{}\n", json.dump(2));
    }

    void print_text() const {
        fmt::print("{}", reeb_text(input_.mesh, field_, asked_));
        if (pairs_) print_pairs();
    }

    void print_pairs() const {
        const auto value = [&](std::uint32_t node) { return graph().nodes[node].value; };
        for (const PersistencePair& pair : *pairs_)
            fmt::print("{:<9}  nodes {:>6} {:>6}  from {:.7g} to {:.7g}, persistence {:.7g}\n",
                       kind_name(pair.kind), pair.lower, pair.upper, value(pair.lower), value(pair.upper),
                       pair.persistence);
    }

    const ReebArguments& arguments_;
    Progress progress_{"reeb"};
    InputMesh input_;
    ScalarField field_;
    AskedGraph asked_;
    std::optional<std::vector<PersistencePair>> pairs_;
};

std::string complaint_of_share(const std::string& text) {
    double share = -1;
    if (CLI::detail::lexical_cast(text, share) && share >= 0 && share < 1) return {};
    return text + " is no share of the field's range (expected at least 0, below 1)";
}

void refuse(const CLI::App& command, std::initializer_list<const char*> options, const std::string& why) {
    for (const char* option : options)
        if (command.count(option) > 0) throw CLI::ValidationError(option, why);
}

void run(const CLI::App& command, const ReebArguments& arguments) {
    if (!arguments.enhanced) refuse(command, {"--levels", "--tolerance"}, "goes with --enhanced");
    if (arguments.meshes.size() > 1) {
        refuse(command, {"--enhanced", "--colored", "--loops", "--pairs"},
               "takes one mesh; several are joined in a layered graph");
        return run_layered_reeb(arguments);
    }
    if (!arguments.enhanced) return Reeb(arguments).run();
    refuse(command, {"--plateaus", "--simplify", "--colored", "--loops", "--pairs"},
           "does not go with --enhanced");
    if (!field_direction(arguments.field))
        throw CLI::ValidationError("--field", "--enhanced takes x, y, z or a direction dx,dy,dz");
    run_enhanced_reeb(arguments);
}

void add_enhanced_options(CLI::App& command, ReebArguments& arguments) {
    command.add_flag("--enhanced", arguments.enhanced,
                     "The graph with nodes in space, contours and edges through their centres, as .json, for "
                     "reconstruct; of a closed mesh, over a direction");
    command
        .add_option("--levels", arguments.levels,
                    "--enhanced: levels of the contours, evenly between lowest and highest")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command
        .add_option(
            "--tolerance", arguments.tolerance,
            "--enhanced: further contours until those between are as near as that, in units of the mesh")
        ->check(CLI::PositiveNumber);
}

}  // namespace

void add_reeb_command(CLI::App& program) {
    auto arguments = std::make_shared<ReebArguments>();
    CLI::App* command =
        program.add_subcommand("reeb", "Reeb graph of a mesh, or of several: the layers of a stack");
    command
        ->add_option(
            "MESH", arguments->meshes,
            "Mesh file, an oriented 2-manifold with or without boundary; several make a layered graph")
        ->required();
    command->add_option(
        "-o,--output", arguments->output,
        "File for the graph: .json, .dot, .graphml; lines in space .ply, .obj; drawing beside "
        "the levels .svg, .pdf, .png; of several meshes .json, .dot, .obj");
    command->add_option("--colored", arguments->colored, "PLY file for the mesh with each arc in a colour");
    command->add_option("--loops", arguments->loops, "Mesh file for the triangles of each loop's handle");
    add_field_option(*command, arguments->field);
    add_enhanced_options(*command, *arguments);
    command->add_flag("--plateaus", arguments->plateaus,
                      "Each plateau as one node; else ties are broken by vertex index");
    command
        ->add_option("--simplify", arguments->simplify,
                     "Leave out what is less persistent than this share of the field's range, 0 to 1; with "
                     "--plateaus")
        ->check(complaint_of_share);
    command->add_flag("--pairs", arguments->pairs, "Report persistence pairs too");
    add_repair_option(*command, arguments->repair);
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments, command] { run(*command, *arguments); });
}

}  // namespace stratareeb
