// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_graph_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boreholes/errors.h"
#include "io/arc_colors.h"
#include "io/axis_ticks.h"
#include "io/drawing_page.h"
#include "io/graph_columns.h"
#include "io/side_view.h"
#include "io/write_aside.h"
#include "io/write_graph.h"
#include "reeb/arc_curves.h"

namespace stratareeb {

namespace {

// The page, in points.
constexpr double kMargin = 28, kAxisRoom = 66, kGap = 46, kTop = 84, kBottom = 52, kPlotHeight = 640;
constexpr double kViewWidth = 640, kLeastViewWidth = 220, kColumn = 26, kLeastGraphWidth = 300,
                 kMostGraphWidth = 1500;
constexpr double kCrowd = 200;       // nodes that fit; more get a larger page, up to twice as high
constexpr double kTilt = 0.3;        // sine of the angle from which the eye looks down
constexpr double kMostDepth = 0.22;  // of the plot's height that the tilt may take
constexpr double kLeastStep = 0.25;  // of a line, in points: shorter ones can't be seen
constexpr Rgb kInk{40, 40, 44}, kGrid{222, 222, 226}, kFrame{150, 150, 156}, kNoArc{150, 150, 150};

const char* many(CriticalType type) {
    return type == CriticalType::Minimum ? "minima" : type == CriticalType::Saddle ? "saddles" : "maxima";
}

class GraphDrawing {
 public:
    GraphDrawing(const DrawnGraph& drawn, const GraphDrawingOptions& options)
        : drawn_(drawn),
          graph_(drawn.graph),
          options_(options),
          view_(side_view(drawn.mesh, options.direction)),
          columns_(graph_columns(graph_, preferred_x())),
          colors_(arc_colors(graph_)) {
        set_range();
        set_scales();
    }

    std::string bytes(const std::filesystem::path& file) {
        DrawingPage page(file, graph_left_ + graph_width_ + kMargin, kTop + plot_height_ + kBottom);
        draw_axis(page);
        draw_contours(page);
        draw_nodes_in_view(page);
        draw_graph(page);
        draw_words(page);
        return page.finish();
    }

 private:
    //! Where the middle contour of each arc stands in the view.
    std::vector<double> preferred_x() const {
        std::vector<double> result;
        for (const auto& curve :
             coarse_arc_curves(drawn_.mesh, drawn_.fine, drawn_.index, graph_, drawn_.members, 1))
            result.push_back(view_.across(curve[curve.size() / 2]));
        return result;
    }

    void set_range() {
        low_ = high_ = graph_.nodes.front().value;
        for (const ReebNode& node : graph_.nodes) {
            low_ = std::min(low_, node.value);
            high_ = std::max(high_, node.value);
        }
    }

    //! True to scale where that leaves a picture, heights exaggerated by a stated factor where it does not.
    void set_scales() {
        const double range = high_ > low_ ? high_ - low_ : 1;
        const double wide = std::max(view_.right_max - view_.right_min, 1e-300);
        const double deep = std::max(view_.toward_max - view_.toward_min, 0.0);
        const double length = options_.direction ? std::hypot(options_.direction->x, options_.direction->y,
                                                              options_.direction->z)
                                                 : 1;
        // Of a unit of height as drawn, and of one to the right; the tilt takes its part of the height.
        const double nodes = static_cast<double>(graph_.nodes.size());
        const double zoom = std::clamp(std::sqrt(nodes / kCrowd), 1.0, 2.0);
        const double room = zoom * kPlotHeight;
        double along = zoom * kViewWidth / wide;
        const auto depth_room = [&] { return std::min(kTilt * along * deep, kMostDepth * room); };
        double up = (room - depth_room()) / range;
        if (options_.direction && up * length < along) {
            along = up * length;  // a tower: as narrow as it is; again, as its depth shrinks too
            up = (room - depth_room()) / range;
            along = std::min(along, up * length);
        }
        exaggeration_ = round_exaggeration(std::max(1.0, up * length / along));
        if (options_.direction) up = std::min(up, exaggeration_ * along / length);
        up_ = up;
        along_ = along;
        tilt_ = deep > 0 ? depth_room() / (along * deep) : 0;
        view_width_ = std::max(kLeastViewWidth, along * wide);
        view_left_ = kMargin + kAxisRoom + 0.5 * (view_width_ - along * wide);
        plot_height_ = up * range + depth_room();
        base_ = kTop + 0.5 * (plot_height_ + up * range);
        graph_left_ = kMargin + kAxisRoom + view_width_ + kGap;
        graph_width_ = std::clamp(kColumn * (columns_.width + 1), kLeastGraphWidth, kMostGraphWidth);
        column_ = std::min(graph_width_ / (columns_.width + 1), 3 * kColumn);
    }

