// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_plan_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "boreholes/errors.h"
#include "io/axis_ticks.h"
#include "io/drawing_page.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

// The page, in points.
constexpr double kMargin = 24, kAxisRoom = 62, kLongSide = 620, kLegendWidth = 190, kLegendRow = 18;
constexpr double kTop = 58, kBottom = 78, kLabelSize = 8.5;
constexpr double kRing = 2.4, kLeastRing = 1.2;  // radii of a borehole's mark: at most; below it a dot
constexpr Rgb kInk{40, 40, 44}, kGrid{226, 226, 230}, kFrame{110, 110, 116}, kWhite{255, 255, 255};

class MapDrawing {
 public:
    explicit MapDrawing(const PlanMap& map) : map_(map) {
        for (const auto& ring : map.outline)
            for (const Point2& p : ring) {
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
            }
        const double pad = 0.03 * std::max(high_.x - low_.x, high_.y - low_.y);
        low_ = {low_.x - pad, low_.y - pad};
        high_ = {high_.x + pad, high_.y + pad};
        scale_ = kLongSide / std::max(high_.x - low_.x, high_.y - low_.y);
        width_ = scale_ * (high_.x - low_.x);
        height_ = scale_ * (high_.y - low_.y);
        for (const MapArea& area : map.areas) shown_.insert(area.entry);
    }

    std::string bytes(const std::filesystem::path& file) {
        const double legend = kTop + kLegendRow * static_cast<double>(shown_.size() + 1) + kBottom;
        DrawingPage page(file, left_ + std::max(width_, 260.0) + kMargin + kLegendWidth,
                         std::max(kTop + height_ + kBottom, legend));
        draw_grid(page);
        page.clip_to(left_, kTop, width_, height_);
        for (const MapArea& area : map_.areas) draw_area(page, area);
        for (const MapLine& line : map_.lines) draw_line(page, line);
        draw_outline(page);
        page.end_clip();
        draw_points(page);
        draw_frame(page);
        draw_legend(page);
        draw_scale_bar(page);
        page.ink(kInk);
        page.text(kMargin, 22, map_.title, 14, TextAlign::Left, true);
        page.text(kMargin, 40, map_.note, 11);
        return page.finish();
    }

 private:
    double x(const Point2& p) const { return left_ + scale_ * (p.x - low_.x); }
    double y(const Point2& p) const { return kTop + scale_ * (high_.y - p.y); }

    static void line(DrawingPage& page, double x0, double y0, double x1, double y1) {
        page.move_to(x0, y0);
        page.line_to(x1, y1);
        page.stroke();
    }

    void trace(DrawingPage& page, const std::vector<Point2>& points, bool close) const {
        for (std::size_t i = 0; i < points.size(); ++i)
            i == 0 ? page.move_to(x(points[i]), y(points[i])) : page.line_to(x(points[i]), y(points[i]));
        if (close) page.close();
    }

    void draw_grid(DrawingPage& page) const {
        page.line_width(0.6);
        const auto across = ticks(low_.x, high_.x, std::max(2.0, width_ / 130));
        const auto up = ticks(low_.y, high_.y, std::max(2.0, height_ / 90));
        for (const double value : across) {
            const double at = x({value, low_.y});
            page.ink(kGrid);
            line(page, at, kTop, at, kTop + height_ + 5);
            page.ink(kInk);
            page.text(at, kTop + height_ + 18, coordinate(value), 10.5, TextAlign::Middle);
        }
        for (const double value : up) {
            const double at = y({low_.x, value});
            page.ink(kGrid);
            line(page, left_ - 5, at, left_ + width_, at);
            page.ink(kInk);
            page.text(left_ - 9, at + 4, coordinate(value), 10.5, TextAlign::Right);
        }
    }

    static std::string coordinate(double value) { return fmt::format("{:.10g}", value); }

    void draw_area(DrawingPage& page, const MapArea& area) const {
        for (const auto& ring : area.rings) trace(page, ring, true);
        page.ink(map_.legend[area.entry].color, map_.lines.empty() ? 1 : 0.4);  // lines stand out
        page.fill_and_keep();
        page.ink(kInk, 0.6);
        page.line_width(0.6);
        page.stroke();
    }

    void draw_line(DrawingPage& page, const MapLine& contour) const {
        page.ink(kInk, contour.bold ? 0.95 : 0.7);
        page.line_width(contour.bold ? 1.1 : 0.6);
        trace(page, contour.points, contour.closed);
        page.stroke();
        if (!contour.label.empty()) label(page, contour);
    }

