// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_section.h"

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
constexpr double kMargin = 24, kAxisRoom = 64, kPlotWidth = 900, kMostHeight = 420, kHoleNames = 46;
constexpr double kLegendRow = 18, kLegendWidth = 190, kTop = 58, kBottom = 64;
constexpr double kHoleWidth = 9;
constexpr Rgb kInk{40, 40, 44}, kGrid{226, 226, 230}, kFrame{110, 110, 116}, kWhite{255, 255, 255};

class SectionDrawing {
 public:
    SectionDrawing(const VerticalSection& section, const std::vector<Unit>& units,
                   const SectionDrawingOptions& options)
        : section_(section), units_(units), options_(options), polygons_(section_polygons(section)) {
        set_range();
        set_scales();
        for (const SectionPolygon& polygon : polygons_) shown_.insert(polygon.layer);
        for (const SectionHole& hole : options_.holes)
            for (const LogInterval& interval : hole.log) shown_.insert(interval.layer);
    }

    std::string bytes(const std::filesystem::path& file) {
        const double legend = kTop + kLegendRow * static_cast<double>(shown_.size() + 1);
        const double height = std::max(top_ + plot_height_ + kBottom, legend);
        DrawingPage page(file, left_ + kPlotWidth + kMargin + kLegendWidth, height);
        draw_grid(page);
        draw_layers(page);
        draw_corners(page);
        draw_holes(page);
        draw_frame(page);
        draw_legend(page);
        draw_words(page);
        return page.finish();
    }

 private:
    void set_range() {
        low_ = HUGE_VAL;
        high_ = -HUGE_VAL;
        const auto cover = [&](double z) {
            low_ = std::min(low_, z);
            high_ = std::max(high_, z);
        };
        for (const auto& run : section_.runs)
            for (const SectionStation& station : run) {
                cover(station.horizons.front());
                cover(station.horizons.back());
            }
        for (const SectionHole& hole : options_.holes) {
            cover(hole.top);
            if (!hole.log.empty()) cover(hole.log.back().base);
        }
        const double pad = high_ > low_ ? 0.04 * (high_ - low_) : 1;
        low_ -= pad;
        high_ += pad;
    }

    void set_scales() {
        along_ = kPlotWidth / section_.length();
        const double most = kMostHeight / ((high_ - low_) * along_);
        exaggeration_ =
            options_.exaggeration > 0 ? options_.exaggeration : round_exaggeration(std::max(1.0, most));
        up_ = exaggeration_ * along_;
        if (options_.exaggeration == 0 && up_ * (high_ - low_) > kMostHeight && exaggeration_ == 1) {
            along_ = up_ = kMostHeight / (high_ - low_);  // higher than long: true to scale and narrow
        }
        plot_height_ = up_ * (high_ - low_);
    }

    double x(double along) const { return left_ + along_ * along; }
    double y(double z) const { return top_ + up_ * (high_ - z); }
    double right() const { return x(section_.length()); }

    void line(DrawingPage& page, double x0, double y0, double x1, double y1) const {
        page.move_to(x0, y0);
        page.line_to(x1, y1);
        page.stroke();
    }

    void draw_grid(DrawingPage& page) const {
        const auto heights = ticks(low_, high_, std::clamp(plot_height_ / 40, 2.0, 9.0));
        const double step = heights.size() > 1 ? heights[1] - heights[0] : 1;
        page.line_width(0.6);
        for (const double z : heights) {
            page.ink(kGrid);
            line(page, left_ - 5, y(z), right(), y(z));
            page.ink(kInk);
            page.text(left_ - 9, y(z) + 4, tick_text(z, step), 11, TextAlign::Right);
        }
        const double about = std::clamp((right() - left_) / 90, 1.0, 12.0);
        const auto distances = ticks(0, section_.length(), about);
        const double stride = distances.size() > 1 ? distances[1] - distances[0] : 1;
        for (const double s : distances) {
            page.ink(kFrame);
            line(page, x(s), y(low_), x(s), y(low_) + 5);
            page.ink(kInk);
            page.text(x(s), y(low_) + 18, tick_text(s, stride), 11, TextAlign::Middle);
        }
    }

