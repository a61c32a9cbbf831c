// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/choice.h"
#include "apps/command.h"
#include "apps/keep_existing.h"
#include "apps/progress.h"
#include "apps/reconstruct_input.h"
#include "apps/reeb_report.h"
#include "apps/turned_frame.h"
#include "boreholes/errors.h"
#include "io/write_enhanced_graph.h"
#include "io/write_mesh.h"
#include "io/write_picture.h"
#include "mesh/analysis.h"
#include "mesh/normals.h"
#include "reeb/surface_of_graph.h"
#include "reeb/terrain_stack.h"

namespace stratareeb {
namespace {

struct ReconstructArguments {
    std::string input, output, graph, picture;
    StackOptions stack;
    std::optional<HomotopyKind> homotopy;
    std::optional<bool> terrain;
    SurfaceOptions surface;
    bool turned = false, allow_crossings = false, overwrite = false, json = false;
};

//! Whatever would stop the writing is asked before the work.
void check_outputs(const ReconstructArguments& arguments) {
    const MeshFormat format = mesh_format(arguments.output);
    keep_existing(arguments.output, arguments.overwrite);
    if (format == MeshFormat::Obj)
        keep_existing(std::filesystem::path(arguments.output).replace_extension(".mtl"), arguments.overwrite);
    if (!arguments.picture.empty()) {
        if (std::filesystem::path(arguments.picture).extension() != ".png")
            throw IoError(arguments.picture + ": pictures are written as .png");
        keep_existing(arguments.picture, arguments.overwrite);
    }
    if (arguments.graph.empty()) return;
    if (std::filesystem::path(arguments.graph).extension() != ".json")
        throw IoError(arguments.graph + ": enhanced Reeb graphs are written as .json");
    keep_existing(arguments.graph, arguments.overwrite);
}

class Reconstruct {
 public:
    Reconstruct(const CLI::App& command, const ReconstructArguments& arguments)
        : command_(command), arguments_(arguments) {}

    void run() {
        check_outputs(arguments_);
        read();
        build();
        progress_.step("checking", 0.6);
        report_ = analyze(surface_.soup);
        check_surface();
        if (input_.axes && !arguments_.turned) turn_back(surface_.soup, *input_.axes);
        progress_.step("writing", 0.9);
        write();
        progress_.clear();
        arguments_.json ? print_json() : print_text();
    }

 private:
    void read() {
        progress_.step("reading", 0);
        input_ = read_reconstruct_input(arguments_.input, arguments_.stack);
        if (!input_.stack) {
            refuse_stack_options(command_);
            if (!arguments_.graph.empty())
                throw CLI::ValidationError("--graph", "is for contours, and the file is a graph");
        }
        if (!arguments_.homotopy) return;
        for (EnhancedEdge& edge : input_.graph.edges) edge.homotopy = {.kind = *arguments_.homotopy};
    }