    double y(double value) const { return base_ - up_ * (value - low_); }
    double x_in_view(const Point3& p) const {
        return view_left_ + along_ * (view_.across(p) - view_.right_min);
    }
    double y_in_view(const Point3& p, double value) const {
        return y(value) + tilt_ * along_ * (view_.depth(p) - (view_.toward_min + view_.toward_max) / 2);
    }
    double x_in_graph(double column) const {
        return graph_left_ + graph_width_ / 2 + column_ * (column - columns_.width / 2);
    }

    void draw_axis(DrawingPage& page) const {
        const auto values = ticks(low_, high_);
        const double step = values.size() > 1 ? values[1] - values[0] : 1;
        page.line_width(0.6);
        for (const double value : values) {
            page.ink(kGrid);
            page.move_to(kMargin + kAxisRoom - 6, y(value));
            page.line_to(graph_left_ + graph_width_, y(value));
            page.stroke();
            page.ink(kInk);
            page.text(kMargin + kAxisRoom - 12, y(value) + 4, tick_text(value, step), 12, TextAlign::Right);
        }
        page.ink(kFrame);
        page.line_width(0.9);
        page.move_to(kMargin + kAxisRoom - 6, y(low_));
        page.line_to(kMargin + kAxisRoom - 6, y(high_));
        page.stroke();
        page.ink(kInk);
        page.text(kMargin, kTop - 18, options_.value_label, 13);
    }

    Rgb color_at(std::uint32_t fine_arc, double level) const {
        for (const std::uint32_t a : drawn_.members.coarse_of[fine_arc])
            if (graph_.nodes[graph_.arcs[a].lower].value <= level &&
                level <= graph_.nodes[graph_.arcs[a].upper].value)
                return colors_[a];
        const auto& arcs = drawn_.members.coarse_of[fine_arc];  // of a pruned branch: the arc at its root
        return arcs.empty() ? kNoArc : colors_[arcs.front()];
    }

    void trace(DrawingPage& page, const Contour& contour, double level) const {
        double last_x = 0, last_y = 0;
        for (std::size_t i = 0; i < contour.points.size(); ++i) {
            const double x = x_in_view(contour.points[i]), at = y_in_view(contour.points[i], level);
            const bool is_end = i == 0 || i + 1 == contour.points.size();
            if (!is_end && std::hypot(x - last_x, at - last_y) < kLeastStep) continue;
            i == 0 ? page.move_to(x, at) : page.line_to(x, at);
            last_x = x;
            last_y = at;
        }
        if (contour.closed) page.close();
    }

    //! From bottom to top, each level veiling those below, which it hides from an eye above.
    void draw_contours(DrawingPage& page) const {
        page.line_width(0.8);
        for (const double level : even_levels(drawn_.field, options_.levels)) {
            std::vector<std::pair<std::uint32_t, Contour>> contours;
            for (const std::uint32_t arc : drawn_.index.arcs_at(level))
                contours.emplace_back(arc, drawn_.index.contour(arc, level));
            std::erase_if(contours, [](const auto& entry) { return entry.second.points.size() < 2; });
            for (const auto& [arc, contour] : contours)
                if (contour.closed) trace(page, contour, level);
            page.ink({255, 255, 255}, 0.55);
            page.fill();
            for (const auto& [arc, contour] : contours) {
                trace(page, contour, level);
                page.ink(color_at(arc, level));
                page.stroke();
            }
        }
    }

    void draw_mark(DrawingPage& page, double x, double at, double size, CriticalType type) const {
        if (type == CriticalType::Saddle) {
            page.move_to(x - size, at);
            page.line_to(x, at - size);
            page.line_to(x + size, at);
            page.line_to(x, at + size);
        } else {
            const double tip = type == CriticalType::Minimum ? 1 : -1;  // y is down: a minimum points there
            page.move_to(x, at + tip * size);
            page.line_to(x - 0.95 * size, at - tip * 0.7 * size);
            page.line_to(x + 0.95 * size, at - tip * 0.7 * size);
        }
        page.close();
        page.ink(node_color(type));
        page.fill_and_keep();
        page.ink(kInk);
        page.line_width(std::min(0.8, 0.15 * size));
        page.stroke();
    }

