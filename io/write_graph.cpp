// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_graph.h"

#include "boreholes/errors.h"
#include "io/text_output.h"
#include "io/write_aside.h"
#include "io/write_graph_json.h"

namespace stratareeb {

namespace {

void write_dot(std::ostream& stream, const ReebGraph& graph) {
    TextOutput out(stream);
    out.print("graph reeb {{\n  rankdir=BT;\n");
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        out.print("  n{} [label=\"{}\" tooltip=\"{}, vertex {}\"];\n", i, graph.nodes[i].value,
                  type_name(graph.nodes[i].type), graph.nodes[i].vertex);
    for (const ReebArc& arc : graph.arcs) out.print("  n{} -- n{};\n", arc.lower, arc.upper);
    out.print("}}\n");
}

void write_graphml(std::ostream& stream, const ReebGraph& graph, const TriMesh& mesh) {
    TextOutput out(stream);
    out.print(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
        "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n");
    for (const char* key : {"x", "y", "z", "value"})
        out.print("<key id=\"{0}\" for=\"node\" attr.name=\"{0}\" attr.type=\"double\"/>\n", key);
    out.print(
        "<key id=\"type\" for=\"node\" attr.name=\"type\" attr.type=\"string\"/>\n<graph id=\"reeb\" "
        "edgedefault=\"undirected\">\n");
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Point3 p = node_place(mesh, graph.nodes[i]);
        out.print(
            "<node id=\"n{}\"><data key=\"x\">{}</data><data key=\"y\">{}</data><data "
            "key=\"z\">{}</data><data key=\"value\">{}</data>"
            "<data key=\"type\">{}</data></node>\n",
            i, p.x, p.y, p.z, graph.nodes[i].value, type_name(graph.nodes[i].type));
    }
    // Readers keep edges between the same nodes apart by their ids.
    for (std::size_t i = 0; i < graph.arcs.size(); ++i)
        out.print("<edge id=\"e{}\" source=\"n{}\" target=\"n{}\"/>\n", i, graph.arcs[i].lower,
                  graph.arcs[i].upper);
    out.print("</graph>\n</graphml>\n");
}

}  // namespace

const char* type_name(CriticalType type) {
    return type == CriticalType::Minimum ? "minimum" : type == CriticalType::Saddle ? "saddle" : "maximum";
}

Point3 node_place(const TriMesh& mesh, const ReebNode& node) {
    const auto& p = mesh.point(TriMesh::VertexHandle(static_cast<int>(node.vertex)));
    return {p[0], p[1], p[2]};
}

bool is_graph_file(const std::filesystem::path& file) {
    return file.extension() == ".json" || file.extension() == ".dot" || file.extension() == ".graphml";
}

void write_graph(const std::filesystem::path& file, const ReebGraph& graph, const TriMesh& mesh,
                 const GraphDetails& details) {
    if (!is_graph_file(file))
        throw IoError(file.string() + ": graphs are written as .json, .dot or .graphml");
    write_aside(file, [&](std::ostream& stream) {
        if (file.extension() == ".json")
            write_graph_json(stream, graph, mesh, details);
        else if (file.extension() == ".dot")
            write_dot(stream, graph);
        else
            write_graphml(stream, graph, mesh);
    });
}

}  // namespace stratareeb
