// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_enhanced_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <set>
#include <span>

#include "boreholes/errors.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

class GraphText {
 public:
    explicit GraphText(const EnhancedReebGraph& graph) : graph_(graph) {}

    std::string run(std::string_view comment, const std::optional<PlaneFrame>& axes) {
        print("{{\n");
        if (!comment.empty()) print(" \"comment\": {},\n", quoted(std::string(comment)));
        if (axes) print_axes(*axes);
        list("nodes", graph_.nodes, [&](const EnhancedNode& node) { print_node(node); });
        print(",\n");
        list("contours", graph_.contours, [&](const EnhancedContour& contour) { print_contour(contour); });
        print(",\n");
        list("edges", graph_.edges, [&](const EnhancedEdge& edge) { print_edge(edge); });
        print("\n}}\n");
        return fmt::to_string(text_);
    }

 private:
    template <class... Arguments>
    void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

    [[noreturn]] void refuse(std::string_view why) const {
        throw InvalidInput(fmt::format("the graph can't be written: {}: {}", where_, why));
    }

    template <class Things, class Print>
    void list(const char* key, const Things& things, const Print& print_one) {
        std::set<GraphId> names;
        print(" \"{}\": [", key);
        for (std::size_t i = 0; i < things.size(); ++i) {
            where_ = fmt::format("{}[{}]", key, i);
            if constexpr (requires { things[i].id; })
                if (!names.insert(things[i].id).second) refuse("another one has its name");
            print("{}\n  ", i > 0 ? "," : "");
            print_one(things[i]);
        }
        print("{}]", things.empty() ? "" : "\n ");
    }

    std::string quoted(const std::string& text) const {
        try {
            return nlohmann::json(text).dump();
        } catch (const nlohmann::json::exception&) {
            refuse("a text is not UTF-8");
        }
    }

    std::string name(const GraphId& id) const {
        if (const auto* number = std::get_if<std::int64_t>(&id)) return std::to_string(*number);
        return quoted(std::get<std::string>(id));
    }

    //! The shortest digits that read back as the same double; JSON's -0 would lose its sign.
    std::string digits(double number) const {
        if (!std::isfinite(number)) refuse(fmt::format("{} is no number for JSON", number));
        return number == 0 && std::signbit(number) ? "-0.0" : fmt::format("{}", number);
    }

    void print_numbers(const char* key, std::span<const double> numbers) {
        print(", \"{}\": [", key);
        for (std::size_t i = 0; i < numbers.size(); ++i) print("{}{}", i > 0 ? ", " : "", digits(numbers[i]));
        print("]");
    }

    void print_number(const char* key, double number) { print(", \"{}\": {}", key, digits(number)); }

    void print_point(const Point3& p, bool has_height) {
        print("[{}, {}", digits(p.x), digits(p.y));
        if (has_height) print(", {}", digits(p.z));
        print("]");
    }

    void print_points(std::span<const Point3> points, bool with_heights) {
        print("\"points\": [");
        for (std::size_t i = 0; i < points.size(); ++i) {
            print("{}", i > 0 ? ", " : "");
            print_point(points[i], with_heights);
        }
        print("]");
    }

    void print_axes(const PlaneFrame& axes) {
        print(" \"axes\": [");
        print_point(axes.u, true);
        print(", ");
        print_point(axes.v, true);
        print(", ");
        print_point(axes.w, true);
        print("],\n");
    }

    void print_node(const EnhancedNode& node) {
        print("{{\"id\": {}, \"position\": ", name(node.id));
        print_point(node.position, true);
        if (node.form != NodeForm::Point)
            print(", \"form\": \"{}\"", node.form == NodeForm::Flat ? "flat" : "open");
        print("}}");
    }

    //! The height that stands once for all points: they have it to the last bit.
    static std::optional<double> common_height(const Curve& curve) {
        if (curve.kind == CurveKind::Circle)
            return curve.normal == Point3{0, 0, 1} ? std::optional(curve.center.z) : std::nullopt;
        if (curve.points.empty()) return std::nullopt;
        const auto bits = [](const Point3& p) { return std::bit_cast<std::uint64_t>(p.z); };
        const bool is_level = std::ranges::all_of(
            curve.points, [&](const Point3& p) { return bits(p) == bits(curve.points.front()); });
        return is_level ? std::optional(curve.points.front().z) : std::nullopt;
    }

