// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/decimate_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

#include "boreholes/errors.h"
#include "mesh/normals.h"
#include "mesh/self_intersection.h"
#include "mesh/surface_collapse.h"
#include "mesh/surface_distance.h"
#include "mesh/triangle_soup.h"

namespace stratareeb {

namespace {

using Point = TriMesh::Point;
using Vertex = TriMesh::VertexHandle;
using Halfedge = TriMesh::HalfedgeHandle;

constexpr double kStraight = 1e-9;   // of the diagonal: a boundary as close to a straight line as that is one
constexpr double kRounding = 1e-12;  // of the diagonal: what an error of 0 lets pass
constexpr double kDistanceShare = 0.95;  // of the error: for the places looked at, so that those between fit
constexpr double kFlattest = 1e-4;  // sine of an angle: no triangle flatter than that where there was none
constexpr std::size_t kNamedCrossings = 1000;  // looked at in one round
constexpr double kFirstMargin = 0.5;  // of the mean edge: around places to keep; doubled in each round
constexpr std::size_t kReportEvery = 4096;

//! Takes vertices out of a surface, the one of the least quadric error first.
class Queue {
 public:
    explicit Queue(SurfaceCollapse& surface)
        : surface_(surface),
          cost_(surface.mesh().n_vertices()),
          passed_over_(surface.mesh().n_vertices(), 0),
          is_queued_(surface.mesh().n_vertices(), 0),
          is_stale_(surface.mesh().n_vertices(), 0) {}

    //! Down to a number of triangles, or until nothing more can go.
    void run(std::size_t target, const std::function<void(std::size_t)>& done) {
        for (bool any = true; any && surface_.triangles() > target;) {
            any = false;
            for (const Vertex v : surface_.mesh().vertices()) renew(v);
            for (std::size_t step = 0; !queue_.empty() && surface_.triangles() > target; ++step) {
                any |= take_next();
                if (step % kReportEvery == 0) done(surface_.triangles());
            }
        }
    }

 private:
    using Cost = std::tuple<double, double, int>;  // error, length, vertex

    void renew(Vertex v) {
        const auto i = static_cast<std::size_t>(v.idx());
        is_stale_[i] = 0;
        passed_over_[i] = 0;
        put(v);
    }

    //! The best way that was not found to lead too far off or across.
    void put(Vertex v) {
        const auto i = static_cast<std::size_t>(v.idx());
        const auto choices = surface_.choices(v);
        is_queued_[i] = passed_over_[i] < choices.size();
        if (!is_queued_[i]) return;
        const auto& choice = choices[passed_over_[i]];
        cost_[i] = {choice.error, choice.length, v.idx()};
        queue_.push({cost_[i], choice.into});
    }

    bool is_still_possible(Vertex v, Halfedge into) {
        return std::ranges::any_of(surface_.choices(v), [&](const auto& c) { return c.into == into; });
    }

    bool take_next() {
        const auto [cost, into] = queue_.top();
        queue_.pop();
        const Vertex v(std::get<2>(cost));
        const auto i = static_cast<std::size_t>(v.idx());
        if (surface_.mesh().status(v).deleted() || !is_queued_[i] || cost != cost_[i]) return false;
        if (is_stale_[i] || !is_still_possible(v, into)) return renew(v), false;
        if (!surface_.is_sound(into)) return ++passed_over_[i], put(v), false;
        neighbours_.clear();
        for (const Vertex u : surface_.mesh().vv_range(v)) neighbours_.push_back(u);
        surface_.collapse(into);
        for (const Vertex u : neighbours_) {
            is_stale_[static_cast<std::size_t>(u.idx())] = 1;
            if (!is_queued_[static_cast<std::size_t>(u.idx())]) renew(u);
        }
        return true;
    }

