// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture_labels.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double kLongestLegend = 0.3;  // of the picture's width; longer names are cut

// Sizes below are for a picture 1000 pixels high.
struct Pen {
    Pen(cairo_surface_t* surface, int w, int h)
        : context(cairo_create(surface), &cairo_destroy), width(w), height(h), scale(h / 1000.0) {}

    void font(double size, bool bold = false) const {
        cairo_select_font_face(get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(get(), size * scale);
    }
    double text_width(const std::string& text) const {
        cairo_text_extents_t extents;
        cairo_text_extents(get(), text.c_str(), &extents);
        return extents.x_advance;
    }
    void text(double x, double y, const std::string& text) const {
        cairo_move_to(get(), x, y);
        cairo_show_text(get(), text.c_str());
    }
    void ink(double grey = 0.13) const { cairo_set_source_rgb(get(), grey, grey, grey); }
    cairo_t* get() const { return context.get(); }

    Context context;
    double width, height, scale;
};

std::string cut_to(const Pen& pen, const std::string& text, double width) {
    if (pen.text_width(text) <= width) return text;
    std::string shorter = text;
    while (!shorter.empty() && pen.text_width(shorter + "…") > width) {
        while (!shorter.empty() && (shorter.back() & 0xc0) == 0x80)
            shorter.pop_back();  // the tail of a UTF-8 letter
        if (!shorter.empty()) shorter.pop_back();
    }
    return shorter + "…";
}

constexpr double kMargin = 36, kLegendFont = 23, kLegendStep = 38, kSwatch = 24, kSwatchGap = 12;

void draw_title(const Pen& pen, const std::string& title) {
    pen.font(30, true);
    pen.ink();
    const double margin = kMargin * pen.scale;
    pen.text(margin, margin + 24 * pen.scale, cut_to(pen, title, pen.width - 2 * margin));
}

void draw_legend(const Pen& pen, const PictureLabels& labels) {
    const double s = pen.scale,
                 x = pen.width - legend_width(labels, pen.width, pen.height) + 0.5 * kMargin * s;
    const double room = pen.height - (labels.title.empty() ? 2.0 : 3.2) * kMargin * s;
    const auto rows = static_cast<double>(std::max<std::size_t>(labels.legend.size(), 1));
    const double step = std::min(kLegendStep * s, room / rows), shrink = step / (kLegendStep * s);
    double y = 0.5 * (pen.height - step * rows);
    pen.font(kLegendFont * shrink);
    for (const auto& entry : labels.legend) {
        const double side = kSwatch * s * shrink;
        cairo_rectangle(pen.get(), x, y, side, side);
        cairo_set_source_rgb(pen.get(), entry.color[0] / 255.0, entry.color[1] / 255.0,
                             entry.color[2] / 255.0);
        cairo_fill_preserve(pen.get());
        pen.ink(0.25);
        cairo_set_line_width(pen.get(), 1.2 * s);
        cairo_stroke(pen.get());
        pen.ink();
        const double left = x + side + kSwatchGap * s;
        pen.text(left, y + 0.8 * side, cut_to(pen, entry.name, pen.width - left - 0.4 * kMargin * s));
        y += step;
    }
}

// 1, 2 or 5 times a power of ten, not above `limit`.
double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= limit) return factor * power;
    return power;
}

std::string unit_text(const std::string& unit) {
    return unit == "us-ft" ? "US ft" : unit;
}

void line(const Pen& pen, double x0, double y0, double x1, double y1) {
    cairo_move_to(pen.get(), x0, y0);
    cairo_line_to(pen.get(), x1, y1);
    cairo_stroke(pen.get());
}

void draw_scales(const Pen& pen, const PictureLabels& labels) {
    const double s = pen.scale, x = kMargin * s, y = pen.height - 1.5 * kMargin * s;
    const double along = round_length(0.2 * pen.width / labels.pixels_along),
                 right = x + along * labels.pixels_along;
    pen.ink();
    pen.font(20);
    cairo_set_line_width(pen.get(), 2.5 * s);
    cairo_set_line_cap(pen.get(), CAIRO_LINE_CAP_SQUARE);
    line(pen, x, y, right, y);
    line(pen, right, y - 6 * s, right, y);
    const std::string unit = unit_text(labels.length_unit);
    std::string caption = fmt::format("{:g} {}", along, unit);
    caption += labels.exaggeration == 1 ? ", heights true to scale"
                                        : fmt::format(", heights × {:g}", labels.exaggeration);
    if (labels.has_holes) caption += ", pins are boreholes";
    pen.text(x, y + 28 * s, caption);

    const double up = round_length(0.13 * pen.height / labels.pixels_up), top = y - up * labels.pixels_up;
    if (!(labels.pixels_up > 0) || !(y - top > 8 * s)) return line(pen, x, y - 6 * s, x, y);
    line(pen, x, y, x, top);
    line(pen, x, top, x + 6 * s, top);
    pen.text(x + 14 * s, top + 8 * s, fmt::format("{:g} {}", up, unit));
}

void draw_north(const Pen& pen, const PictureLabels& labels) {
    const double s = pen.scale, length = 46 * s;
    const double x = pen.width - legend_width(labels, pen.width, pen.height) - 30 * s,
                 y = pen.height - 70 * s;
    const double dx = length * labels.north[0], dy = -length * labels.north[1];
    const double size = std::hypot(dx, dy);
    if (size < 6 * s) return;
    const double ux = dx / size, uy = dy / size, head = 0.45 * size;
    pen.ink();
    cairo_set_line_width(pen.get(), 2.5 * s);
    line(pen, x - dx, y - dy, x + dx - ux * head, y + dy - uy * head);
    cairo_move_to(pen.get(), x + dx, y + dy);
    cairo_line_to(pen.get(), x + dx - ux * head - uy * 7 * s, y + dy - uy * head + ux * 7 * s);
    cairo_line_to(pen.get(), x + dx - ux * head + uy * 7 * s, y + dy - uy * head - ux * 7 * s);
    cairo_fill(pen.get());
    pen.font(20, true);
    pen.text(x + dx + ux * 15 * s - 7 * s, y + dy + uy * 15 * s + 7 * s, "N");
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

double legend_width(const PictureLabels& labels, int width, int height) {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1), &cairo_surface_destroy);
    const Pen pen(surface.get(), width, height);
    pen.font(kLegendFont);
    double widest = 0;
    for (const auto& entry : labels.legend) widest = std::max(widest, pen.text_width(entry.name));
    return std::min(widest + (kSwatch + kSwatchGap + 1.2 * kMargin) * pen.scale, kLongestLegend * width);
}

std::string labelled_png(std::vector<std::uint32_t> pixels, int width, int height,
                         const PictureLabels& labels) {
    const Surface surface(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                              CAIRO_FORMAT_RGB24, width, height, 4 * width),
                          &cairo_surface_destroy);
    const Pen pen(surface.get(), width, height);
    draw_title(pen, labels.title);
    draw_legend(pen, labels);
    draw_scales(pen, labels);
    draw_north(pen, labels);
    cairo_surface_flush(surface.get());
    std::string png;
    const auto status = cairo_surface_write_to_png_stream(surface.get(), append, &png);
    if (status != CAIRO_STATUS_SUCCESS)
        throw IoError(fmt::format("the picture can't be encoded: {}", cairo_status_to_string(status)));
    return png;
}

}  // namespace stratareeb
