// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/adaptive_refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boreholes/errors.h"
#include "subdivision/face_tree.h"
#include "subdivision/limit_surface.h"

namespace stratareeb {
namespace {

// Each level's distances are a quarter of those before, so all that follow a level add up to a third of its own.
constexpr double kTail = 1.0 / 3;

Point3 middle(const Point3& a, const Point3& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}
Point3 difference(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// A refined mesh, its limit, and how far the surface is from faces that lack a vertex of it.
struct Refinement {
    SubdivisionScheme scheme;
    FaceTree tree;
    std::vector<VertexKind> kinds;
    LimitSurface limit;
    std::vector<double> errors;  // 0 for control vertices

    // How far the surface is from the edge a - b, in whose middle it has vertex m.
    double distance(std::uint32_t a, std::uint32_t b, std::uint32_t m) const {
        const auto& p = limit.points;
        const Point3 off = difference(p[m], middle(p[a], p[b]));
        if (kinds[m] == VertexKind::Inside) {
            const Point3 half = middle(p[a], p[b]);
            return height(m, half) + std::max(rise(m, a, half), rise(m, b, half));
        }
        const Point3 along = difference(p[b], p[a]);
        const double squared = dot(along, along);
        const double t = squared > 0 ? dot(off, along) / squared : 0;
        const Point3 across{off.x - t * along.x, off.y - t * along.y, off.z - t * along.z};
        return std::sqrt(dot(across, across));
    }

    double height(std::uint32_t m, const Point3& below) const {
        return std::abs(dot(difference(limit.points[m], below), limit.normals[m]));
    }

    // What the surface may rise between its vertex m and the place where it is nearest to a point beside m, as it turns towards v.
    double rise(std::uint32_t m, std::uint32_t v, const Point3& beside) const {
        if (kinds[v] != VertexKind::Inside) return 0;
        const Point3 off = difference(limit.points[m], beside),
                     turn = difference(limit.normals[v], limit.normals[m]);
        const double up = dot(off, limit.normals[m]);
        return std::sqrt(std::max(0.0, dot(off, off) - up * up) * dot(turn, turn)) / 2;
    }

    // How far a polygon's own flat shape is from the surface at its centre. A quad may be cut along either diagonal.
    double hollow(const TreeFace& face) const {
        const auto at = [&](std::size_t i) { return limit.points[face.corners[i]]; };
        const std::size_t n = face.corners.size();
        if (n == 4)
            return std::max(height(face.centre, middle(at(0), at(2))),
                            height(face.centre, middle(at(1), at(3))));
        Point3 mean;
        for (std::size_t i = 0; i < n; ++i) {
            const Point3 p = at(i);
            const double share = 1 / static_cast<double>(n);
            mean = {mean.x + p.x * share, mean.y + p.y * share, mean.z + p.z * share};
        }
        return height(face.centre, mean);
    }

    double largest_error_of_children(int level, std::size_t face, const TreeFace& opened,
                                     TreeFace& child) const {
        double largest = 0;
        for (std::size_t i = 0; i < tree.child_count(level, face); ++i) {
            tree.open(level + 1, opened.first_child + i, child);
            for (const auto m : child.middles) largest = std::max(largest, errors[m]);
        }
        return largest;
    }

    // The error of a middle is how far the surface is from its edge, and what its faces' children add to that: so a face has all
    // its middles wherever a child of it has one.
    // \pre the next level is done
    void sum_errors(int level) {
        TreeFace face, child;
        std::vector<double> own;
        for (std::size_t f = 0; f < tree.face_count(level); ++f) {
            tree.open(level, f, face);
            const std::size_t n = face.corners.size();
            const double centre = scheme == SubdivisionScheme::CatmullClark ? hollow(face) : 0;
            own.clear();
            for (std::size_t i = 0; i < n; ++i)
                own.push_back(
                    std::max(centre, distance(face.corners[i], face.corners[(i + 1) % n], face.middles[i])));
            const double deeper = level + 1 < tree.levels() ? largest_error_of_children(level, f, face, child)
                                                            : kTail * *std::ranges::max_element(own);
            for (std::size_t i = 0; i < n; ++i)
                errors[face.middles[i]] = std::max(errors[face.middles[i]], own[i] + deeper);
        }
    }
};

Refinement refinement(const PolygonMesh& control, const SharpFeatures& features,
                      const RefineOptions& options) {
    const ControlTopology topology = refined_topology(control, features, options, LimitsWanted::Yes);
    const PolygonMesh refined = refined_mesh(topology, control);
    return {options.scheme, FaceTree(topology, control, options.scheme), topology.kinds(),
            shaded_limit(topology, refined), std::vector<double>(refined.points.size(), 0.0)};
}

// Writes the faces of the result, from the trees' roots down to where nothing is cut.
class FaceWriter {
 public:
    FaceWriter(const Refinement& refinement, double tolerance, PolygonMesh& mesh)
        : refinement_(refinement), tolerance_(tolerance), mesh_(mesh) {}

    void write(int level, std::size_t face) {
        const FaceTree& tree = refinement_.tree;
        deepest_ = std::max(deepest_, level);
        if (level == tree.levels()) return append(tree.corners(level, face));
        TreeFace opened;
        tree.open(level, face, opened);
        const auto cut = std::ranges::count_if(opened.middles, [&](auto m) { return is_used(m); });
        if (cut == 0) return append(opened.corners);
        if (static_cast<std::size_t>(cut) == opened.middles.size()) {
            for (std::size_t i = 0; i < tree.child_count(level, face); ++i)
                write(level + 1, opened.first_child + i);
        } else if (refinement_.scheme == SubdivisionScheme::CatmullClark) {
            append_fan(opened);
        } else if (cut == 1) {
            append_halves(opened);
        } else {
            append_thirds(opened);
        }
    }

    int deepest() const { return deepest_; }

 private:
    bool is_used(std::uint32_t v) const { return refinement_.errors[v] > tolerance_; }

    void append(std::span<const std::uint32_t> corners) {
        mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
        mesh_.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    void append(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::uint32_t corners[] = {a, b, c};
        append(corners);
    }

    void append_fan(const TreeFace& face) {
        const std::size_t n = face.corners.size();
        for (std::size_t i = 0; i < n; ++i) {
            const auto a = face.corners[i], m = face.middles[i], b = face.corners[(i + 1) % n];
            if (is_used(m)) {
                append(a, m, face.centre);
                append(m, b, face.centre);
            } else {
                append(a, b, face.centre);
            }
        }
    }

    void append_halves(const TreeFace& face) {
        std::size_t i = 0;
        while (!is_used(face.middles[i])) ++i;
        const auto a = face.corners[i], b = face.corners[(i + 1) % 3], c = face.corners[(i + 2) % 3];
        append(a, face.middles[i], c);
        append(face.middles[i], b, c);
    }

    // The corner between the two cut sides, and a quadrangle that is cut at its shorter diagonal.
    void append_thirds(const TreeFace& face) {
        std::size_t whole = 0;
        while (is_used(face.middles[whole])) ++whole;
        const auto a = face.corners[whole], b = face.corners[(whole + 1) % 3],
                   c = face.corners[(whole + 2) % 3];
        const auto bc = face.middles[(whole + 1) % 3], ca = face.middles[(whole + 2) % 3];
        append(ca, bc, c);
        if (length(a, bc) <= length(b, ca)) {
            append(a, b, bc);
            append(a, bc, ca);
        } else {
            append(b, bc, ca);
            append(b, ca, a);
        }
    }

    double length(std::uint32_t a, std::uint32_t b) const {
        const Point3 d = difference(refinement_.limit.points[a], refinement_.limit.points[b]);
        return dot(d, d);
    }

    const Refinement& refinement_;
    double tolerance_;
    PolygonMesh& mesh_;
    int deepest_ = 0;
};

// Number the vertices that are left anew, in their old order; control vertices all stay.
void compact(RefinedMesh& refined, const LimitSurface& limit, std::size_t control_vertices) {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(limit.points.size(), kNone);
    std::fill_n(number.begin(), control_vertices, 0u);
    for (const auto v : refined.mesh.corners) number[v] = 0;
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == kNone) continue;
        number[v] = next++;
        refined.mesh.points.push_back(limit.points[v]);
        refined.normals.push_back(limit.normals[v]);
    }
    for (auto& v : refined.mesh.corners) v = number[v];
}

}  // namespace

AdaptiveMesh adaptive_refine(const PolygonMesh& control, double tolerance, const RefineOptions& options) {
    if (!(tolerance > 0))
        throw InvalidInput(fmt::format("a tolerance of {}; it is a length above 0", tolerance));
    if (options.levels < 1) throw InvalidInput(fmt::format("{} levels; give 1 or more", options.levels));
    const SharpFeatures features = sharp_features(control, options);
    // Two levels at least, where there may be: the middle of an edge that winds like an S is on the edge.
    RefineOptions deeper = options;
    deeper.levels = std::min(2, options.levels);
    Refinement refined = refinement(control, features, deeper);
    for (;; ++deeper.levels, refined = refinement(control, features, deeper)) {
        refined.sum_errors(deeper.levels - 1);
        if (deeper.levels == options.levels || std::ranges::max(refined.errors) <= tolerance) break;
    }
    for (int level = deeper.levels - 2; level >= 0; --level) refined.sum_errors(level);

    AdaptiveMesh result{{{}, {}, features.creases.size(), features.corners.size()}, 0};
    FaceWriter writer(refined, tolerance, result.refined.mesh);
    for (std::size_t f = 0; f < control.face_count(); ++f) writer.write(0, f);
    result.levels = writer.deepest();
    compact(result.refined, refined.limit, control.points.size());
    return result;
}

}  // namespace stratareeb
