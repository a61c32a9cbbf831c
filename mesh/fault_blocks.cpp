// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fault_blocks.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "boreholes/errors.h"
#include "mesh/clip_lines.h"
#include "mesh/tie_blocks.h"

namespace stratareeb {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::int32_t kUnseen = -2, kOutside = -1;

using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>>;
using DataStructure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure, CGAL::Exact_predicates_tag>;
using CgalPoint = Kernel::Point_2;

constexpr double kOnTrace = 1e-6;  // of the extent: a hole as close to a trace as that stands on it
constexpr double kSnapped = 1e-9;  // of the extent: trace points as close to the outline as that are on it

double extent_of(const Footprint& footprint) {
    double x0 = footprint[0][0].x, x1 = x0, y0 = footprint[0][0].y, y1 = y0;
    for (const auto& ring : footprint)
        for (const Point2& p : ring)
            x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    return std::hypot(x1 - x0, y1 - y0);
}

double distance_to(const Point2& p, const Point2& a, const Point2& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double t =
        squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy));
}

class BlockPartition {
 public:
    BlockPartition(const Footprint& footprint, const FaultTraces& traces, const std::vector<Point2>& holes)
        : holes_(holes), extent_(extent_of(footprint)) {
        JoinedTraces joined = joined_traces(footprint, traces, holes);
        traces_ = std::move(joined.traces);
        result_.notes = std::move(joined.notes);
        result_.ways_on = std::move(joined.ways_on);
        PlanLines lines;
        for (const auto& trace : traces_)
            for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
                const auto first = static_cast<std::uint32_t>(lines.points.size());
                lines.points.push_back(trace[i]);
                lines.points.push_back(trace[i + 1]);
                lines.segments.push_back({first, first + 1});
            }
        lines_ = clipped_lines(lines, footprint, kSnapped * extent_);
        footprint_ = with_points_on_rings(footprint, lines_.points, kSnapped * extent_);
    }

    FaultBlocks run() {
        check_holes();
        triangulate();
        flood();
        assign_holes();
        join_empty_regions();
        number_blocks();
        tie_blocks(result_, mean_gap());
        return std::move(result_);
    }

 private:
    //! Between neighbouring holes.
    double mean_gap() const {
        return std::sqrt(area(footprint_) / static_cast<double>(std::max<std::size_t>(1, holes_.size())));
    }

    void check_holes() const {
        for (std::size_t h = 0; h < holes_.size(); ++h)
            for (const auto& [a, b] : lines_.segments)
                if (distance_to(holes_[h], lines_.points[a], lines_.points[b]) <= kOnTrace * extent_)
                    throw InvalidInput(
                        fmt::format("borehole {} at x {:.10g}, y {:.10g} stands on a fault trace (move the "
                                    "trace to one side of it)",
                                    h + 1, holes_[h].x, holes_[h].y));
    }

    void triangulate() {
        const auto constrain = [&](const Point2& a, const Point2& b) {
            if (!(a == b)) cdt_.insert_constraint(CgalPoint(a.x, a.y), CgalPoint(b.x, b.y));
        };
        for (const auto& ring : footprint_)
            for (std::size_t i = 0; i < ring.size(); ++i) constrain(ring[i], ring[(i + 1) % ring.size()]);
        for (const auto& [a, b] : lines_.segments) constrain(lines_.points[a], lines_.points[b]);
    }

    //! Regions between constrained edges, numbered from 0; kOutside beyond the footprint.
    void flood() {
        const InsideTest is_inside(footprint_);
        for (const auto face : cdt_.all_face_handles())
            face->info() = cdt_.is_infinite(face) ? kOutside : kUnseen;
        for (const auto seed : cdt_.finite_face_handles()) {
            if (seed->info() != kUnseen) continue;
            std::vector<Cdt::Face_handle> region{seed};
            const auto name = static_cast<std::int32_t>(regions_);
            seed->info() = name;
            for (std::size_t next = 0; next < region.size(); ++next)
                for (int i = 0; i < 3; ++i) {
                    const auto other = region[next]->neighbor(i);
                    if (region[next]->is_constrained(i) || other->info() != kUnseen) continue;
                    other->info() = name;
                    region.push_back(other);
                }
            const auto largest =
                *std::ranges::max_element(region, {}, [&](auto f) { return cdt_.triangle(f).area(); });
            const CgalPoint centre = CGAL::centroid(cdt_.triangle(largest));
            double size = 0;  // corners on the outline may leave slivers between them and the hull of all
            for (const auto face : region) size += cdt_.triangle(face).area();
            if (size > kSnapped * extent_ * extent_ && is_inside({centre.x(), centre.y()})) {
                ++regions_;
                centre_.push_back({centre.x(), centre.y()});
            } else {
                for (const auto face : region) face->info() = kOutside;
            }
        }
        joined_.resize(regions_);
        std::iota(joined_.begin(), joined_.end(), 0u);
    }

    //! The region at a place, kOutside beyond all.
    std::int32_t region_at(const Point2& p) const {
        Cdt::Locate_type type;
        int index = 0;
        const auto face = cdt_.locate(CgalPoint(p.x, p.y), type, index);
        if (type == Cdt::VERTEX) {
            auto around = cdt_.incident_faces(face->vertex(index)), first = around;
            do {
                if (around->info() >= 0) return around->info();
            } while (++around != first);
            return kOutside;
        }
        if (type == Cdt::EDGE) return std::max(face->info(), face->neighbor(index)->info());
        return type == Cdt::FACE ? face->info() : kOutside;
    }

    std::int32_t closest_region(const Point2& p) const {
        double best = std::numeric_limits<double>::infinity();
        std::int32_t region = kOutside;
        for (const auto face : cdt_.finite_face_handles()) {
            if (face->info() < 0) continue;
            const CgalPoint corner[3] = {face->vertex(0)->point(), face->vertex(1)->point(),
                                         face->vertex(2)->point()};
            for (int i = 0; i < 3; ++i) {
                const CgalPoint &a = corner[i], &b = corner[(i + 1) % 3];
                const double d = distance_to(p, {a.x(), a.y()}, {b.x(), b.y()});
                if (d < best || (d == best && face->info() < region)) best = d, region = face->info();
            }
        }
        return region;
    }

    void assign_holes() {
        holes_in_.assign(regions_, 0);
        for (const Point2& hole : holes_) {
            std::int32_t region = region_at(hole);
            if (region < 0) region = closest_region(hole);
            region_of_.push_back(static_cast<std::uint32_t>(region));
            ++holes_in_[region_of_.back()];
        }
    }

    std::uint32_t root(std::uint32_t region) const {
        while (joined_[region] != region) region = joined_[region];
        return region;
    }

    //! Lengths of borders between regions, by pair.
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> borders() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> length;
        for (const auto& edge : cdt_.finite_edges()) {
            const std::int32_t a = edge.first->info(), b = edge.first->neighbor(edge.second)->info();
            if (a < 0 || b < 0) continue;
            const std::pair<std::uint32_t, std::uint32_t> pair =
                std::minmax({root(static_cast<std::uint32_t>(a)), root(static_cast<std::uint32_t>(b))});
            if (pair.first != pair.second) length[pair] += std::sqrt(cdt_.segment(edge).squared_length());
        }
        return length;
    }

    void join_empty_regions() {
        for (std::uint32_t r = 0; r < regions_; ++r) {
            if (root(r) != r || holes_in_[r] > 0) continue;
            std::vector<std::pair<double, std::uint32_t>> neighbours;
            for (const auto& [pair, length] : borders())
                if (pair.first == r || pair.second == r)
                    neighbours.emplace_back(-length, pair.first == r ? pair.second : pair.first);
            std::ranges::sort(neighbours);
            for (const auto& [length, other] : neighbours) {
                joined_[r] = other;
                if (!touches_itself(outline_of(root(r)))) break;
                joined_[r] = r;
            }
            if (joined_[r] == r) continue;
            result_.notes.push_back(
                fmt::format("no borehole stands in the part between faults around x {:.10g}, y {:.10g}; it "
                            "goes with its neighbour",
                            centre_[r].x, centre_[r].y));
        }
    }

    //! A corner that an outline passes twice.
    static std::optional<Point2> touches_itself(const Footprint& outline) {
        std::set<std::pair<double, double>> seen;
        for (const auto& ring : outline)
            for (const Point2& p : ring)
                if (!seen.insert({p.x, p.y}).second) return p;
        return std::nullopt;
    }

    void number_blocks() {
        std::vector<std::int64_t> number(regions_, -1);
        for (std::uint32_t r = 0; r < regions_; ++r)
            if (root(r) == r) {
                if (holes_in_of(r) == 0)
                    throw InvalidInput(
                        fmt::format("no borehole stands in the part of the footprint around x {:.10g}, y "
                                    "{:.10g}, beyond a fault, and it "
                                    "can't go with a neighbour (leave a trace out there)",
                                    centre_[r].x, centre_[r].y));
                number[r] = static_cast<std::int64_t>(result_.outline.size());
                result_.outline.push_back(outline_of(r));
                if (const auto at = touches_itself(result_.outline.back()))
                    throw InvalidInput(
                        fmt::format("a part between faults meets itself in the point x {:.10g}, y {:.10g} "
                                    "(move a trace there)",
                                    at->x, at->y));
            }
        for (const std::uint32_t region : region_of_)
            result_.block_of.push_back(static_cast<std::uint32_t>(number[root(region)]));
    }

    std::size_t holes_in_of(std::uint32_t r) const {
        std::size_t sum = 0;
        for (std::uint32_t other = 0; other < regions_; ++other)
            if (root(other) == r) sum += holes_in_[other];
        return sum;
    }

    bool is_in(Cdt::Face_handle face, std::uint32_t block) const {
        return face->info() >= 0 && root(static_cast<std::uint32_t>(face->info())) == block;
    }

    //! Walk around the block, its inside to the left, one ring for each border.
    Footprint outline_of(std::uint32_t block) const {
        Footprint rings;
        std::set<std::pair<Cdt::Face_handle, int>> walked;
        for (const auto start : cdt_.finite_face_handles())
            for (int side = 0; side < 3; ++side) {
                if (!is_in(start, block) || is_in(start->neighbor(side), block)) continue;
                if (walked.contains({start, side})) continue;
                auto& ring = rings.emplace_back();
                Cdt::Face_handle face = start;
                int i = side;
                do {
                    walked.insert({face, i});
                    const CgalPoint& p = face->vertex(Cdt::ccw(i))->point();
                    ring.push_back({p.x(), p.y()});
                    const auto corner = face->vertex(Cdt::cw(i));
                    i = Cdt::ccw(i);
                    while (is_in(face->neighbor(i), block)) {
                        face = face->neighbor(i);
                        i = Cdt::cw(face->index(corner));
                    }
                } while (face != Cdt::Face_handle(start) || i != side);
            }
        return rings;
    }

    const std::vector<Point2>& holes_;
    double extent_;
    FaultTraces traces_;
    PlanLines lines_;
    Footprint footprint_;
    Cdt cdt_;
    std::size_t regions_ = 0;
    std::vector<Point2> centre_;
    std::vector<std::uint32_t> joined_;     // region -> the one it goes with
    std::vector<std::size_t> holes_in_;     // by region
    std::vector<std::uint32_t> region_of_;  // by hole
    FaultBlocks result_;
};

}  // namespace

FaultBlocks fault_blocks(const Footprint& footprint, const FaultTraces& traces,
                         const std::vector<Point2>& holes) {
    return BlockPartition(footprint, traces, holes).run();
}

FaultBlocks fault_blocks_of(const Survey& survey, const FaultTraces& traces,
                            const std::optional<Footprint>& footprint) {
    std::vector<Point2> sites;
    for (const Borehole& hole : survey.holes) sites.push_back(hole.at);
    return fault_blocks(checked_footprint(footprint ? *footprint : hull_footprint(HoleTriangulation(sites))),
                        traces, sites);
}

}  // namespace stratareeb
