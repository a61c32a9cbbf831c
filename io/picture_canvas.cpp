// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture_canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stratareeb {
namespace {

constexpr int kSamples = 3;  // a side of a pixel
constexpr double kNormalScale = 32767;
constexpr double kCreaseCosine = 0.766;  // of 40 degrees
constexpr float kOutlineShade = 0.38f;

using Normal = std::array<double, 3>;

double dot(const Normal& a, const Normal& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Normal unit(const Normal& n) {
    const double length = std::sqrt(dot(n, n));
    return length > 0 ? Normal{n[0] / length, n[1] / length, n[2] / length} : Normal{0, 0, 1};
}

const Normal kKeyLight = unit({-0.75, 0.6, 0.45});  // from above the eye's left shoulder
const Normal kFillLight = unit({0.8, 0.35, 0.6});

}  // namespace

PictureCanvas::PictureCanvas(int width, int height)
    : width_(width),
      height_(height),
      columns_(width * kSamples),
      rows_(height * kSamples),
      samples_(static_cast<std::size_t>(columns_) * rows_,
               Sample{-std::numeric_limits<float>::infinity(), {0, 0, 0}, 0}) {}

int PictureCanvas::add_part(const Rgb& color) {
    colors_.push_back(color);
    return static_cast<int>(colors_.size());
}

void PictureCanvas::put(int x, int y, double depth, const Normal& normal, int part) {
    auto& sample = samples_[static_cast<std::size_t>(y) * columns_ + x];
    if (static_cast<float>(depth) <= sample.depth) return;
    sample.depth = static_cast<float>(depth);
    const Normal n = unit(normal);
    for (int k = 0; k < 3; ++k)
        sample.normal[k] = static_cast<std::int16_t>(std::lround(n[k] * kNormalScale));
    sample.part = static_cast<std::uint16_t>(part);
}

void PictureCanvas::draw_triangle(const std::array<CanvasPoint, 3>& corners, int part) {
    std::array<double, 3> x, y;
    for (int k = 0; k < 3; ++k) {
        x[k] = corners[k].x * kSamples - 0.5;
        y[k] = corners[k].y * kSamples - 0.5;
    }
    const double twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (!(twice_area < 0)) return;  // seen from behind or from the side (y points down)
    const auto [x_low, x_high] = std::ranges::minmax(x);
    const auto [y_low, y_high] = std::ranges::minmax(y);
    const int row_end = std::min(rows_ - 1, static_cast<int>(std::floor(std::min(y_high, 1e9))));
    const int column_end = std::min(columns_ - 1, static_cast<int>(std::floor(std::min(x_high, 1e9))));
    for (int row = std::max(0, static_cast<int>(std::ceil(y_low))); row <= row_end; ++row) {
        for (int column = std::max(0, static_cast<int>(std::ceil(x_low))); column <= column_end; ++column) {
            std::array<double, 3> w;
            for (int k = 0; k < 3; ++k) {
                const int a = (k + 1) % 3, b = (k + 2) % 3;
                w[k] = ((x[b] - x[a]) * (row - y[a]) - (column - x[a]) * (y[b] - y[a])) / twice_area;
            }
            if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
            double depth = 0;
            Normal normal{0, 0, 0};
            for (int k = 0; k < 3; ++k) {
                depth += w[k] * corners[k].depth;
                for (int i = 0; i < 3; ++i) normal[i] += w[k] * corners[k].normal[i];
            }
            put(column, row, depth, normal, part);
        }
    }
}

void PictureCanvas::draw_pole(double x, double y_top, double y_base, double depth_top, double depth_base,
                              double width, int part) {
    const double middle = x * kSamples, half = 0.5 * width * kSamples;
    const double top = y_top * kSamples, base = y_base * kSamples;
    if (!(base > top)) return;
    for (int row = std::max(0, static_cast<int>(top)); row < std::min<double>(rows_, base); ++row) {
        const double t = std::clamp((row + 0.5 - top) / (base - top), 0.0, 1.0);
        const double depth = depth_top + t * (depth_base - depth_top);
        for (int column = std::max(0, static_cast<int>(std::lround(middle - half)));
             column < std::min<double>(columns_, std::lround(middle + half)); ++column) {
            const double across = std::clamp((column + 0.5 - middle) / half, -1.0, 1.0);
            put(column, row, depth, {across, 0, std::sqrt(1 - across * across) + 0.2}, part);
        }
    }
}

void PictureCanvas::draw_ball(const CanvasPoint& centre, double radius, int part) {
    const double x = centre.x * kSamples, y = centre.y * kSamples, r = radius * kSamples;
    for (int row = std::max(0, static_cast<int>(y - r)); row < std::min<double>(rows_, y + r); ++row) {
        for (int column = std::max(0, static_cast<int>(x - r)); column < std::min<double>(columns_, x + r);
             ++column) {
            const double across = (column + 0.5 - x) / r, up = (y - row - 0.5) / r,
                         rest = 1 - across * across - up * up;
            if (rest < 0) continue;
            put(column, row, centre.depth + radius * std::sqrt(rest), {across, up, std::sqrt(rest)}, part);
        }
    }
}

bool PictureCanvas::is_outline(int x, int y, double depth_jump) const {
    const Sample& here = at(x, y);
    const auto differs = [&](int dx, int dy) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= columns_ || y + dy >= rows_) return false;
        const Sample& other = at(x + dx, y + dy);
        if (other.part != here.part) return here.depth > other.depth;  // the nearer part draws the line
        double cosine = 0;
        for (int k = 0; k < 3; ++k)
            cosine += double{here.normal[k] / kNormalScale} * other.normal[k] / kNormalScale;
        return cosine < kCreaseCosine || here.depth - other.depth > depth_jump;
    };
    return differs(-1, 0) || differs(1, 0) || differs(0, -1) || differs(0, 1);
}

std::array<float, 3> PictureCanvas::light(const Sample& sample) const {
    const Normal n{sample.normal[0] / kNormalScale, sample.normal[1] / kNormalScale,
                   sample.normal[2] / kNormalScale};
    const double key = std::max(0.0, dot(n, kKeyLight)), fill = std::max(0.0, dot(n, kFillLight));
    const double brightness = 0.27 + 0.72 * key + 0.34 * fill;
    const double gleam = 0.10 * std::pow(key, 24);
    std::array<float, 3> result;
    for (int k = 0; k < 3; ++k) {
        const double c = colors_[sample.part - 1][k] / 255.0;
        result[k] = static_cast<float>(std::min(1.0, c * brightness + gleam));
    }
    return result;
}

std::vector<std::uint32_t> PictureCanvas::resolve(double depth_jump) const {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width_) * height_);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            std::array<float, 3> sum{0, 0, 0};
            for (int s = 0; s < kSamples * kSamples; ++s) {
                const int column = x * kSamples + s % kSamples, row = y * kSamples + s / kSamples;
                const Sample& sample = at(column, row);
                const auto color = sample.part == 0 ? std::array<float, 3>{1, 1, 1} : light(sample);
                const float shade =
                    sample.part != 0 && is_outline(column, row, depth_jump) ? kOutlineShade : 1.0f;
                for (int k = 0; k < 3; ++k) sum[k] += shade * color[k];
            }
            std::uint32_t pixel = 0xff;
            for (const float channel : sum)
                pixel = pixel << 8 |
                        static_cast<std::uint32_t>(std::lround(255 * channel / (kSamples * kSamples)));
            pixels[static_cast<std::size_t>(y) * width_ + x] = pixel;
        }
    }
    return pixels;
}

}  // namespace stratareeb
