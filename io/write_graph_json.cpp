// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_graph_json.h"

#include <fmt/ranges.h>

#include "io/text_output.h"

namespace stratareeb {

namespace {

std::vector<std::size_t> counts(const std::vector<std::uint32_t>& arc_of, std::size_t arcs) {
    std::vector<std::size_t> result(arcs, 0);
    for (const std::uint32_t arc : arc_of)
        if (arc != ReebGraph::kNone) ++result[arc];
    return result;
}

const char* comma(std::size_t i) {
    return i ? ",\n" : "\n";
}

void write_nodes(TextOutput& out, const ReebGraph& graph, const TriMesh& mesh) {
    out.print("\"nodes\": [");
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const ReebNode& node = graph.nodes[i];
        const Point3 p = node_place(mesh, node);
        out.print(
            "{} {{\"id\": {}, \"vertex\": {}, \"position\": [{}, {}, {}], \"value\": {}, \"type\": \"{}\", "
            "\"down\": {}, \"up\": {}}}",
            comma(i), i, node.vertex, p.x, p.y, p.z, node.value, type_name(node.type), node.down, node.up);
    }
    out.print("\n]");
}

void write_arcs(TextOutput& out, const ReebGraph& graph) {
    const auto vertices = counts(graph.vertex_arc, graph.arcs.size()),
               triangles = counts(graph.triangle_arc, graph.arcs.size());
    out.print("\"arcs\": [");
    for (std::size_t i = 0; i < graph.arcs.size(); ++i)
        out.print("{} {{\"from\": {}, \"to\": {}, \"vertices\": {}, \"triangles\": {}}}", comma(i),
                  graph.arcs[i].lower, graph.arcs[i].upper, vertices[i], triangles[i]);
    out.print("\n]");
}

void write_pairs(TextOutput& out, const std::vector<PersistencePair>& pairs) {
    out.print(",\n\"pairs\": [");
    for (std::size_t i = 0; i < pairs.size(); ++i)
        out.print("{} {{\"kind\": \"{}\", \"lower\": {}, \"upper\": {}, \"persistence\": {}}}", comma(i),
                  kind_name(pairs[i].kind), pairs[i].lower, pairs[i].upper, pairs[i].persistence);
    out.print("\n]");
}

void write_loops(TextOutput& out, const std::vector<LoopHandle>& loops) {
    out.print(",\n\"loops\": [");
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const LoopHandle& loop = loops[i];
        const PersistencePair& pair = loop.cycle.pair;
        out.print(
            "{} {{\"nodes\": [{}, {}], \"persistence\": {}, \"arcs\": [[{}], [{}]], \"triangles\": {}, "
            "\"box\": [[{}, {}, {}], [{}, {}, {}]]}}",
            comma(i), pair.lower, pair.upper, pair.persistence, fmt::join(loop.cycle.sides[0], ", "),
            fmt::join(loop.cycle.sides[1], ", "), loop.triangles.size(), loop.box_min.x, loop.box_min.y,
            loop.box_min.z, loop.box_max.x, loop.box_max.y, loop.box_max.z);
    }
    out.print("\n]");
}

}  // namespace

const char* kind_name(PairKind kind) {
    switch (kind) {
        case PairKind::Join:
            return "join";
        case PairKind::Split:
            return "split";
        case PairKind::Loop:
            return "loop";
        case PairKind::Component:
            return "component";
    }
    return "";
}

void write_graph_json(std::ostream& stream, const ReebGraph& graph, const TriMesh& mesh,
                      const GraphDetails& details) {
    TextOutput out(stream);
    out.print("{{");
    write_nodes(out, graph, mesh);
    out.print(",\n");
    write_arcs(out, graph);
    if (details.pairs) write_pairs(out, *details.pairs);
    if (details.loops) write_loops(out, *details.loops);
    out.print("}}\n");
}

}  // namespace stratareeb