    SurfaceCollapse& surface_;
    std::vector<Cost> cost_;
    std::vector<std::size_t> passed_over_;
    std::vector<char> is_queued_, is_stale_;
    std::priority_queue<std::pair<Cost, Halfedge>, std::vector<std::pair<Cost, Halfedge>>, std::greater<>>
        queue_;
    std::vector<Vertex> neighbours_;
};

struct Box {
    Point low, high;

    explicit Box(const Point& p) : low(p), high(p) {}
    void include(const Point& p) { low.minimize(p), high.maximize(p); }
    Box meet(const Box& other) const {
        Box both = *this;
        both.low.maximize(other.low), both.high.minimize(other.high);
        return both;
    }
    bool holds(const Point& p, double margin) const {
        for (int k = 0; k < 3; ++k)
            if (p[k] < low[k] - margin || p[k] > high[k] + margin) return false;
        return true;
    }
};

//! One mesh on its way: decimated around what has to stay, checked, and again.
class MeshDecimation {
 public:
    MeshDecimation(const TriMesh& mesh, const DecimateOptions& options)
        : options_(options), before_(mesh), soup_(triangle_soup(mesh)), kept_(mesh.n_vertices(), 0) {
        Box box(mesh.point(Vertex(0)));
        for (const Vertex v : mesh.vertices()) box.include(mesh.point(v));
        diagonal_ = (box.high - box.low).norm();
        centre_ = (box.low + box.high) / 2;
        for (const auto e : mesh.edges()) edge_ += mesh.calc_edge_length(e);
        edge_ /= static_cast<double>(mesh.n_edges());
    }

    DecimatedMesh run() {
        DecimatedMesh result;
        result.triangles_before = before_.n_faces();
        report("looking for crossings", 0);
        crosses_ = self_intersections(soup_, 0).count > 0;
        for (double margin = kFirstMargin * edge_;; margin *= 2) {
            collapse();
            places_to_keep_.clear();
            if (!crosses_) find_crossings();
            result.deviation = measure();
            if (places_to_keep_.empty()) break;
            result.kept_places += places_to_keep_.size();
            keep_around(margin);
        }
        result.target_reached =
            !options_.triangles || soup_of_result_.triangles.size() <= *options_.triangles;
        result.mesh = half_edge_mesh(soup_of_result_);
        update_vertex_normals(result.mesh);
        result.note = note(result);
        return result;
    }

 private:
    void report(const char* step, double share) const {
        if (options_.progress) options_.progress(step, share);
    }

    double allowed() const { return std::max(*options_.max_error, kRounding * diagonal_); }

    void collapse() {
        // Around the middle of its box, as quadrics far from the origin are lost to rounding.
        TriMesh mesh = before_;
        for (const Vertex v : mesh.vertices()) mesh.set_point(v, mesh.point(v) - centre_);
        const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
        SurfaceCollapse::Limits limits{
            .sample_spacing = edge_,
            .min_cosine = std::cos(radians(options_.max_turn_deg)),
            .min_sine = std::max(std::sin(radians(options_.min_angle_deg)), kFlattest),
            .straight = kStraight * diagonal_,
            .crossings = crosses_};
        if (options_.max_error) limits.distance = kDistanceShare * allowed();
        SurfaceCollapse surface(mesh, soup_, kept_, limits);
        const std::size_t target = options_.triangles.value_or(0), all = mesh.n_faces();
        Queue(surface).run(target, [&](std::size_t left) {
            report("collapsing edges",
                   all > target ? static_cast<double>(all - left) / static_cast<double>(all - target) : 1);
        });
        read(surface.mesh());
    }

    //! What is left, with the input's own coordinates.
    void read(const TriMesh& mesh) {
        soup_of_result_ = {};
        std::vector<std::uint32_t> number(before_.n_vertices());
        for (const Vertex v : mesh.vertices()) {
            number[static_cast<std::size_t>(v.idx())] =
                static_cast<std::uint32_t>(soup_of_result_.points.size());
            soup_of_result_.points.push_back(soup_.points[static_cast<std::size_t>(v.idx())]);
        }
        for (const auto f : mesh.faces()) {
            auto& triangle = soup_of_result_.triangles.emplace_back();
            int k = 0;
            for (const Vertex v : mesh.fv_range(f)) triangle[k++] = number[static_cast<std::size_t>(v.idx())];
        }
    }

