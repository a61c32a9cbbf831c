// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_layered_graph.h"

#include <array>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

std::array<double, 3> numbers(const Point3& p) {
    return {p.x, p.y, p.z};
}

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump();
}

void write_json(std::ostream& stream, const LayeredReebGraph& graph, std::span<const std::string> layers) {
    using Json = nlohmann::ordered_json;
    Json nodes = Json::array(), arcs = Json::array();
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        Json contours = Json::array();
        for (const LayerContour& piece : graph.nodes[n].contours) {
            Json points = Json::array();
            for (const Point3& p : piece.contour.points) points.push_back(numbers(p));
            contours.push_back({{"layer", piece.layer},
                                {"arc", piece.arc == ReebGraph::kNone ? Json() : Json(piece.arc)},
                                {"center", numbers(piece.center)},
                                {"closed", piece.contour.closed},
                                {"points", points}});
        }
        nodes.push_back({{"id", n},
                         {"value", graph.nodes[n].value},
                         {"center", numbers(graph.nodes[n].center)},
                         {"contours", contours}});
    }
    for (const LayeredArc& arc : graph.arcs)
        arcs.push_back({{"from", arc.lower}, {"to", arc.upper}, {"layer", arc.layer}});
    stream << Json{{"layers", layers}, {"nodes", nodes}, {"arcs", arcs}}.dump(1) << '\n';
}

//! Colours of layers for GraphViz, as hue, saturation and value; steps of the golden ratio keep neighbours apart.
std::string dot_color(std::size_t layer) {
    const double hue = static_cast<double>(layer) * 0.6180339887498949;
    return fmt::format("{:.3f} 0.8 0.7", hue - static_cast<double>(static_cast<long>(hue)));
}

void write_dot(std::ostream& stream, const LayeredReebGraph& graph, std::span<const std::string> layers) {
    TextOutput out(stream);
    out.print("graph layers {{\n  rankdir=BT;\n");
    for (std::size_t n = 0; n < graph.nodes.size(); ++n)
        out.print("  n{} [label=\"{}\" tooltip=\"{} contours\"];\n", n, graph.nodes[n].value,
                  graph.nodes[n].contours.size());
    for (const LayeredArc& arc : graph.arcs)
        out.print("  n{} -- n{} [color=\"{}\" tooltip={}];\n", arc.lower, arc.upper, dot_color(arc.layer),
                  quoted(layers[arc.layer]));
    out.print("}}\n");
}

class ObjOutput {
 public:
    explicit ObjOutput(std::ostream& stream) : out_(stream) {}

    void group(const std::string& name) { out_.print("g {}\n", name); }
    void line(const std::vector<Point3>& points, bool closed) {
        for (const Point3& p : points) out_.print("v {} {} {}\n", p.x, p.y, p.z);
        out_.print("l");
        for (std::size_t i = 0; i < points.size(); ++i) out_.print(" {}", next_ + i);
        if (closed) out_.print(" {}", next_);
        out_.print("\n");
        next_ += points.size();
    }

 private:
    TextOutput out_;
    std::size_t next_ = 1;
};

void write_obj(std::ostream& stream, const LayeredReebGraph& graph, std::span<const std::string> layers) {
    ObjOutput obj(stream);
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
        obj.group("contours_" + std::to_string(layer));
        for (const LayeredNode& node : graph.nodes)
            for (const LayerContour& piece : node.contours)
                if (piece.layer == layer && piece.contour.points.size() > 1)
                    obj.line(piece.contour.points, piece.contour.closed);
        obj.group("arcs_" + std::to_string(layer));
        for (const LayeredArc& arc : graph.arcs)
            if (arc.layer == layer)
                obj.line({graph.nodes[arc.lower].center, graph.nodes[arc.upper].center}, false);
    }
}

}  // namespace

void write_layered_graph(const std::filesystem::path& file, const LayeredReebGraph& graph,
                         std::span<const std::string> layers) {
    const std::string extension = file.extension().string();
    if (extension != ".json" && extension != ".dot" && extension != ".obj")
        throw IoError(file.string() + ": layered graphs are written as .json, .dot or .obj");
    write_aside(file, [&](std::ostream& stream) {
        if (extension == ".json")
            write_json(stream, graph, layers);
        else if (extension == ".dot")
            write_dot(stream, graph, layers);
        else
            write_obj(stream, graph, layers);
    });
}

}  // namespace stratareeb
