// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "apps/choice.h"
#include "apps/command.h"
#include "apps/input_mesh.h"
#include "apps/keep_existing.h"
#include "apps/memory_guard.h"
#include "apps/mesh_report.h"
#include "apps/progress.h"
#include "boreholes/errors.h"
#include "io/mesh_format.h"
#include "io/read_creases.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "io/write_picture.h"
#include "mesh/analysis.h"
#include "mesh/measures.h"
#include "mesh/normals.h"
#include "subdivision/adaptive_refine.h"
#include "subdivision/feature_edges.h"

namespace stratareeb {
namespace {

struct RefineArguments {
    std::string mesh, output, crease_file, picture;
    std::vector<std::string> features;
    std::optional<SubdivisionScheme> scheme;
    RefineOptions options{.limit = false};
    std::optional<double> tolerance;
    bool triangles = false, repair = false, ignore_memory = false, overwrite = false, json = false;
};

struct Refined {
    RefinedMesh refined;
    int levels = 0;
    double seconds = 0;
};

bool has_polygons(const PolygonMesh& mesh) {
    return std::ranges::any_of(mesh.sizes, [](auto size) { return size != 3; });
}

PolygonMesh control_mesh(const RefineArguments& arguments) {
    if (arguments.repair) return polygon_mesh(triangle_soup(read_input_mesh(arguments.mesh, true).mesh));
    PolygonMesh mesh = read_polygons(arguments.mesh);
    if (arguments.scheme != SubdivisionScheme::Loop || !has_polygons(mesh)) return mesh;
    fmt::print(
        stderr,
        "{}: polygons are cut into triangles for Loop subdivision; --scheme catmull-clark takes them whole\n",
        arguments.mesh);
    return polygon_mesh(triangle_fans(mesh));
}

RefineOptions refine_options(const RefineArguments& arguments, const PolygonMesh& control) {
    RefineOptions options = arguments.options;
    const auto fitting = has_polygons(control) ? SubdivisionScheme::CatmullClark : SubdivisionScheme::Loop;
    options.scheme = arguments.scheme.value_or(fitting);
    if (arguments.crease_file.empty()) return options;
    CreaseList list = read_creases(arguments.crease_file, arguments.features);
    options.creases = std::move(list.creases);
    options.sharp_corners = std::move(list.corners);
    return options;
}

double refined_faces(const PolygonMesh& control, SubdivisionScheme scheme, int levels) {
    if (scheme == SubdivisionScheme::Loop)
        return static_cast<double>(control.face_count()) * std::pow(4.0, levels);
    return static_cast<double>(control.corners.size()) * std::pow(4.0, levels - 1);
}

// All levels are held while refining adaptively; how many it takes shows only then, so those that do not fit are left out.
int levels_that_fit(const PolygonMesh& control, const RefineOptions& options) {
    const bool quads = options.scheme == SubdivisionScheme::CatmullClark;
    int levels = options.levels;
    while (levels > 1 && !has_refine_memory(refined_faces(control, options.scheme, levels), quads)) --levels;
    return levels;
}

Refined refined(const RefineArguments& arguments, const PolygonMesh& control, RefineOptions options) {
    const auto start = std::chrono::steady_clock::now();
    Refined result;
    if (arguments.tolerance) {
        if (!arguments.ignore_memory) options.levels = levels_that_fit(control, options);
        AdaptiveMesh adaptive = adaptive_refine(control, *arguments.tolerance, options);
        result = {std::move(adaptive.refined), adaptive.levels, 0};
        if (options.levels < arguments.options.levels && adaptive.levels == options.levels)
            fmt::print(stderr, "{}: memory is short; faces are {} levels deep at most\n", arguments.mesh,
                       options.levels);
    } else {
        if (!arguments.ignore_memory)
            check_refine_memory(refined_faces(control, options.scheme, options.levels),
                                options.scheme == SubdivisionScheme::CatmullClark);
        result = {refine(control, options), options.levels, 0};
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

const char* scheme_name(SubdivisionScheme scheme) {
    return scheme == SubdivisionScheme::Loop ? "loop" : "catmull-clark";
}

const char* boundary_name(BoundaryRule rule) {
    return rule == BoundaryRule::Smooth ? "smooth" : rule == BoundaryRule::Fixed ? "fixed" : "corners";
}

nlohmann::ordered_json report(const RefineArguments& arguments, const PolygonMesh& control,
                              const RefineOptions& options, const Refined& result) {
    const PolygonMesh& mesh = result.refined.mesh;
    const TriangleSoup soup = triangle_fans(mesh);
    const bool closed = FeatureEdges(control).outline_vertices().empty();
    std::size_t quads = 0;
    for (const auto size : mesh.sizes) quads += size == 4;
    nlohmann::ordered_json json{
        {"file", arguments.output},
        {"scheme", scheme_name(options.scheme)},
        {"levels", result.levels},
        {"boundary", boundary_name(options.boundary)},
        {"limit", options.limit || arguments.tolerance.has_value()},
        {"control", {{"vertices", control.points.size()}, {"faces", control.face_count()}}},
        {"vertices", mesh.points.size()},
        {"faces", mesh.face_count()},
        {"triangles", soup.triangles.size()},
        {"quads", quads},
        {"creases", result.refined.creases},
        {"corners", result.refined.corners},
        {"closed", closed},
        {"volume", closed ? nlohmann::ordered_json(volume(soup)) : nlohmann::ordered_json()},
        {"area", area(soup)},
        {"seconds", result.seconds}};
    if (arguments.tolerance) json["tolerance"] = *arguments.tolerance;
    return json;
}

void print(const nlohmann::ordered_json& json) {
    fmt::print("{}: {} vertices, {} faces ({} from {} at level {})\n", json["file"].get<std::string>(),
               json["vertices"].get<std::size_t>(), json["faces"].get<std::size_t>(),
               json["scheme"].get<std::string>(), json["control"]["faces"].get<std::size_t>(),
               json["levels"].get<int>());
    fmt::print("  {} crease edges, {} sharp corners in the control mesh\n",
               json["creases"].get<std::size_t>(), json["corners"].get<std::size_t>());
    const auto volume = json["volume"].is_null() ? "none (not a closed body)"
                                                 : fmt::format("{:.10g}", json["volume"].get<double>());
    fmt::print("  volume {}, area {:.10g} (input units cubed, squared)\n", volume,
               json["area"].get<double>());
}

LayerSolid drawn(std::size_t order, const std::string& name, const char* color, TriangleSoup soup,
                 double east) {
    for (auto& p : soup.points) p.x += east;
    LayerSolid solid{.order = order,
                     .unit = {.code = std::to_string(order), .name = name, .color = color},
                     .surface = half_edge_mesh(soup)};
    return solid;
}

// The control mesh with its faces flat, and east of it what became of it.
void draw(const RefineArguments& arguments, const PolygonMesh& control, const Refined& result) {
    TriangleSoup flat;  // each triangle with corners of its own has a normal of its own
    const TriangleSoup shared = triangle_fans(control);
    for (const auto& t : shared.triangles) {
        const auto first = static_cast<std::uint32_t>(flat.points.size());
        for (const auto v : t) flat.points.push_back(shared.points[v]);
        flat.triangles.push_back({first, first + 1, first + 2});
    }
    const double width = bounding_box(control.points).size().x;
    std::vector<LayerSolid> solids;
    solids.push_back(drawn(1, "control mesh", "#9db4c0", std::move(flat), 0));
    solids.push_back(drawn(2, fmt::format("refined, level {}", result.levels), "#c8a26a",
                           triangle_fans(result.refined.mesh), 1.4 * width));
    for (auto& solid : solids) update_vertex_normals(solid.surface);
    write_picture(
        arguments.picture, solids,
        {.width = 1000, .height = 560, .vertical_exaggeration = 1, .explode = 0, .length_unit = "units"});
}

void keep_existing_files(const RefineArguments& arguments) {
    const std::filesystem::path output = arguments.output;
    const auto format = mesh_format(output);
    keep_existing(output, arguments.overwrite);
    if (format == MeshFormat::Obj)
        keep_existing(std::filesystem::path(output).replace_extension(".mtl"), arguments.overwrite);
    if (arguments.picture.empty()) return;
    if (std::filesystem::path(arguments.picture).extension() != ".png")
        throw IoError(arguments.picture + ": pictures are written as .png");
    keep_existing(arguments.picture, arguments.overwrite);
}

void run(const RefineArguments& arguments) {
    keep_existing_files(arguments);
    Progress progress("refine");
    progress.step("reading", 0.02);
    PolygonMesh control = control_mesh(arguments);
    const RefineOptions options = refine_options(arguments, control);
    progress.step("subdividing", 0.1);
    Refined result;
    try {
        result = refined(arguments, control, options);
    } catch (const InvalidInput& error) {
        const std::string_view text = error.what();
        const bool mendable =
            text.ends_with("(not a manifold)") || text.ends_with("wound against each other");
        throw InvalidInput(fmt::format(
            "{}: {}{}", arguments.mesh, text,
            mendable ? "; --repair cuts the mesh there, winds triangles alike or drops them" : ""));
    }
    if (arguments.triangles) result.refined.mesh = polygon_mesh(triangle_fans(result.refined.mesh));
    progress.step("writing", 0.8);
    write_polygons(arguments.output, std::filesystem::path(arguments.mesh).stem().string(),
                   result.refined.mesh, result.refined.normals);
    if (!arguments.picture.empty()) draw(arguments, control, result);
    progress.clear();
    const auto json = report(arguments, control, options, result);
    if (arguments.json)
        fmt::print("{}\n", json.dump(2));
    else
        print(json);
}

void add_features(CLI::App& command, RefineArguments& arguments) {
    add_choice<BoundaryRule>(
        command, "--boundary", arguments.options.boundary,
        {{"smooth", BoundaryRule::Smooth},
         {"corners", BoundaryRule::SharpCorners},
         {"fixed", BoundaryRule::Fixed}},
        "Outlines: smooth curves; curves between corners that stay (default); as they are");
    command
        .add_option("--corner-angle", arguments.options.corner_angle_deg,
                    "An outline that turns by more than this many degrees has a corner there")
        ->check(CLI::Range(0.0, 180.0))
        ->capture_default_str();
    command
        .add_option("--crease-angle", arguments.options.crease_angle_deg,
                    "Keep edges sharp whose faces turn by more than this many degrees")
        ->check(CLI::Range(0.0, 180.0));
    auto* file = command.add_option("--crease-edges", arguments.crease_file,
                                    "File of edges and vertices that stay sharp");
    command
        .add_option("--crease-features", arguments.features,
                    "Take these features of the file only, with commas between")
        ->delimiter(',')
        ->needs(file);
}

}  // namespace

void add_refine_command(CLI::App& program) {
    auto arguments = std::make_shared<RefineArguments>();
    CLI::App* command =
        program.add_subcommand("refine", "Smooth a mesh by subdivision (Loop, Catmull-Clark)");
    command->add_option("MESH", arguments->mesh, "Mesh file: .ply .obj .stl .off .glb .3mf")->required();
    command
        ->add_option("-o,--output", arguments->output,
                     "File to write, of the same formats; PLY, OBJ and OFF keep quads")
        ->required();
    add_choice<std::optional<SubdivisionScheme>>(
        *command, "--scheme", arguments->scheme,
        {{"loop", SubdivisionScheme::Loop}, {"catmull-clark", SubdivisionScheme::CatmullClark}},
        "By default loop for triangles, catmull-clark for others");
    command
        ->add_option("--levels", arguments->options.levels,
                     "Each makes four faces of one; with --adaptive, at most")
        ->check(CLI::Range(1, 10))
        ->capture_default_str();
    add_features(*command, *arguments);
    command->add_flag("--limit", arguments->options.limit,
                      "Put vertices on the surface of infinitely many levels, with its normals");
    command
        ->add_option("--adaptive", arguments->tolerance,
                     "Cut faces only where the limit surface is further from them than this (input units)")
        ->check(CLI::PositiveNumber);
    command->add_flag("--triangles", arguments->triangles, "Write quads as triangles");
    command->add_option("--picture", arguments->picture,
                        "File for a picture of the mesh before and after, .png");
    add_repair_option(*command, arguments->repair);
    command->add_flag("--ignore-memory", arguments->ignore_memory, "Try even if memory seems too small");
    command->add_flag("--overwrite", arguments->overwrite, "Replace a file that is there");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace stratareeb
