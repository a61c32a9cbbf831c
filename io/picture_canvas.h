// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/mesh_part.h"

namespace stratareeb {

//! A point on the canvas: x right and y down in pixels, depth grows towards the eye, in the units of x and y.
struct CanvasPoint {
    double x = 0, y = 0, depth = 0;
    std::array<double, 3> normal{0, 0, 1};  // in the eye's frame: x right, y up, z towards the eye
};

//! A small software renderer: triangles into a depth buffer with several samples a pixel, then light,
//! outlines and averaging. Parallel projection, so that all is linear in x and y.
class PictureCanvas {
 public:
    PictureCanvas(int width, int height);

    //! Every part has a colour; `part` below is its number, in the order of these calls.
    int add_part(const Rgb& color);

    void draw_triangle(const std::array<CanvasPoint, 3>& corners, int part);

    //! An upright line of so many pixels' width, lit like a pole.
    void draw_pole(double x, double y_top, double y_base, double depth_top, double depth_base, double width,
                   int part);

    //! A ball of so many pixels' radius.
    void draw_ball(const CanvasPoint& centre, double radius, int part);

    //! The finished picture, a row after the other from the top, 0xffRRGGBB; white where nothing was drawn.
    //! Outlines stand where the part changes, the surface turns by more than 40 degrees or the depth jumps by
    //! more than `depth_jump` pixels.
    std::vector<std::uint32_t> resolve(double depth_jump) const;

 private:
    struct Sample {
        float depth;
        std::array<std::int16_t, 3> normal;
        std::uint16_t part;  // 0 = nothing drawn
    };
    void put(int x, int y, double depth, const std::array<double, 3>& normal, int part);
    bool is_outline(int x, int y, double depth_jump) const;
    std::array<float, 3> light(const Sample& sample) const;
    const Sample& at(int x, int y) const { return samples_[static_cast<std::size_t>(y) * columns_ + x]; }

    int width_, height_, columns_, rows_;  // pixels, samples
    std::vector<Rgb> colors_;
    std::vector<Sample> samples_;
};

}  // namespace stratareeb