    void print_contour(const EnhancedContour& contour) {
        const Curve& curve = contour.curve;
        if (!curve.closed) refuse("its curve is not closed");
        print("{{\"id\": {}, \"type\": \"{}\"", name(contour.id), curve_name(curve.kind, true));
        const auto z = common_height(curve);
        if (z) print_number("z", *z);
        print(", ");
        if (curve.kind == CurveKind::Circle) {
            print_circle(curve, !z);
        } else {
            print_points(curve.points, !z);
            print_parameters(curve);
        }
        print("}}");
    }

    void print_circle(const Curve& curve, bool is_tilted) {
        print("\"center\": ");
        print_point(curve.center, is_tilted);
        print_number("radius", curve.radius);
        if (!is_tilted) return;
        print(", \"normal\": ");
        print_point(curve.normal, true);
    }

    void print_parameters(const Curve& curve) {
        if (curve.kind == CurveKind::Nurbs) {
            print(", \"degree\": {}", curve.degree);
            if (!curve.knots.empty()) print_numbers("knots", curve.knots);
            if (!curve.weights.empty()) print_numbers("weights", curve.weights);
        }
        if (curve.kind == CurveKind::Cardinal) print_number("tension", curve.tension);
        if (curve.kind != CurveKind::CatmullRom) return;
        print_number("a", curve.a);
        print_number("b", curve.b);
    }

    void print_edge(const EnhancedEdge& edge) {
        if (std::max(edge.from, edge.to) >= graph_.nodes.size()) refuse("its node is not in the graph");
        print("{{\"from\": {}, \"to\": {}", name(graph_.nodes[edge.from].id), name(graph_.nodes[edge.to].id));
        if (edge.curve.kind != CurveKind::Polyline || !edge.curve.points.empty())
            print_edge_curve(edge.curve);
        print(", \"contours\": [");
        for (std::size_t i = 0; i < edge.contours.size(); ++i) {
            if (edge.contours[i] >= graph_.contours.size()) refuse("its contour is not in the graph");
            print("{}{}", i > 0 ? ", " : "", name(graph_.contours[edge.contours[i]].id));
        }
        print("]");
        if (edge.homotopy != HomotopyOptions{}) print_homotopy(edge.homotopy);
        print("}}");
    }

    void print_edge_curve(const Curve& curve) {
        const bool is_known = curve.kind == CurveKind::Polyline || curve.kind == CurveKind::Cardinal ||
                              curve.kind == CurveKind::CatmullRom;
        if (!is_known || curve.closed)
            refuse("its curve is not an open line, Cardinal or Catmull-Rom spline");
        print(", \"curve\": {{\"type\": \"{}\", ", curve_name(curve.kind, false));
        print_points(curve.points, true);
        print_parameters(curve);
        print("}}");
    }

    //! By its name if all its numbers are the defaults.
    void print_homotopy(const HomotopyOptions& options) {
        const HomotopyOptions plain{.kind = options.kind};
        if (options == plain) {
            print(", \"homotopy\": \"{}\"", homotopy_name(options.kind));
            return;
        }
        print(", \"homotopy\": {{\"kind\": \"{}\"", homotopy_name(options.kind));
        if (options.pace != plain.pace) print(", \"pace\": \"round\"");
        if (options.direction != plain.direction) print(", \"direction\": \"downward\"");
        if (options.tension != plain.tension) print_number("tension", options.tension);
        if (options.a != plain.a) print_number("a", options.a);
        if (options.b != plain.b) print_number("b", options.b);
        print("}}");
    }

    const EnhancedReebGraph& graph_;
    fmt::memory_buffer text_;
    std::string where_ = "comment";  // for messages
};

}  // namespace

std::string enhanced_graph_text(const EnhancedReebGraph& graph, std::string_view comment,
                                const std::optional<PlaneFrame>& axes) {
    return GraphText(graph).run(comment, axes);
}

void write_enhanced_graph(const std::filesystem::path& file, const EnhancedReebGraph& graph,
                          std::string_view comment, const std::optional<PlaneFrame>& axes) {
    const std::string text = enhanced_graph_text(graph, comment, axes);
    write_aside(file, [&](std::ostream& stream) { stream << text; });
}

}  // namespace stratareeb