    void build() {
        progress_.step("surface", 0.2);
        const auto start = std::chrono::steady_clock::now();
        SurfaceOptions options = arguments_.surface;
        options.terrain = arguments_.terrain
                              ? *arguments_.terrain
                              : input_.stack && !arguments_.homotopy && is_terrain(input_.graph);
        try {
            surface_ = surface_of_graph(input_.graph, options);
        } catch (const InvalidInput& error) {
            throw InvalidInput(fmt::format("{}: {}", arguments_.input, error.what()));
        }
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void check_surface() const {
        if (report_.boundary_loops != open_ends() || !report_.manifold || !report_.oriented)
            throw GeometryError(fmt::format("{}: the surface is no {}, oriented 2-manifold: {}",
                                            arguments_.input, open_ends() == 0 ? "closed" : "bounded",
                                            report_.problems.empty() ? "" : report_.problems.front()));
        if (report_.self_intersections == 0 || arguments_.allow_crossings) return;
        throw GeometryError(fmt::format(
            "{}: the surface crosses itself at {}:\n{}give contours between those, move them apart or try "
            "another --homotopy; --allow-crossings writes it as it is",
            arguments_.input, counted(report_.self_intersections, "pair") + " of triangles", crossings()));
    }

    //! Of the graph; the surface has a boundary loop at each.
    std::size_t open_ends() const {
        return static_cast<std::size_t>(
            std::ranges::count(input_.graph.nodes, NodeForm::Open, &EnhancedNode::form));
    }

    //! A line each, the first few.
    std::string crossings() const {
        constexpr std::size_t kTold = 10;
        const auto& places = surface_.crossings;
        std::string text;
        for (std::size_t i = 0; i < places.size() && i < kTold; ++i) text += fmt::format("  {}\n", places[i]);
        if (places.size() > kTold) text += fmt::format("  and {} more\n", places.size() - kTold);
        if (report_.problems.size() == 1) text += fmt::format("  {}\n", report_.problems.front());
        return text + (input_.stack ? contours_named_in(text, input_) : "");
    }

    void write() const {
        const std::filesystem::path output = arguments_.output;
        if (!arguments_.graph.empty()) write_enhanced_graph(arguments_.graph, input_.graph);
        write_mesh_parts(output, {{.name = output.stem().string(),
                                   .soup = surface_.soup,
                                   .normals = vertex_normals(surface_.soup)}});
        if (!arguments_.picture.empty()) draw();
    }

    void draw() const {
        constexpr const char* kClay = "#c8a26a";
        LayerSolid solid{.order = 1,
                         .unit = {.code = "1",
                                  .name = std::filesystem::path(arguments_.input).stem().string(),
                                  .color = kClay},
                         .surface = half_edge_mesh(surface_.soup)};
        update_vertex_normals(solid.surface);
        write_picture(arguments_.picture, {&solid, 1},
                      {.width = 800, .height = 560, .vertical_exaggeration = 1, .length_unit = "units"});
    }

    void print_json() const {
        nlohmann::ordered_json json{{"vertices", report_.vertices},
                                    {"triangles", report_.triangles},
                                    {"components", report_.components},
                                    {"genus", report_.genus.value_or(0)},
                                    {"boundary_loops", report_.boundary_loops},
                                    {"closed", report_.closed},
                                    {"manifold", report_.manifold},
                                    {"oriented", report_.oriented},
                                    {"volume", report_.volume},
                                    {"area", report_.area},
                                    {"self_intersections", report_.self_intersections},
                                    {"nodes", input_.graph.nodes.size()},
                                    {"edges", input_.graph.edges.size()},
                                    {"contours", input_.graph.contours.size()},
                                    {"loops", loops_of(input_.graph)},
                                    {"straightened", surface_.straightened},
                                    {"seconds", seconds_}};
        if (input_.stack)
            json["stack"] = {{"levels", input_.stack->levels}, {"not_joined", input_.stack->dropped.size()}};
        fmt::print("{}\n", json.dump(2));
    }

    void print_text() const {
        if (input_.stack) fmt::print("{}\n", counted(input_.stack->levels, "level"));
        fmt::print("enhanced Reeb graph: {}, {}, {}, {}\n", counted(input_.graph.nodes.size(), "node"),
                   counted(input_.graph.edges.size(), "edge"),
                   counted(input_.graph.contours.size(), "contour"), counted(loops_of(input_.graph), "loop"));
        fmt::print("{}: {} in {}, genus {}, {}, manifold, oriented, {}\n", arguments_.output,
                   counted(report_.triangles, "triangle"), counted(report_.components, "component"),
                   report_.genus.value_or(0),
                   open_ends() == 0 ? "closed" : "open at " + counted(open_ends(), "end"),
                   counted(report_.self_intersections, "self-intersection"));
        if (surface_.straightened > 0)
            fmt::print("{} where contours were joined straight so that nothing crosses\n",
                       counted(surface_.straightened, "place"));
        if (open_ends() == 0)
            fmt::print("volume {:.10g}, area {:.10g} (input units cubed, squared)\n", report_.volume,
                       report_.area);
        else
            fmt::print("area {:.10g} (input units squared)\n", report_.area);
    }

    const CLI::App& command_;
    const ReconstructArguments& arguments_;
    Progress progress_{"reconstruct"};
    ReconstructInput input_;
    ConstructedSurface surface_;
    MeshReport report_;
    double seconds_ = 0;
};

std::map<std::string, std::optional<HomotopyKind>> homotopies() {
    std::map<std::string, std::optional<HomotopyKind>> words;
    for (const HomotopyKind kind :
         {HomotopyKind::Linear, HomotopyKind::Parabola, HomotopyKind::Quadrant, HomotopyKind::Cardinal,
          HomotopyKind::CatmullRom, HomotopyKind::NaturalCubic})
        words.emplace(homotopy_name(kind), kind);
    return words;
}

void add_surface_options(CLI::App& command, ReconstructArguments& arguments) {
    add_choice(command, "--homotopy", arguments.homotopy, homotopies(),
               "How contours turn into one another, for all edges; else as the graph says");
    command
        .add_option("--steps", arguments.surface.steps,
                    "Bands of triangles between two given contours, or a contour and a critical point")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        .add_option("--samples", arguments.surface.samples,
                    "Points on a contour that is no polygon (polygons keep their corners)")
        ->check(CLI::Range(3, 1'000'000))
        ->capture_default_str();
    add_choice(
        command, "--triangulation", arguments.surface.triangulation,
        {{"auto", BandTriangulation::Automatic},
         {"exact", BandTriangulation::Exact},
         {"greedy", BandTriangulation::Greedy}},
        "Between contours: least area, the shortest next edge, or least area where that is quick (auto)");
    add_choice(
        command, "--terrain", arguments.terrain,
        {{"auto", std::nullopt}, {"on", std::optional(true)}, {"off", std::optional(false)}},
        "Where contours are no steeper than 63 degrees, a thin plate over the plan instead of the homotopy; "
        "auto: for contours of ground without overhangs, unless --homotopy is given");
    add_choice(command, "--fairing", arguments.surface.fairing, {{"on", true}, {"off", false}},
               "Beside saddles: bent as little as given contours allow, or as made from them");
}

}  // namespace

void add_reconstruct_command(CLI::App& program) {
    auto arguments = std::make_shared<ReconstructArguments>();
    CLI::App* command =
        program.add_subcommand("reconstruct", "Closed surface from an enhanced Reeb graph or from contours");
    command
        ->add_option(
            "GRAPH-or-CONTOURS", arguments->input,
            "Enhanced Reeb graph (.json), or contours with heights: .json, tables of points, GeoJSON, "
            "GeoPackage, shapefile, DXF")
        ->required();
    command->add_option("-o,--output", arguments->output, "File for the mesh: .ply .obj .stl .off .glb .3mf")
        ->required();
    add_surface_options(*command, *arguments);
    add_stack_options(*command, arguments->stack);
    command->add_option("--picture", arguments->picture, "File for a picture of the surface, .png");
    command->add_option("--graph", arguments->graph, "Contours: file for the graph found in them, .json");
    command->add_flag(
        "--turned", arguments->turned,
        "A graph that was turned: leave its surface so; else it is turned back to where the mesh was");
    command->add_flag("--allow-crossings", arguments->allow_crossings,
                      "Write a surface that crosses itself too");
    command->add_flag("--overwrite", arguments->overwrite, "Replace files that are there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments, command] { Reconstruct(*command, *arguments).run(); });
}

}  // namespace stratareeb
