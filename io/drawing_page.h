// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/mesh_part.h"

namespace stratareeb {

enum class TextAlign { Left, Middle, Right };

//! A page of lines, areas and text, as SVG, PDF or PNG: x right and y down, in points (PNG: 1.5 pixels each). Text is kept as
//! shapes, so that the page looks the same everywhere.
class DrawingPage {
 public:
    //! \throw IoError unless the file's extension is .svg, .pdf or .png
    DrawingPage(const std::filesystem::path& file, double width, double height);
    ~DrawingPage();
    DrawingPage(const DrawingPage&) = delete;
    DrawingPage& operator=(const DrawingPage&) = delete;

    void ink(const Rgb& color, double opacity = 1);
    void line_width(double width);

    // A path, then what to do with it.
    void move_to(double x, double y);
    void line_to(double x, double y);
    void curve_to(double x1, double y1, double x2, double y2, double x, double y);
    void close();
    void circle(double x, double y, double radius);
    void box(double x, double y, double width, double height);
    void stroke();
    void fill();           // even-odd
    void fill_and_keep();  // the path, for a stroke
    void clip_to(double x, double y, double width, double height);
    void end_clip();

    void text(double x, double y, const std::string& text, double size, TextAlign align = TextAlign::Left,
              bool bold = false);
    //! A legend's entry: a small box of a colour, outlined in ink, and its name beside it.
    void swatch(double x, double y, const Rgb& color, double opacity, const Rgb& outline,
                const std::string& name);
    //! The file's bytes; the page takes no more.
    //! \throw IoError if the drawing library refuses
    std::string finish();

 private:
    struct Cairo;
    std::unique_ptr<Cairo> cairo_;
};

//! Does the extension stand for a drawing: .svg, .pdf, .png?
bool is_drawing_file(const std::filesystem::path& file);

}  // namespace stratareeb