    Box box_of(std::uint32_t triangle) const {
        const auto corner = [&](int k) {
            const Point3& p = soup_of_result_.points[soup_of_result_.triangles[triangle][k]];
            return Point(p.x, p.y, p.z);
        };
        Box box(corner(0));
        box.include(corner(1)), box.include(corner(2));
        return box;
    }

    void find_crossings() {
        report("looking for crossings", 0);
        for (const auto& [a, b] : self_intersections(soup_of_result_, kNamedCrossings).first)
            places_to_keep_.push_back(box_of(a).meet(box_of(b)));
    }

    //! The largest distance both ways; places that are too far off have to be kept.
    double measure() {
        report("measuring the distance", 0);
        double largest = 0;
        const auto look = [&](const TriangleSoup& from, const TriangleSoup& to) {
            const auto samples = surface_samples(from, edge_);
            const auto distances = SurfaceDistance(to).of(samples);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                largest = std::max(largest, distances[i]);
                if (options_.max_error && distances[i] > allowed())
                    places_to_keep_.emplace_back(Point(samples[i].x, samples[i].y, samples[i].z));
            }
        };
        look(soup_, soup_of_result_);
        look(soup_of_result_, soup_);
        return largest;
    }

    void keep_around(double margin) {
        const std::size_t kept = static_cast<std::size_t>(std::ranges::count(kept_, 1));
        for (const Vertex v : before_.vertices()) {
            const auto i = static_cast<std::size_t>(v.idx());
            if (kept_[i]) continue;
            kept_[i] = std::ranges::any_of(
                places_to_keep_, [&](const Box& place) { return place.holds(before_.point(v), margin); });
        }
        if (static_cast<std::size_t>(std::ranges::count(kept_, 1)) == kept && kept == kept_.size())
            throw GeometryError("no decimation of this mesh is close enough and free of crossings");
    }

    std::string note(const DecimatedMesh& result) const {
        std::string text =
            fmt::format("decimated from {} to {} triangles; the surfaces are at most {:.3g} apart",
                        result.triangles_before, result.mesh.n_faces(), result.deviation);
        if (!result.target_reached)
            text += fmt::format("; {} can't be reached without {}", *options_.triangles,
                                options_.max_error ? "more error or a change of shape" : "a change of shape");
        if (crosses_) text += "; the input crosses itself, and so may the result";
        return text;
    }

    const DecimateOptions& options_;
    const TriMesh& before_;
    TriangleSoup soup_, soup_of_result_;
    std::vector<char> kept_;
    std::vector<Box> places_to_keep_;
    Point centre_;
    double diagonal_ = 0, edge_ = 0;
    bool crosses_ = false;  // the input itself
};

void check(const DecimateOptions& options) {
    if (!options.triangles && !options.max_error)
        throw InvalidInput("decimation needs a number of triangles or a largest error to stop at");
    if (options.max_error && !(*options.max_error >= 0))
        throw InvalidInput(fmt::format("the largest error {} should be 0 or more", *options.max_error));
    if (!(options.max_turn_deg > 0 && options.max_turn_deg < 90))
        throw InvalidInput(
            fmt::format("the largest turn {} should be between 0 and 90 degrees", options.max_turn_deg));
    if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 30))
        throw InvalidInput(
            fmt::format("the smallest angle {} should be from 0 to 30 degrees", options.min_angle_deg));
}

}  // namespace

DecimatedMesh decimate_mesh(const TriMesh& mesh, const DecimateOptions& options) {
    check(options);
    if (mesh.n_faces() == 0) return {.mesh = mesh, .note = "no triangles to decimate"};
    return MeshDecimation(mesh, options).run();
}

}  // namespace stratareeb
