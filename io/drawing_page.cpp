// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/drawing_page.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "boreholes/errors.h"

namespace stratareeb {

namespace {

constexpr double kPixels = 1.5;     // of a PNG a point
constexpr double kLeastStep = 0.2;  // points: what a line's corners may be left out within

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* surface_for(const std::filesystem::path& file, std::string& bytes, double width,
                             double height) {
    if (file.extension() == ".svg") return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    if (file.extension() == ".png")
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPixels * width),
                                          static_cast<int>(kPixels * height));
    if (file.extension() != ".pdf")
        throw IoError(file.string() + ": drawings are written as .svg, .pdf or .png");
    cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
    // The time of writing would make each run's file another one.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
    return surface;
}

}  // namespace

struct DrawingPage::Cairo {
    bool is_png = false;
    std::string bytes;
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface{nullptr,
                                                                               &cairo_surface_destroy};
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context{nullptr, &cairo_destroy};
    cairo_t* get() const { return context.get(); }

    double x = 0, y = 0;            // the last corner drawn
    double last_x = 0, last_y = 0;  // the last corner given
    void start(double to_x, double to_y) {
        finish_line();
        cairo_move_to(get(), to_x, to_y);
        x = last_x = to_x, y = last_y = to_y;
    }
    //! Corners closer together than an eye can see are left out, but a line's last.
    void go(double to_x, double to_y) {
        last_x = to_x, last_y = to_y;
        if (std::hypot(to_x - x, to_y - y) >= kLeastStep) finish_line();
    }
    void finish_line() {
        if (last_x == x && last_y == y) return;
        cairo_line_to(get(), last_x, last_y);
        x = last_x, y = last_y;
    }
};

DrawingPage::DrawingPage(const std::filesystem::path& file, double width, double height)
    : cairo_(std::make_unique<Cairo>()) {
    cairo_->is_png = file.extension() == ".png";
    cairo_->surface.reset(surface_for(file, cairo_->bytes, width, height));
    cairo_->context.reset(cairo_create(cairo_->surface.get()));
    if (cairo_->is_png) cairo_scale(cairo_->get(), kPixels, kPixels);
    cairo_set_line_join(cairo_->get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_->get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_fill_rule(cairo_->get(), CAIRO_FILL_RULE_EVEN_ODD);
    ink({255, 255, 255});
    cairo_paint(cairo_->get());
}

DrawingPage::~DrawingPage() = default;

void DrawingPage::ink(const Rgb& color, double opacity) {
    cairo_set_source_rgba(cairo_->get(), color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, opacity);
}
void DrawingPage::line_width(double width) {
    cairo_set_line_width(cairo_->get(), width);
}
void DrawingPage::move_to(double x, double y) {
    cairo_->start(x, y);
}
void DrawingPage::line_to(double x, double y) {
    cairo_->go(x, y);
}
void DrawingPage::curve_to(double x1, double y1, double x2, double y2, double x, double y) {
    cairo_->finish_line();
    cairo_curve_to(cairo_->get(), x1, y1, x2, y2, x, y);
    cairo_->x = cairo_->last_x = x, cairo_->y = cairo_->last_y = y;
}
void DrawingPage::close() {
    cairo_->finish_line();
    cairo_close_path(cairo_->get());
}
void DrawingPage::circle(double x, double y, double radius) {
    cairo_->finish_line();
    cairo_new_sub_path(cairo_->get());
    cairo_arc(cairo_->get(), x, y, radius, 0, 2 * std::numbers::pi);
    close();
}
void DrawingPage::box(double x, double y, double width, double height) {
    move_to(x, y);
    line_to(x + width, y);
    line_to(x + width, y + height);
    line_to(x, y + height);
    close();
}
void DrawingPage::stroke() {
    cairo_->finish_line();
    cairo_stroke(cairo_->get());
}
void DrawingPage::fill() {
    cairo_->finish_line();
    cairo_fill(cairo_->get());
}
void DrawingPage::fill_and_keep() {
    cairo_->finish_line();
    cairo_fill_preserve(cairo_->get());
}
void DrawingPage::clip_to(double x, double y, double width, double height) {
    cairo_save(cairo_->get());
    cairo_rectangle(cairo_->get(), x, y, width, height);
    cairo_clip(cairo_->get());
}
void DrawingPage::end_clip() {
    cairo_restore(cairo_->get());
}

void DrawingPage::text(double x, double y, const std::string& text, double size, TextAlign align, bool bold) {
    cairo_select_font_face(cairo_->get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_->get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_->get(), text.c_str(), &extents);
    const double share = align == TextAlign::Left ? 0 : align == TextAlign::Middle ? 0.5 : 1;
    cairo_move_to(cairo_->get(), x - share * extents.x_advance, y);
    cairo_show_text(cairo_->get(), text.c_str());
}

void DrawingPage::swatch(double x, double y, const Rgb& color, double opacity, const Rgb& outline,
                         const std::string& name) {
    box(x, y, 20, 12);
    ink(color, opacity);
    fill_and_keep();
    ink(outline);
    line_width(0.7);
    stroke();
    text(x + 28, y + 10, name, 11);
}

std::string DrawingPage::finish() {
    cairo_surface_flush(cairo_->surface.get());
    if (cairo_->is_png) cairo_surface_write_to_png_stream(cairo_->surface.get(), append, &cairo_->bytes);
    cairo_surface_finish(cairo_->surface.get());
    for (const auto status : {cairo_status(cairo_->get()), cairo_surface_status(cairo_->surface.get())})
        if (status != CAIRO_STATUS_SUCCESS)
            throw IoError(fmt::format("the drawing can't be made: {}", cairo_status_to_string(status)));
    return std::move(cairo_->bytes);
}

bool is_drawing_file(const std::filesystem::path& file) {
    return file.extension() == ".svg" || file.extension() == ".pdf" || file.extension() == ".png";
}

}  // namespace stratareeb
