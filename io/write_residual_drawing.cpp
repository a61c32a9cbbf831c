// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_residual_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "io/axis_ticks.h"
#include "io/drawing_page.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

// The page, in points.
constexpr double kMargin = 26, kTop = 64, kPanel = 230, kGap = 40, kHead = 30, kFoot = 26;
constexpr double kMostRadius = 11, kLeastRadius = 3;
constexpr std::size_t kMostPanels = 24, kColumns = 3;
constexpr Rgb kInk{40, 40, 44}, kGrid{224, 224, 228}, kFrame{150, 150, 156}, kHole{190, 190, 196};
constexpr Rgb kTooMuch{33, 102, 172}, kTooLittle{178, 24, 43}, kNext{20, 20, 20};

//! A square of the page for one layer.
struct Panel {
    double x, y;  // of its upper left corner
    double right() const { return x + kPanel; }
    double bottom() const { return y + kPanel; }
};

//! Values from `low` to `high` over the side of a panel.
struct Scale {
    double low = 0, high = 1;
    double share(double value) const { return (value - low) / (high - low); }
};

Scale widened(double low, double high, double by) {
    const double width = std::max(high - low, 1e-9 * std::max({std::abs(low), std::abs(high), 1.0}));
    return {low - by * width, high + by * width};
}

//! Layers, or for contact points horizons; those of the largest errors in their own order, if there are too many.
std::vector<const ItemValidation*> drawn_items(const Validation& result) {
    std::vector<const ItemValidation*> items;
    for (const ItemValidation& item : result.layers.empty() ? result.horizons : result.layers)
        if (item.errors.count > 0) items.push_back(&item);
    if (items.size() <= kMostPanels) return items;
    auto by_error = items;
    std::ranges::stable_sort(by_error, std::greater<>(),
                             [](const ItemValidation* item) { return item->errors.rmse; });
    by_error.resize(kMostPanels);
    std::erase_if(items, [&](const ItemValidation* item) {
        return std::ranges::find(by_error, item) == by_error.end();
    });
    return items;
}

class ResidualDrawing {
 public:
    ResidualDrawing(const std::filesystem::path& file, const Survey& survey,
                    const NamedValidation& validation, const std::string& title)
        : survey_(survey),
          result_(validation.result),
          items_(drawn_items(validation.result)),
          page_(file, width(), height()) {
        page_.ink(kInk);
        page_.text(kMargin, 26, fmt::format("{}, {}", title, validation.name), 15, TextAlign::Left, true);
    }

    std::string map() {
        set_map_scale();
        for (std::size_t i = 0; i < items_.size(); ++i) draw_map(panel(i), *items_[i]);
        page_.ink(kInk);
        page_.text(kMargin, 44,
                   "area of a circle: size of the error; blue: predicted too thick or high, red: too thin or "
                   "low; hollow: outside the "
                   "hull of the other holes; +: further holes that would help most",
                   7.5);
        return page_.finish();
    }

    std::string scatter() {
        for (std::size_t i = 0; i < items_.size(); ++i) draw_scatter(panel(i), *items_[i]);
        page_.ink(kInk);
        page_.text(
            kMargin, 44,
            fmt::format("predicted (up) against actual (right), in {}, with intervals", survey_.length_unit),
            8);
        return page_.finish();
    }

 private:
    double width() const {
        const auto columns = static_cast<double>(std::clamp<std::size_t>(items_.size(), 2, kColumns));
        return 2 * kMargin + columns * kPanel + (columns - 1) * kGap;
    }
    double height() const {
        const auto rows =
            static_cast<double>((std::max<std::size_t>(items_.size(), 1) + kColumns - 1) / kColumns);
        return kTop + rows * (kHead + kPanel + kFoot);
    }

    Panel panel(std::size_t i) const {
        return {kMargin + static_cast<double>(i % kColumns) * (kPanel + kGap),
                kTop + kHead + static_cast<double>(i / kColumns) * (kHead + kPanel + kFoot)};
    }

    void frame(const Panel& at, const ItemValidation& item) {
        page_.ink(kFrame);
        page_.line_width(0.8);
        page_.move_to(at.x, at.y);
        page_.line_to(at.right(), at.y);
        page_.line_to(at.right(), at.bottom());
        page_.line_to(at.x, at.bottom());
        page_.close();
        page_.stroke();
        page_.ink(kInk);
        page_.text(at.x, at.y - 16, item.name, 10, TextAlign::Left, true);
        page_.text(at.x, at.y - 5,
                   fmt::format("{} values, RMSE {:.3g}, mean {:+.2g}, {:.0f} % in their intervals",
                               item.errors.count, item.errors.rmse, item.errors.mean, 100 * item.coverage()),
                   7.5);
    }

