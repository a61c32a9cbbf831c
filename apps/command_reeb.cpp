// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command.h"
#include "apps/field_option.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "boreholes/errors.h"
#include "io/drawing_page.h"
#include "io/mesh_format.h"
#include "io/write_arc_colors.h"
#include "io/write_graph.h"
#include "io/write_graph_drawing.h"
#include "io/write_graph_json.h"
#include "io/write_graph_lines.h"
#include "mesh/analysis.h"
#include "reeb/collapse_plateaus.h"
#include "reeb/simplify.h"

namespace stratareeb {
namespace {

struct ReebArguments {
    std::string mesh, output, colored, loops, field = "z";
    std::optional<double> simplify;
    bool plateaus = false, pairs = false, repair = false, overwrite = false, json = false;
};

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

std::string counted(std::size_t count, const char* thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

struct CriticalCounts {
    int minima = 0, saddles = 0, maxima = 0;  // saddles with their multiplicity
};

CriticalCounts critical_counts(const TriMesh& mesh, const ScalarField& field) {
    CriticalCounts counts;
    for (const CriticalPoint& point : critical_points(mesh, field)) {
        counts.minima += point.type == CriticalType::Minimum;
        counts.saddles += point.type == CriticalType::Saddle ? point.multiplicity : 0;
        counts.maxima += point.type == CriticalType::Maximum;
    }
    return counts;
}

class Reeb {
 public:
    explicit Reeb(const ReebArguments& arguments) : arguments_(arguments) {}

    void run() {
        check_outputs(arguments_);
        progress_.step("reading", 0);
        input_ = read_input_mesh(arguments_.mesh, arguments_.repair);
        progress_.step("field", 0.3);
        field_ = field_of(input_, arguments_.field);
        progress_.step("graph", 0.4);
        find_graph();
        progress_.step("writing", 0.6);
        write_files();
        progress_.step("report", 0.9);
        report();
    }

 private:
    void find_graph() {
        const auto start = std::chrono::steady_clock::now();
        fine_ = reeb_graph(input_.mesh, field_);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        collapsed_ = collapse_plateaus(fine_);
        if (arguments_.simplify)
            simplified_ = simplify(collapsed_, input_.mesh, field_, *arguments_.simplify);
        if (arguments_.pairs) pairs_ = persistence_pairs(graph());
    }

    //! The one that was asked for.
    const ReebGraph& graph() const {
        return simplified_ ? simplified_->graph : arguments_.plateaus ? collapsed_ : fine_;
    }

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
        const ArcIndex index(input_.mesh, field_, fine_);
        const ArcMembers members = arc_members(fine_, graph());
        if (is_graph_lines_file(output)) {
            write_graph_lines(output, graph(), input_.mesh,
                              coarse_arc_curves(input_.mesh, fine_, index, graph(), members));
            return;
        }
        const std::string title = fmt::format(
            "{}: Reeb graph of {}, {}, {}", std::filesystem::path(arguments_.mesh).filename().string(),
            counted(graph().nodes.size(), "node"), counted(graph().arcs.size(), "arc"),
            counted(graph().loops(), "loop"));
        write_graph_drawing(output, {input_.mesh, field_, fine_, index, graph(), members},
                            {.title = title,
                             .value_label = label_of(arguments_.field),
                             .direction = field_direction(arguments_.field)});
    }

    void report() {
        const MeshReport mesh = analyze(input_.mesh, {.self_intersections = false});
        const CriticalCounts critical = critical_counts(input_.mesh, field_);
        progress_.clear();
        arguments_.json ? print_json(mesh, critical) : print_text(mesh, critical);
    }

    void print_json(const MeshReport& mesh, const CriticalCounts& critical) const {
        nlohmann::ordered_json json{
            {"vertices", mesh.vertices},
            {"triangles", mesh.triangles},
            {"components", mesh.components},
            {"boundary_loops", mesh.boundary_loops},
            {"genus", mesh.genus.value_or(0)},
            {"nodes", graph().nodes.size()},
            {"arcs", graph().arcs.size()},
            {"loops", graph().loops()},
            {"collapsed", {{"nodes", collapsed_.nodes.size()}, {"arcs", collapsed_.arcs.size()}}},
            {"critical",
             {{"minimum", critical.minima}, {"saddle", critical.saddles}, {"maximum", critical.maxima}}},
            {"seconds", seconds_}};
        if (simplified_)
            json["simplified"] = {{"threshold", simplified_->threshold},
                                  {"pruned_branches", simplified_->pruned_branches},
                                  {"closed_loops", simplified_->closed_loops}};
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

    void print_text(const MeshReport& mesh, const CriticalCounts& critical) const {
        fmt::print("{} in {}, genus {}, {}\n", counted(mesh.triangles, "triangle"),
                   counted(mesh.components, "component"), mesh.genus.value_or(0),
                   counted(mesh.boundary_loops, "boundary loop"));
        fmt::print("Reeb graph: {}, {}, {}\n", counted(graph().nodes.size(), "node"),
                   counted(graph().arcs.size(), "arc"), counted(graph().loops(), "loop"));
        if (!arguments_.plateaus && !simplified_ && collapsed_.nodes.size() != fine_.nodes.size())
            fmt::print("with each plateau as one node: {} nodes, {} arcs\n", collapsed_.nodes.size(),
                       collapsed_.arcs.size());
        if (simplified_)
            fmt::print("simplified: {} branches and {} loops below {:.6g} left out\n",
                       simplified_->pruned_branches, simplified_->closed_loops, simplified_->threshold);
        fmt::print("critical points: {} minima, {} saddles, {} maxima\n", critical.minima, critical.saddles,
                   critical.maxima);
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
    ReebGraph fine_, collapsed_;
    std::optional<SimplifiedGraph> simplified_;
    std::optional<std::vector<PersistencePair>> pairs_;
    double seconds_ = 0;
};

std::string complaint_of_share(const std::string& text) {
    double share = -1;
    if (CLI::detail::lexical_cast(text, share) && share >= 0 && share < 1) return {};
    return text + " is no share of the field's range (expected at least 0, below 1)";
}

}  // namespace

void add_reeb_command(CLI::App& program) {
    auto arguments = std::make_shared<ReebArguments>();
    CLI::App* command = program.add_subcommand("reeb", "Reeb graph of a mesh");
    command->add_option("MESH", arguments->mesh, "Mesh file, an oriented 2-manifold with or without boundary")
        ->required();
    command->add_option(
        "-o,--output", arguments->output,
        "File for the graph: .json, .dot, .graphml; lines in space .ply, .obj; drawing beside "
        "the levels .svg, .pdf, .png");
    command->add_option("--colored", arguments->colored, "PLY file for the mesh with each arc in a colour");
    command->add_option("--loops", arguments->loops, "Mesh file for the triangles of each loop's handle");
    add_field_option(*command, arguments->field);
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
    command->callback([arguments] { Reeb(*arguments).run(); });
}

}  // namespace stratareeb