    //! At the middle of a line, on white, where the line is longer than its label.
    void label(DrawingPage& page, const MapLine& contour) const {
        const auto& p = contour.points;
        double length = 0;
        for (std::size_t i = 0; i + 1 < p.size(); ++i) length += step(p[i], p[i + 1]);
        const double room = kLabelSize * 0.62 * static_cast<double>(contour.label.size());
        if (length < 3 * room) return;
        double rest = length / 2;
        std::size_t i = 0;
        while (i + 2 < p.size() && step(p[i], p[i + 1]) < rest) {
            rest -= step(p[i], p[i + 1]);
            ++i;
        }
        const double at_x = (x(p[i]) + x(p[i + 1])) / 2, at_y = (y(p[i]) + y(p[i + 1])) / 2;
        page.box(at_x - room / 2 - 1, at_y - kLabelSize / 2 - 0.5, room + 2, kLabelSize + 1);
        page.ink(kWhite, 0.85);
        page.fill();
        page.ink(kInk);
        page.text(at_x, at_y + kLabelSize * 0.36, contour.label, kLabelSize, TextAlign::Middle);
    }

    double step(const Point2& a, const Point2& b) const { return scale_ * std::hypot(b.x - a.x, b.y - a.y); }

    void draw_outline(DrawingPage& page) const {
        page.ink(kInk);
        page.line_width(1.1);
        for (const auto& ring : map_.outline) trace(page, ring, true);
        page.stroke();
    }

    //! Radius of a borehole's mark: smaller where there are many, so that the map stays legible.
    double point_size() const {
        const double each =
            width_ * height_ / static_cast<double>(std::max<std::size_t>(map_.points.size(), 1));
        return std::clamp(0.15 * std::sqrt(each), 0.3, kRing);
    }

    void draw_points(DrawingPage& page) const {
        constexpr std::size_t kMostLabels = 60;
        const double size = point_size();
        if (size < kLeastRing) {
            page.ink(kInk);
            for (const MapPoint& point : map_.points) {
                page.box(x(point.at) - size, y(point.at) - size, 2 * size, 2 * size);
                page.fill();
            }
            return;
        }
        for (const MapPoint& point : map_.points) {
            page.circle(x(point.at), y(point.at), size);
            page.ink(kWhite);
            page.fill_and_keep();
            page.ink(kInk);
            page.line_width(1);
            page.stroke();
            if (map_.points.size() <= kMostLabels)
                page.text(x(point.at) + 4, y(point.at) - 3, point.label, 8);
        }
    }

    void draw_frame(DrawingPage& page) const {
        page.ink(kFrame);
        page.line_width(0.9);
        page.box(left_, kTop, width_, height_);
        page.stroke();
    }

    void draw_legend(DrawingPage& page) const {
        const double at_x = left_ + std::max(width_, 260.0) + kMargin;
        double at = kTop + 4;
        for (const std::size_t entry : shown_) {
            const PlanMap::Entry& shown = map_.legend[entry];
            page.swatch(at_x, at, shown.color, map_.lines.empty() ? 1 : 0.4, kInk, shown.name);
            at += kLegendRow;
        }
        if (map_.points.empty()) return;
        page.circle(at_x + 10, at + 6, point_size());
        page.stroke();
        page.text(at_x + 28, at + 10, "borehole", 11);
    }

    void draw_scale_bar(DrawingPage& page) const {
        const double length = round_step(0.15 * (high_.x - low_.x));
        const double at = kTop + height_ + 46;
        page.ink(kInk);
        page.line_width(1.4);
        line(page, left_, at, left_ + scale_ * length, at);
        for (const double end : {left_, left_ + scale_ * length}) line(page, end, at - 4, end, at + 4);
        page.text(left_ + scale_ * length + 8, at + 4,
                  fmt::format("{:g} {}, north is up", length, map_.length_unit), 11);
    }

    const PlanMap& map_;
    std::set<std::size_t> shown_;
    Point2 low_{HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL};
    double scale_ = 1, width_ = 0, height_ = 0, left_ = kMargin + kAxisRoom;
};

}  // namespace

void write_plan_map(const std::filesystem::path& file, const PlanMap& map) {
    if (map.outline.empty()) throw InvalidInput("a map needs the outline of what it covers");
    const std::string bytes = MapDrawing(map).bytes(file);
    write_aside(file, [&](std::ostream& out) {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

}  // namespace stratareeb
