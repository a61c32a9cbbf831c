// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include "boreholes/errors.h"
#include "io/mesh_part.h"
#include "io/picture_canvas.h"
#include "io/picture_labels.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

using Vec = OpenMesh::Vec3d;

constexpr double kSharpCosine = 0.766;    // faces that meet at more than 40 degrees are shaded apart
constexpr double kDrawnHeight = 0.45;     // of the horizontal size: what the automatic exaggeration aims at
constexpr double kPinAboveGround = 0.02;  // of the horizontal size
constexpr Rgb kPinColor{60, 60, 66};

// The model as drawn: heights exaggerated, layers pulled apart.
struct Scene {
    std::vector<const LayerSolid*> layers;
    Vec low, high;  // box of the model as it is
    double exaggeration = 1, gap = 0;

    Vec place(const Vec& p, std::size_t layer) const {
        return {p[0], p[1], p[2] * exaggeration - gap * static_cast<double>(layer)};
    }
    double horizontal_size() const { return std::max(high[0] - low[0], high[1] - low[1]); }
};

// An eye far away: x right, y up, z towards the eye.
struct Eye {
    Vec right, up, toward;

    explicit Eye(const PictureOptions& options) {
        const double a = options.azimuth_deg * std::numbers::pi / 180,
                     e = options.elevation_deg * std::numbers::pi / 180;
        toward = {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)};
        right = {std::cos(a), std::sin(a), 0};
        up = cross(toward, right);
    }
    Vec see(const Vec& v) const { return {dot(v, right), dot(v, up), dot(v, toward)}; }
};

// From what the eye sees to pixels.
struct Frame {
    double scale = 1, x0 = 0, y0 = 0;

    CanvasPoint point(const Vec& seen, const Vec& normal = {0, 0, 1}) const {
        return {
            x0 + scale * seen[0], y0 - scale * seen[1], scale * seen[2], {normal[0], normal[1], normal[2]}};
    }
};

double automatic_exaggeration(const Scene& scene, double explode) {
    const double gaps = explode * static_cast<double>(scene.layers.size() - 1);
    const double height = (scene.high[2] - scene.low[2]) * (1 + gaps);
    const double wanted = kDrawnHeight * scene.horizontal_size() / height;
    double best = 1;
    for (const double power : {1.0, 10.0, 100.0, 1000.0})
        for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
            if (factor * power <= wanted) best = factor * power;
    return best;
}

Scene make_scene(std::span<const LayerSolid> solids, const PictureOptions& options) {
    Scene scene;
    for (const auto& solid : solids) {
        if (solid.surface.n_faces() == 0) continue;
        scene.layers.push_back(&solid);
        for (const auto v : solid.surface.vertices()) {
            const Vec p = solid.surface.point(v);
            const bool first = scene.layers.size() == 1 && v.idx() == 0;
            scene.low = first ? p : scene.low.min(p);
            scene.high = first ? p : scene.high.max(p);
        }
    }
    if (scene.layers.empty()) throw InvalidInput("no layer has a body: there is nothing to draw");
    scene.exaggeration = options.vertical_exaggeration > 0 ? options.vertical_exaggeration
                                                           : automatic_exaggeration(scene, options.explode);
    scene.gap = options.explode * scene.exaggeration * (scene.high[2] - scene.low[2]);
    return scene;
}

void require_sane(const PictureOptions& options) {
    const auto require = [](bool ok, const std::string& what) {
        if (!ok) throw InvalidInput(what);
    };
    require(options.width >= 100 && options.height >= 100 && options.width <= 8000 && options.height <= 8000,
            fmt::format("picture of {} × {} pixels (expected 100 to 8000 a side)", options.width,
                        options.height));
    require(std::abs(options.elevation_deg) <= 90,
            fmt::format("elevation of the eye {} (expected -90 to 90 degrees)", options.elevation_deg));
    require(std::isfinite(options.azimuth_deg), "azimuth of the eye is not a number");
    require(
        options.explode >= 0 && options.explode <= 10,
        fmt::format("gap between layers {} (expected 0 to 10 times the model's height)", options.explode));
    require(options.vertical_exaggeration >= 0 && options.vertical_exaggeration <= 1e6,
            fmt::format("vertical exaggeration {} (expected 0 = automatic, or up to 1e6)",
                        options.vertical_exaggeration));
}

// Every vertex of every layer as the eye sees it.
std::vector<std::vector<Vec>> seen_points(const Scene& scene, const Eye& eye) {
    std::vector<std::vector<Vec>> result;
    for (std::size_t k = 0; k < scene.layers.size(); ++k) {
        auto& points = result.emplace_back();
        for (const auto v : scene.layers[k]->surface.vertices())
            points.push_back(eye.see(scene.place(scene.layers[k]->surface.point(v), k)));
    }
    return result;
}

