// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_enhanced_graph.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "boreholes/errors.h"
#include "io/checked_json.h"
#include "io/text_scanner.h"
#include "reeb/graph_conditions.h"

namespace stratareeb {

namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kLongestHint = 60;  // bytes of a name in a message

struct Form {
    CurveKind kind;
    Words parameters;
};

const std::vector<Form> kContourForms = {{CurveKind::Polyline, {"z", "points"}},
                                         {CurveKind::Circle, {"z", "center", "radius", "normal"}},
                                         {CurveKind::Bezier, {"z", "points"}},
                                         {CurveKind::Nurbs, {"z", "points", "degree", "knots", "weights"}},
                                         {CurveKind::Cardinal, {"z", "points", "tension"}},
                                         {CurveKind::CatmullRom, {"z", "points", "a", "b"}}};
const std::vector<Form> kEdgeForms = {{CurveKind::Polyline, {"points"}},
                                      {CurveKind::Cardinal, {"points", "tension"}},
                                      {CurveKind::CatmullRom, {"points", "a", "b"}}};
const Words kNodeForms = {"point", "flat", "open"};
const Words kHomotopies = {"linear", "parabola", "quadrant", "cardinal", "catmull-rom", "natural-cubic"};

//! The text among some words; a fault names the nearest.
std::optional<std::string> word(const JsonItem& item, const Words& words) {
    auto text = item.text();
    if (!text || std::ranges::find(words, *text) != words.end()) return text;
    item.expected(
        fmt::format("one of {}; did you mean \"{}\"?", fmt::join(words, ", "), nearest_word(*text, words)));
    return std::nullopt;
}

void read_number(const JsonItem& owner, std::string_view key, double& number) {
    if (const auto item = owner.find(key)) number = item->number().value_or(number);
}

void read_numbers(const JsonItem& owner, std::string_view key, std::vector<double>& numbers) {
    if (const auto item = owner.find(key)) numbers = item->numbers().value_or(numbers);
}

//! A point of three numbers, or of two if their height stands beside them.
Point3 read_point(const JsonItem& item, const std::optional<double>& z = std::nullopt) {
    const auto numbers = item.numbers();
    if (!numbers) return {};
    if (z && numbers->size() == 2) return {(*numbers)[0], (*numbers)[1], *z};
    if (!z && numbers->size() == 3) return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    item.expected(z ? "two numbers [x, y], since \"z\" stands beside" : "three numbers [x, y, z]");
    return {};
}

std::vector<Point3> read_points(const JsonItem& list, const std::optional<double>& z = std::nullopt) {
    std::vector<Point3> points;
    for (const JsonItem& item : list.list("a list of points")) points.push_back(read_point(item, z));
    return points;
}

NodeForm node_form(std::string_view name) {
    return name == "flat" ? NodeForm::Flat : name == "open" ? NodeForm::Open : NodeForm::Point;
}

//! Three unit vectors at right angles, right-handed.
std::optional<PlaneFrame> read_axes(const JsonItem& item) {
    const std::vector<Point3> axes = read_points(item);
    constexpr double kRight = 1e-9;
    const auto dot = [](const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    if (axes.size() == 3) {
        const auto& [u, v, w] = std::tie(axes[0], axes[1], axes[2]);
        const Point3 across{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        if (std::abs(dot(u, u) - 1) < kRight && std::abs(dot(v, v) - 1) < kRight &&
            std::abs(dot(u, v)) < kRight && std::abs(across.x - w.x) < kRight &&
            std::abs(across.y - w.y) < kRight && std::abs(across.z - w.z) < kRight)
            return PlaneFrame{u, v, w};
    }
    item.expected("three unit vectors at right angles, right-handed: the x, y and z axes");
    return std::nullopt;
}

//! The height that stands beside points; 0 where it does and is none, which is a fault already.
std::optional<double> read_height(const JsonItem& owner) {
    const auto item = owner.find("z");
    return item ? std::optional(item->number().value_or(0)) : std::nullopt;
}

void read_degree(const JsonItem& item, int& degree) {
    const auto number = item.whole_number();
    if (number && (*number < 1 || *number > 100)) return item.expected("a whole number from 1 to 100");
    if (number) degree = static_cast<int>(*number);
}

//! The form that `type` names; nothing if that is wrong.
const Form* read_form(const JsonItem& owner, const std::vector<Form>& forms, bool closed) {
    const auto type = owner.need("type");
    if (!type) return nullptr;
    Words names;
    for (const Form& form : forms) names.push_back(curve_name(form.kind, closed));
    const auto name = word(*type, names);
    if (!name) return nullptr;
    return &forms[static_cast<std::size_t>(std::ranges::find(names, *name) - names.begin())];
}

//! \param keys what the object may have besides the parameters of its form
Curve read_curve(const JsonItem& owner, const std::vector<Form>& forms, bool closed, Words keys) {
    Curve curve{.closed = closed};
    const Form* form = read_form(owner, forms, closed);
    if (form == nullptr) return curve;
    curve.kind = form->kind;
    keys.insert(keys.end(), form->parameters.begin(), form->parameters.end());
    owner.know_keys(keys);
    const auto z = closed ? read_height(owner) : std::nullopt;
    if (form->kind == CurveKind::Circle) {
        if (const auto center = owner.need("center")) curve.center = read_point(*center, z);
        if (const auto radius = owner.need("radius")) curve.radius = radius->number().value_or(0);
        if (const auto normal = owner.find("normal")) curve.normal = read_point(*normal);
        return curve;
    }
    if (const auto points = owner.need("points")) curve.points = read_points(*points, z);
    if (const auto degree = owner.find("degree")) read_degree(*degree, curve.degree);
    read_numbers(owner, "knots", curve.knots);
    read_numbers(owner, "weights", curve.weights);
    read_number(owner, "tension", curve.tension);
    read_number(owner, "a", curve.a);
    read_number(owner, "b", curve.b);
    return curve;
}

HomotopyKind read_homotopy_kind(const JsonItem& item) {
    const auto name = word(item, kHomotopies);
    return name ? *homotopy_kind(*name) : HomotopyKind{};
}

HomotopyOptions read_homotopy(const JsonItem& item) {
    HomotopyOptions options;
    if (item.is_text()) {
        options.kind = read_homotopy_kind(item);
        return options;
    }
    if (!item.need_object("a name such as \"linear\", or an object with its \"kind\"")) return options;
    item.know_keys(Words{"kind", "pace", "direction", "tension", "a", "b"});
    if (const auto kind = item.need("kind")) options.kind = read_homotopy_kind(*kind);
    if (const auto direction = item.find("direction"))
        if (const auto name = word(*direction, {"upward", "downward"}); name && *name == "downward")
            options.direction = HomotopyDirection::Downward;
    if (const auto pace = item.find("pace"))
        if (const auto name = word(*pace, {"even", "round"}); name && *name == "round")
            options.pace = HomotopyPace::Round;
    read_number(item, "tension", options.tension);
    read_number(item, "a", options.a);
    read_number(item, "b", options.b);
    return options;
}

std::optional<GraphId> read_id(const JsonItem& item) {
    if (item.is_text()) return item.text();
    if (item.is_whole_number()) return item.whole_number();
    item.expected("a whole number or a text");
    return std::nullopt;
}

//! Which number in its list each name has.
class NameIndex {
 public:
    explicit NameIndex(std::string_view kind) : kind_(kind) {}

    //! The name of the next thing in the list.
    GraphId add(const JsonItem& owner) {
        const auto number = static_cast<std::uint32_t>(next_++);
        const auto item = owner.need("id");
        const auto id = item ? read_id(*item) : std::nullopt;
        if (!id) return {};
        const auto [place, is_new] = numbers_.emplace(*id, number);
        if (!is_new)
            item->expected(fmt::format("a name of its own; {}s[{}] has that one", kind_, place->second));
        return *id;
    }

    //! The number of the thing that is named here; 0 if there is none.
    std::uint32_t find(const JsonItem& item) const {
        if (!item.is_text() && !item.is_whole_number()) {
            item.expected(fmt::format("the id of a {}", kind_));
            return 0;
        }
        const auto id = read_id(item);
        if (!id) return 0;
        const auto found = numbers_.find(*id);
        if (found != numbers_.end()) return found->second;
        item.expected(fmt::format("the id of a {}{}", kind_, hint(*id)));
        return 0;
    }

 private:
    std::string hint(const GraphId& id) const {
        if (numbers_.empty()) return "; there are none";
        const std::string other = other_form(id);
        std::vector<std::string> names;
        for (const auto& [name, number] : numbers_) names.push_back(text_of(name));
        if (std::ranges::find(names, other) != names.end()) return fmt::format("; there is {}", other);
        const auto nearest = nearest_word(text_of(id), Words(names.begin(), names.end()));
        return nearest.size() > kLongestHint ? "" : fmt::format("; did you mean {}?", nearest);
    }

    //! "1" for 1 and 1 for "1": quotes are easily forgotten.
    static std::string other_form(const GraphId& id) {
        if (const auto* text = std::get_if<std::string>(&id)) return *text;
        return '"' + text_of(id) + '"';
    }

    std::string_view kind_;
    std::map<GraphId, std::uint32_t> numbers_;
    std::size_t next_ = 0;
};

//! From the lower node to the upper one. A piece of a Catmull-Rom spline seen from its other end has 1 - b for a.
void turn_over(EnhancedEdge& edge) {
    std::swap(edge.from, edge.to);
    std::ranges::reverse(edge.curve.points);
    const double a = edge.curve.a;
    if (edge.curve.kind != CurveKind::CatmullRom) return;
    edge.curve.a = 1 - edge.curve.b;
    edge.curve.b = 1 - a;
}

class GraphReader {
 public:
    explicit GraphReader(FileFaults& faults) : faults_(faults) {}

    EnhancedGraphFile read(const nlohmann::json& document) {
        const JsonItem file(document, "", faults_);
        if (!file.need_object("an object with nodes, contours and edges")) return {};
        if (file.find("contours") && !file.find("nodes") && !file.find("edges")) {
            file.fault("there are no nodes and edges, so it is not a graph (a stack of contours?)");
            return {};
        }
        file.know_keys(Words{"comment", "axes", "nodes", "contours", "edges"});
        if (const auto axes = file.find("axes")) result_.axes = read_axes(*axes);
        if (const auto comment = file.find("comment")) result_.comment = comment->text().value_or("");
        for (const JsonItem& item : entries(file, "nodes")) read_node(item);
        for (const JsonItem& item : entries(file, "contours")) read_contour(item);
        for (const JsonItem& item : entries(file, "edges")) read_edge(item);
        return std::move(result_);
    }

 private:
    static std::vector<JsonItem> entries(const JsonItem& file, std::string_view key) {
        const auto list = file.need(key);
        return list ? list->list("a list of objects") : std::vector<JsonItem>{};
    }

    void read_node(const JsonItem& item) {
        EnhancedNode& node = result_.graph.nodes.emplace_back();
        if (!item.need_object("a node as an object")) return;
        item.know_keys(Words{"id", "position", "form"});
        node.id = nodes_.add(item);
        if (const auto position = item.need("position")) node.position = read_point(*position);
        if (const auto form = item.find("form"))
            if (const auto name = word(*form, kNodeForms)) node.form = node_form(*name);
    }

    void read_contour(const JsonItem& item) {
        EnhancedContour& contour = result_.graph.contours.emplace_back();
        if (!item.need_object("a contour as an object")) return;
        contour.id = contours_.add(item);
        contour.curve = read_curve(item, kContourForms, true, {"id", "type"});
    }

    void read_edge(const JsonItem& item) {
        EnhancedEdge& edge = result_.graph.edges.emplace_back();
        if (!item.need_object("an edge as an object")) return;
        item.know_keys(Words{"from", "to", "curve", "contours", "homotopy"});
        const auto from = item.need("from"), to = item.need("to");
        if (from) edge.from = nodes_.find(*from);
        if (to) edge.to = nodes_.find(*to);
        if (const auto curve = item.find("curve"); curve && curve->need_object("a curve as an object"))
            edge.curve = read_curve(*curve, kEdgeForms, false, {"type"});
        if (const auto list = item.need("contours"))
            for (const JsonItem& id : list->list("a list of contours' ids, bottom to top"))
                edge.contours.push_back(contours_.find(id));
        if (const auto homotopy = item.find("homotopy")) edge.homotopy = read_homotopy(*homotopy);
        if (faults_.count() > 0) return;
        const auto& nodes = result_.graph.nodes;
        if (nodes[edge.from].position.z > nodes[edge.to].position.z) turn_over(edge);
    }

    FileFaults& faults_;
    EnhancedGraphFile result_;
    NameIndex nodes_{"node"}, contours_{"contour"};
};

}  // namespace

EnhancedGraphFile parse_enhanced_graph(std::string_view text, const std::string& name,
                                       const ReadGraphOptions& options) {
    const nlohmann::json document = parse_json(text, name);
    FileFaults faults(name);
    EnhancedGraphFile result = GraphReader(faults).read(document);
    faults.throw_if_any();
    if (!options.check) return result;
    try {
        check_graph(result.graph);
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format("{}: {}", name, error.what()));
    }
    return result;
}

EnhancedReebGraph read_enhanced_graph(const std::filesystem::path& file, const ReadGraphOptions& options) {
    return parse_enhanced_graph(file_content(file), file.string(), options).graph;
}

}  // namespace stratareeb