    void draw_layers(DrawingPage& page) const {
        page.line_width(0.7);
        for (const SectionPolygon& polygon : polygons_) {
            for (std::size_t i = 0; i < polygon.outline.size(); ++i) {
                const Point2& p = polygon.outline[i];
                i == 0 ? page.move_to(x(p.x), y(p.y)) : page.line_to(x(p.x), y(p.y));
            }
            page.close();
            page.ink(rgb_from_text(units_[polygon.layer].color));
            page.fill_and_keep();
            page.ink(kInk, 0.75);
            page.stroke();
        }
    }

    //! Where the line turns, a dashed upright.
    void draw_corners(DrawingPage& page) const {
        page.ink(kInk, 0.55);
        page.line_width(0.8);
        for (std::size_t i = 1; i + 1 < section_.corners.size(); ++i)
            for (double at = top_; at < y(low_); at += 8)
                line(page, x(section_.corners[i]), at, x(section_.corners[i]), std::min(at + 4, y(low_)));
    }

    void draw_holes(DrawingPage& page) const {
        double last_name = -HUGE_VAL;
        for (const SectionHole& hole : options_.holes) {
            const double at = x(hole.along), width = kHoleWidth;
            for (const LogInterval& interval : hole.log) {
                page.box(at - width / 2, y(interval.top), width, y(interval.base) - y(interval.top));
                page.ink(rgb_from_text(units_[interval.layer].color));
                page.fill_and_keep();
                page.ink(kInk);
                page.line_width(1);
                page.stroke();
            }
            page.ink(kInk);
            page.line_width(1.4);
            line(page, at, y(hole.top), at, y(hole.top) - 7);
            if (at - last_name < kHoleNames) continue;  // names would run into each other
            page.text(at, top_ - 8, hole.id, 10, TextAlign::Middle);
            last_name = at;
        }
    }

    void draw_frame(DrawingPage& page) const {
        page.ink(kFrame);
        page.line_width(0.9);
        page.box(left_, top_, right() - left_, plot_height_);
        page.stroke();
    }

    void draw_legend(DrawingPage& page) const {
        double at = top_ + 4;
        for (const std::size_t layer : shown_) {
            page.swatch(right() + kMargin, at, rgb_from_text(units_[layer].color), 1, kInk,
                        units_[layer].name);
            at += kLegendRow;
        }
    }

    void draw_words(DrawingPage& page) const {
        const std::string& u = options_.length_unit;
        page.ink(kInk);
        page.text(kMargin, 22, options_.title, 14, TextAlign::Left, true);
        page.text(kMargin, top_ - 8, fmt::format("z [{}]", u), 11);
        const auto end = [&](const Point2& p) { return fmt::format("{:.8g}, {:.8g}", p.x, p.y); };
        page.text(left_, y(low_) + 36, end(section_.line.front()), 10);
        page.text(right(), y(low_) + 36, end(section_.line.back()), 10, TextAlign::Right);
        page.text((left_ + right()) / 2, y(low_) + 36, fmt::format("distance along the line [{}]", u), 11,
                  TextAlign::Middle);
        const std::string scale = exaggeration_ == 1
                                      ? std::string("heights true to scale")
                                      : fmt::format("heights exaggerated {:g} times", exaggeration_);
        page.text((left_ + right()) / 2, y(low_) + 53, scale, 11, TextAlign::Middle);
    }

    const VerticalSection& section_;
    const std::vector<Unit>& units_;
    const SectionDrawingOptions& options_;
    std::vector<SectionPolygon> polygons_;
    std::set<std::size_t> shown_;
    double low_ = 0, high_ = 0, along_ = 1, up_ = 1, exaggeration_ = 1, plot_height_ = 0;
    double left_ = kMargin + kAxisRoom, top_ = kTop;
};

}  // namespace

void write_section_drawing(const std::filesystem::path& file, const VerticalSection& section,
                           const std::vector<Unit>& units, const SectionDrawingOptions& options) {
    if (options.exaggeration < 0 || !std::isfinite(options.exaggeration))
        throw InvalidInput(
            fmt::format("a vertical exaggeration of {}: give a factor above 0", options.exaggeration));
    const std::string bytes = SectionDrawing(section, units, options).bytes(file);
    write_aside(file, [&](std::ostream& out) {
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

}  // namespace stratareeb
