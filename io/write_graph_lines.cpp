// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_graph_lines.h"

#include <fmt/format.h>

#include "boreholes/errors.h"
#include "io/arc_colors.h"
#include "io/text_output.h"
#include "io/write_aside.h"
#include "io/write_graph.h"

namespace stratareeb {

namespace {

using Curves = std::span<const std::vector<Point3>>;

//! Numbers of the points along an arc.
std::vector<std::size_t> points_along(const ReebArc& arc, const std::vector<Point3>& curve,
                                      std::size_t& next) {
    std::vector<std::size_t> points{arc.lower};
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) points.push_back(next++);
    points.push_back(arc.upper);
    return points;
}

std::size_t inner_points(Curves curves) {
    std::size_t sum = 0;
    for (const auto& curve : curves) sum += curve.size() - 2;
    return sum;
}

void write_ply_point(TextOutput& out, const Point3& p, const Rgb& color) {
    out.print("{} {} {} {} {} {}\n", p.x, p.y, p.z, color[0], color[1], color[2]);
}

void write_ply(std::ostream& stream, const ReebGraph& graph, const TriMesh& mesh, Curves curves) {
    TextOutput out(stream);
    const std::size_t inner = inner_points(curves);
    out.print(
        "ply\nformat ascii 1.0\ncomment Stratareeb: Reeb graph\nelement vertex {}\nproperty double x\n"
        "property double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nelement edge {}\nproperty int vertex1\nproperty int vertex2\n"
        "property int arc\nend_header\n",
        graph.nodes.size() + inner, graph.arcs.size() + inner);
    for (const ReebNode& node : graph.nodes)
        write_ply_point(out, node_place(mesh, node), node_color(node.type));
    const std::vector<Rgb> colors = arc_colors(graph);
    for (std::size_t a = 0; a < curves.size(); ++a)
        for (std::size_t i = 1; i + 1 < curves[a].size(); ++i) write_ply_point(out, curves[a][i], colors[a]);
    std::size_t next = graph.nodes.size();
    for (std::size_t a = 0; a < curves.size(); ++a) {
        const auto points = points_along(graph.arcs[a], curves[a], next);
        for (std::size_t i = 1; i < points.size(); ++i) out.print("{} {} {}\n", points[i - 1], points[i], a);
    }
}

void write_obj(std::ostream& stream, const ReebGraph& graph, const TriMesh& mesh, Curves curves) {
    TextOutput out(stream);
    out.print("# Stratareeb: Reeb graph\n");
    for (const ReebNode& node : graph.nodes) {
        const Point3 p = node_place(mesh, node);
        out.print("v {} {} {}\n", p.x, p.y, p.z);
    }
    for (const auto& curve : curves)
        for (std::size_t i = 1; i + 1 < curve.size(); ++i)
            out.print("v {} {} {}\n", curve[i].x, curve[i].y, curve[i].z);
    std::size_t next = graph.nodes.size();
    for (std::size_t a = 0; a < curves.size(); ++a) {
        out.print("l");
        for (const std::size_t point : points_along(graph.arcs[a], curves[a], next))
            out.print(" {}", point + 1);
        out.print("\n");
    }
}

}  // namespace

bool is_graph_lines_file(const std::filesystem::path& file) {
    return file.extension() == ".ply" || file.extension() == ".obj";
}

void write_graph_lines(const std::filesystem::path& file, const ReebGraph& graph, const TriMesh& mesh,
                       Curves curves) {
    if (!is_graph_lines_file(file))
        throw IoError(file.string() + ": graphs are written as lines in .ply or .obj");
    if (curves.size() != graph.arcs.size())
        throw InvalidInput(fmt::format("{} curves for a graph of {} arcs", curves.size(), graph.arcs.size()));
    for (std::size_t a = 0; a < curves.size(); ++a)
        if (curves[a].size() < 2) throw InvalidInput(fmt::format("the curve of arc {} has no ends", a));
    write_aside(file, [&](std::ostream& stream) {
        file.extension() == ".ply" ? write_ply(stream, graph, mesh, curves)
                                   : write_obj(stream, graph, mesh, curves);
    });
}

}  // namespace stratareeb
