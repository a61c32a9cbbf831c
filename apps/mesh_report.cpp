// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/mesh_report.h"

#include <fmt/format.h>

namespace stratareeb {
namespace {

const char* yes(bool value) {
    return value ? "yes" : "no";
}

std::string text(const Point3& p) {
    return fmt::format("({:.10g}, {:.10g}, {:.10g})", p.x, p.y, p.z);
}

nlohmann::json list(const Point3& p) {
    return {p.x, p.y, p.z};
}

std::string counts(const MeshReport& r) {
    const auto genus = r.genus ? fmt::format("{}", *r.genus) : "not defined";
    return fmt::format("  {} vertices, {} triangles, {} component{}, genus {}, Euler characteristic {}\n",
                       r.vertices, r.triangles, r.components, r.components == 1 ? "" : "s", genus, r.euler);
}

std::string flags(const MeshReport& r) {
    std::string result =
        fmt::format("  closed {}, manifold {}, oriented {}", yes(r.closed), yes(r.manifold), yes(r.oriented));
    if (!r.closed)
        result += fmt::format(", {} boundary loop{}", r.boundary_loops, r.boundary_loops == 1 ? "" : "s");
    return result + fmt::format("\n  {} self-intersections, {} triangles without area, {} unused vertices\n",
                                r.self_intersections, r.degenerate_triangles, r.unused_vertices);
}

std::string measures(const MeshReport& r) {
    const auto volume =
        r.closed && r.oriented ? fmt::format("{:.10g}", r.volume) : "none (not a closed body)";
    return fmt::format(
        "  volume {}, area {:.10g} (input units cubed, squared)\n"
        "  box {} to {} (input units)\n"
        "  edges {:.6g} to {:.6g}, angles {:.4g} to {:.4g} degrees\n"
        "  worst triangle: number {} at {}, longest side {:.4g} times its height\n",
        volume, r.area, text(r.box_min), text(r.box_max), r.min_edge, r.max_edge, r.min_angle_deg,
        r.max_angle_deg, r.worst_triangle.value_or(0), text(r.worst_place), r.worst_aspect_ratio);
}

}  // namespace

std::string report_text(const std::string& what, const MeshReport& report) {
    std::string result = fmt::format("{}: {}\n", what, report.watertight ? "watertight" : "NOT watertight");
    result += counts(report);
    if (report.triangles > 0) result += flags(report) + measures(report);
    for (const auto& problem : report.problems) result += fmt::format("  problem: {}\n", problem);
    return result;
}

nlohmann::json report_json(const MeshReport& r) {
    return {{"vertices", r.vertices},
            {"unused_vertices", r.unused_vertices},
            {"triangles", r.triangles},
            {"components", r.components},
            {"euler", r.euler},
            {"genus", r.genus ? nlohmann::json(*r.genus) : nlohmann::json()},
            {"boundary_edges", r.boundary_edges},
            {"boundary_loops", r.boundary_loops},
            {"non_manifold_edges", r.non_manifold_edges},
            {"non_manifold_vertices", r.non_manifold_vertices},
            {"degenerate_triangles", r.degenerate_triangles},
            {"self_intersections", r.self_intersections},
            {"closed", r.closed},
            {"manifold", r.manifold},
            {"oriented", r.oriented},
            {"orientable", r.orientable},
            {"watertight", r.watertight},
            {"volume", r.volume},
            {"area", r.area},
            {"box", {list(r.box_min), list(r.box_max)}},
            {"edge_length", {r.min_edge, r.max_edge}},
            {"angle_deg", {r.min_angle_deg, r.max_angle_deg}},
            {"worst_aspect_ratio", r.worst_aspect_ratio},
            {"worst_triangle", r.worst_triangle ? nlohmann::json(*r.worst_triangle) : nlohmann::json()},
            {"worst_place", list(r.worst_place)},
            {"problems", r.problems}};
}

std::string part_label(const std::string& file, const std::string& part, std::size_t parts) {
    return parts > 1 ? file + ", part " + part : file;
}

std::string json_text(const nlohmann::json& value) {
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace stratareeb