    void set_map_scale() {
        Point2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()},
            high{-low.x, -low.y};
        for (const Borehole& hole : survey_.holes) {
            low = {std::min(low.x, hole.at.x), std::min(low.y, hole.at.y)};
            high = {std::max(high.x, hole.at.x), std::max(high.y, hole.at.y)};
        }
        const double side = 1.08 * std::max({high.x - low.x, high.y - low.y, 1e-9});
        x_ = {(low.x + high.x - side) / 2, (low.x + high.x + side) / 2};
        y_ = {(low.y + high.y - side) / 2, (low.y + high.y + side) / 2};
    }

    Point2 on_map(const Panel& at, const Point2& p) const {
        return {at.x + kPanel * x_.share(p.x), at.bottom() - kPanel * y_.share(p.y)};
    }

    void draw_map(const Panel& at, const ItemValidation& item) {
        page_.ink(kHole);
        for (const Borehole& hole : survey_.holes) {
            const Point2 p = on_map(at, hole.at);
            page_.circle(p.x, p.y, 0.9);
            page_.fill();
        }
        for (const Residual& residual : item.residuals) draw_error(at, item, residual);
        for (std::size_t i = 0; i < result_.next.size(); ++i) draw_next(at, result_.next[i], i + 1);
        frame(at, item);
        draw_circle_key(at, item);
    }

    //! The largest error of a panel; less where holes are crowded.
    double most_radius() const {
        const double gap =
            kPanel / std::sqrt(static_cast<double>(std::max<std::size_t>(survey_.holes.size(), 1)));
        return std::clamp(gap, kLeastRadius, kMostRadius);
    }

    double radius(const ItemValidation& item, double error) const {
        return item.errors.largest > 0 ? most_radius() * std::sqrt(std::abs(error) / item.errors.largest) : 0;
    }

    void draw_error(const Panel& at, const ItemValidation& item, const Residual& residual) {
        const double size = radius(item, residual.error());
        if (size < 0.3) return;
        const Point2 p = on_map(at, survey_.holes[residual.hole].at);
        const Rgb& color = residual.error() > 0 ? kTooMuch : kTooLittle;
        page_.circle(p.x, p.y, size);
        if (residual.inside) {
            page_.ink(color, 0.45);
            page_.fill_and_keep();
        }
        page_.ink(color);
        page_.line_width(0.6);
        page_.stroke();
    }

    void draw_next(const Panel& at, const NextBorehole& next, std::size_t rank) {
        const Point2 p = on_map(at, next.at);
        page_.ink(kNext);
        page_.line_width(1.1);
        page_.move_to(p.x - 4, p.y);
        page_.line_to(p.x + 4, p.y);
        page_.move_to(p.x, p.y - 4);
        page_.line_to(p.x, p.y + 4);
        page_.stroke();
        page_.text(p.x + 4, p.y - 2.5, fmt::format("{}", rank), 7);
    }

    void draw_circle_key(const Panel& at, const ItemValidation& item) {
        const double shown = item.errors.largest > 0 ? round_step(item.errors.largest / 4) : 0;
        if (shown <= 0) return;
        const double size = radius(item, shown);
        page_.ink(kInk);
        page_.line_width(0.6);
        page_.circle(at.x + kMostRadius, at.bottom() + 12, size);
        page_.stroke();
        page_.text(at.x + 2 * kMostRadius + 4, at.bottom() + 15,
                   fmt::format("{:g} {}", shown, survey_.length_unit), 7.5);
    }

    void draw_scatter(const Panel& at, const ItemValidation& item) {
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const Residual& residual : item.residuals) {
            low = std::min({low, residual.actual, residual.predicted});
            high = std::max({high, residual.actual, residual.predicted});
        }
        const Scale scale = widened(low, high, 0.05);
        draw_grid(at, scale);
        page_.clip_to(at.x, at.y, kPanel, kPanel);
        for (std::size_t i = 0; i < item.residuals.size(); ++i)
            draw_value(at, scale, item.residuals[i], item.half_width[i]);
        page_.end_clip();
        frame(at, item);
    }

    void draw_grid(const Panel& at, const Scale& scale) {
        const auto values = ticks(scale.low, scale.high, 5);
        const double step = values.size() > 1 ? values[1] - values[0] : 1;
        for (const double value : values) {
            const double along = kPanel * scale.share(value);
            page_.ink(kGrid);
            page_.line_width(0.6);
            page_.move_to(at.x + along, at.y);
            page_.line_to(at.x + along, at.bottom());
            page_.move_to(at.x, at.bottom() - along);
            page_.line_to(at.right(), at.bottom() - along);
            page_.stroke();
            page_.ink(kInk);
            page_.text(at.x + along, at.bottom() + 10, tick_text(value, step), 7, TextAlign::Middle);
            page_.text(at.x - 3, at.bottom() - along + 2.5, tick_text(value, step), 7, TextAlign::Right);
        }
        page_.ink(kFrame);
        page_.line_width(0.9);
        page_.move_to(at.x, at.bottom());
        page_.line_to(at.right(), at.y);
        page_.stroke();
    }

    void draw_value(const Panel& at, const Scale& scale, const Residual& residual, double half_width) {
        const double x = at.x + kPanel * scale.share(residual.actual);
        const auto up = [&](double value) { return at.bottom() - kPanel * scale.share(value); };
        const bool covered = std::abs(residual.error()) <= half_width;
        page_.ink(covered ? kFrame : kTooLittle, 0.55);
        page_.line_width(0.7);
        page_.move_to(x, up(residual.predicted - half_width));
        page_.line_to(x, up(residual.predicted + half_width));
        page_.stroke();
        page_.ink(covered ? kTooMuch : kTooLittle, 0.9);
        page_.circle(x, up(residual.predicted), 1.7);
        page_.fill();
    }

    const Survey& survey_;
    const Validation& result_;
    std::vector<const ItemValidation*> items_;
    DrawingPage page_;
    Scale x_, y_;
};

}  // namespace

void write_residual_map(const std::filesystem::path& file, const Survey& survey,
                        const NamedValidation& validation) {
    const std::string bytes = ResidualDrawing(file, survey, validation, "Errors of held-out boreholes").map();
    write_aside(file, [&](std::ostream& stream) { stream << bytes; });
}

void write_residual_scatter(const std::filesystem::path& file, const Survey& survey,
                            const NamedValidation& validation) {
    const std::string bytes =
        ResidualDrawing(file, survey, validation, "Held-out boreholes: predicted and actual").scatter();
    write_aside(file, [&](std::ostream& stream) { stream << bytes; });
}

}  // namespace stratareeb