    void draw_nodes_in_view(DrawingPage& page) const {
        if (graph_.nodes.size() > 80) return;
        for (const ReebNode& node : graph_.nodes) {
            const Point3 p = node_place(drawn_.mesh, node);
            draw_mark(page, x_in_view(p), y_in_view(p, node.value), 3.2, node.type);
        }
    }

    //! From a node sidewards into the arc's column, straight up, and sidewards to the other node.
    void draw_arc(DrawingPage& page, std::uint32_t a) const {
        const ReebArc& arc = graph_.arcs[a];
        const double x = x_in_graph(columns_.arc_x[a]);
        const double x_low = x_in_graph(columns_.node_x[arc.lower]),
                     x_high = x_in_graph(columns_.node_x[arc.upper]);
        const double y_low = y(graph_.nodes[arc.lower].value), y_high = y(graph_.nodes[arc.upper].value);
        const auto bend = [&](double from) {
            return std::min((y_low - y_high) / 2, 6 + 0.6 * std::abs(x - from));
        };
        page.move_to(x_low, y_low);
        page.curve_to(x_low + 0.75 * (x - x_low), y_low, x, y_low - 0.35 * bend(x_low), x,
                      y_low - bend(x_low));
        page.line_to(x, y_high + bend(x_high));
        page.curve_to(x, y_high + 0.35 * bend(x_high), x_high + 0.75 * (x - x_high), y_high, x_high, y_high);
        page.ink(colors_[a]);
        page.stroke();
    }

    void draw_graph(DrawingPage& page) const {
        for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
            page.line_width(std::clamp(0.12 * column_, 0.6, 2.2));
            draw_arc(page, a);
        }
        const double nodes = static_cast<double>(graph_.nodes.size());
        const double size = std::clamp(std::min(0.28 * column_, 40 / std::sqrt(nodes)), 1.4, 5.5);
        for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
            draw_mark(page, x_in_graph(columns_.node_x[n]), y(graph_.nodes[n].value), size,
                      graph_.nodes[n].type);
    }

    void draw_words(DrawingPage& page) const {
        const double bottom = kTop + plot_height_;
        page.ink(kInk);
        page.text(kMargin, 32, options_.title, 17, TextAlign::Left, true);
        std::string caption = fmt::format("contours at {} levels, coloured by arc", options_.levels);
        if (options_.direction)
            caption +=
                exaggeration_ == 1 ? "; true to scale" : fmt::format("; heights × {:g}", exaggeration_);
        page.text(kMargin + kAxisRoom, bottom + 32, caption, 12);
        std::array<std::size_t, 3> counts{};
        for (const ReebNode& node : graph_.nodes) ++counts[static_cast<std::size_t>(node.type)];
        double x = graph_left_;
        for (const auto type : {CriticalType::Minimum, CriticalType::Saddle, CriticalType::Maximum}) {
            draw_mark(page, x + 6, bottom + 28, 5.5, type);
            page.ink(kInk);
            const std::size_t count = counts[static_cast<std::size_t>(type)];
            page.text(x + 18, bottom + 32,
                      fmt::format("{} {}", count, count == 1 ? type_name(type) : many(type)), 12);
            x += 104;
        }
    }

    const DrawnGraph& drawn_;
    const ReebGraph& graph_;
    const GraphDrawingOptions& options_;
    SideView view_;
    GraphColumns columns_;
    std::vector<Rgb> colors_;
    double low_ = 0, high_ = 0;                                // values
    double up_ = 1, along_ = 1, tilt_ = 0, exaggeration_ = 1;  // points a unit of value, of length
    double view_left_ = 0, view_width_ = 0, plot_height_ = 0, graph_left_ = 0, graph_width_ = 0, column_ = 1,
           base_ = 0;
};

}  // namespace

void write_graph_drawing(const std::filesystem::path& file, const DrawnGraph& drawn,
                         const GraphDrawingOptions& options) {
    if (!is_drawing_file(file)) throw IoError(file.string() + ": drawings are written as .svg, .pdf or .png");
    if (drawn.graph.nodes.empty())
        throw InvalidInput("the Reeb graph has no nodes: there is nothing to draw");
    if (drawn.graph.nodes.size() > options.most_nodes)
        throw InvalidInput(fmt::format(
            "{}: a drawing of {} nodes can't be read (at most {}); simplify the graph, as by --simplify 0.05",
            file.string(), drawn.graph.nodes.size(), options.most_nodes));
    const std::string bytes = GraphDrawing(drawn, options).bytes(file);
    write_aside(file, [&](std::ostream& stream) { stream << bytes; });
}

}  // namespace stratareeb