Frame fit(const std::vector<std::vector<Vec>>& points, const PictureOptions& options, double legend) {
    Vec low = points[0][0], high = low;
    for (const auto& layer : points)
        for (const auto& p : layer) low = low.min(p), high = high.max(p);
    const double unit = options.height / 1000.0, left = 36 * unit,
                 top = (options.title.empty() ? 36 : 80) * unit;
    const double width = options.width - legend - left, height = options.height - top - 90 * unit;
    Frame frame;
    frame.scale =
        std::min(width / std::max(high[0] - low[0], 1e-300), height / std::max(high[1] - low[1], 1e-300));
    frame.x0 = left + 0.5 * (width - frame.scale * (low[0] + high[0]));
    frame.y0 = top + 0.5 * (height + frame.scale * (low[1] + high[1]));
    return frame;
}

std::vector<Vec> face_normals(const TriMesh& mesh, const std::vector<Vec>& points) {
    std::vector<Vec> normals;  // length = twice the area
    for (const auto f : mesh.faces()) {
        auto v = mesh.cfv_iter(f);
        const Vec a = points[(v++)->idx()], b = points[(v++)->idx()], c = points[v->idx()];
        normals.push_back(cross(b - a, c - a));
    }
    return normals;
}

// Smooth over the faces around the vertex that are not turned away from this one.
Vec corner_normal(const TriMesh& mesh, const std::vector<Vec>& normals, TriMesh::FaceHandle f,
                  TriMesh::VertexHandle v) {
    const Vec own = normals[f.idx()];
    Vec sum(0, 0, 0);
    for (const auto other : mesh.vf_range(v)) {
        const Vec n = normals[other.idx()];
        if (dot(n, own) >= kSharpCosine * n.norm() * own.norm()) sum += n;
    }
    const double length = sum.norm();
    return length > 0 ? Vec(sum / length) : Vec(0, 0, 1);
}

void draw_layer(PictureCanvas& canvas, const TriMesh& mesh, const std::vector<Vec>& points,
                const Frame& frame, int part) {
    const auto normals = face_normals(mesh, points);
    for (const auto f : mesh.faces()) {
        if (normals[f.idx()][2] <= 0) continue;  // turned away from the eye
        std::array<CanvasPoint, 3> corners;
        auto v = mesh.cfv_iter(f);
        for (auto& corner : corners) {
            corner = frame.point(points[v->idx()], corner_normal(mesh, normals, f, *v));
            ++v;
        }
        canvas.draw_triangle(corners, part);
    }
}

Vec pin_head(const Scene& scene, const PictureHole& hole) {
    const Vec collar(hole.collar.x, hole.collar.y, hole.collar.z);
    return scene.place(collar, 0) + Vec(0, 0, kPinAboveGround * scene.horizontal_size());
}

void draw_pins(PictureCanvas& canvas, const Scene& scene, const Eye& eye, const Frame& frame,
               const PictureOptions& options) {
    if (options.holes.empty()) return;
    const int part = canvas.add_part(kPinColor);
    const double width = 2.6 * options.height / 1000.0;
    for (const auto& hole : options.holes) {
        const Vec bottom(hole.collar.x, hole.collar.y, hole.bottom);
        const auto top = frame.point(eye.see(pin_head(scene, hole)));
        const auto base = frame.point(eye.see(scene.place(bottom, scene.layers.size() - 1)));
        canvas.draw_pole(top.x, top.y, base.y, top.depth, base.depth, width, part);
        canvas.draw_ball(top, 1.5 * width, part);
    }
}

}  // namespace

void write_picture(const std::filesystem::path& png, std::span<const LayerSolid> solids,
                   const PictureOptions& options) {
    require_sane(options);
    const Scene scene = make_scene(solids, options);
    const Eye eye(options);

    PictureLabels labels{.title = options.title,
                         .legend = {},
                         .length_unit = options.length_unit,
                         .exaggeration = scene.exaggeration,
                         .north = {eye.right[1], eye.up[1]},
                         .has_holes = !options.holes.empty()};
    for (std::size_t k = 0; k < scene.layers.size(); ++k) {
        const auto* layer = scene.layers[k];
        if (k > 0 && scene.layers[k - 1]->order == layer->order && layer->block > 0)
            continue;  // another block
        labels.legend.push_back({layer->unit.name.empty() ? layer->unit.code : layer->unit.name,
                                 rgb_from_text(layer->unit.color)});
    }

    const auto points = seen_points(scene, eye);
    auto to_fit = points;
    for (const auto& hole : options.holes) to_fit.push_back({eye.see(pin_head(scene, hole))});
    const Frame frame = fit(to_fit, options, legend_width(labels, options.width, options.height));
    labels.pixels_along = frame.scale;
    labels.pixels_up = frame.scale * scene.exaggeration * eye.up[2];

    PictureCanvas canvas(options.width, options.height);
    for (std::size_t k = 0; k < scene.layers.size(); ++k)
        draw_layer(canvas, scene.layers[k]->surface, points[k], frame,
                   canvas.add_part(rgb_from_text(scene.layers[k]->unit.color)));
    draw_pins(canvas, scene, eye, frame, options);

    const std::string bytes =
        labelled_png(canvas.resolve(0.012 * options.width), options.width, options.height, labels);
    write_aside(png, [&](std::ostream& stream) { stream << bytes; });
}

}  // namespace stratareeb
