// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/arc_index.h"

#include <algorithm>
#include <span>
#include <utility>

#include "reeb/contour_trace.h"

namespace stratareeb {

namespace {

std::vector<IntervalTree::Interval> spans_of(const ReebGraph& graph) {
    std::vector<IntervalTree::Interval> spans;
    spans.reserve(graph.arcs.size());
    for (const ReebArc& arc : graph.arcs)
        spans.push_back({graph.nodes[arc.lower].value, graph.nodes[arc.upper].value});
    return spans;
}

}  // namespace

ArcIndex::ArcIndex(const TriMesh& mesh, const ScalarField& field, const ReebGraph& graph)
    : mesh_(mesh), field_(field), spans_(spans_of(graph)) {
    first_.reserve(graph.arcs.size() + 1);
    for (std::uint32_t arc = 0; arc < graph.arcs.size(); ++arc) {
        first_.push_back(path_.size());
        add_path(graph, arc);
    }
    first_.push_back(path_.size());
}

//! Down from the top, by highest lower neighbours: within the arc there is one contour below each vertex, and all edges down
//! cross it.
void ArcIndex::add_path(const ReebGraph& graph, std::uint32_t arc) {
    const std::uint32_t bottom = graph.nodes[graph.arcs[arc].lower].vertex;
    path_.push_back(graph.arcs[arc].top);
    std::uint32_t v = graph.arcs[arc].below_top;
    while (is_below(field_, bottom, v)) {
        path_.push_back(v);
        v = highest_below(v);
    }
    path_.push_back(v);
}

std::uint32_t ArcIndex::highest_below(std::uint32_t vertex) const {
    std::uint32_t highest = vertex;
    for (const auto h : mesh_.voh_range(TriMesh::VertexHandle(static_cast<int>(vertex)))) {
        const auto v = static_cast<std::uint32_t>(mesh_.to_vertex_handle(h).idx());
        if (is_below(field_, v, vertex) && (highest == vertex || is_below(field_, highest, v))) highest = v;
    }
    return highest;
}

ArcIndex::Halfedge ArcIndex::step_down(std::uint32_t arc, std::size_t step) const {
    const std::size_t from = first_[arc] + step;
    return mesh_.find_halfedge(TriMesh::VertexHandle(static_cast<int>(path_[from])),
                               TriMesh::VertexHandle(static_cast<int>(path_[from + 1])));
}

//! The half-edge of the arc's path that leads down through the level.
ArcIndex::Halfedge ArcIndex::crossed_edge(std::uint32_t arc, double level) const {
    const auto path = std::span(path_).subspan(first_[arc], first_[arc + 1] - first_[arc]);
    const auto below =
        std::ranges::partition_point(path, [&](std::uint32_t v) { return field_[v] >= level; });
    return step_down(arc, static_cast<std::size_t>(below - path.begin()) - 1);
}

ArcIndex::Halfedge ArcIndex::crossed_above(std::uint32_t arc, double level) const {
    const auto path = std::span(path_).subspan(first_[arc], first_[arc + 1] - first_[arc]);
    const auto below = std::ranges::partition_point(path, [&](std::uint32_t v) { return field_[v] > level; });
    return step_down(arc, static_cast<std::size_t>(below - path.begin()) - 1);
}

//! Back along the contour to its end on the boundary, or once around to where it was.
ArcIndex::Halfedge ArcIndex::first_of_contour(Halfedge crossed, double level) const {
    Halfedge h = crossed;
    do {
        const Halfedge up = mesh_.opposite_halfedge_handle(h);  // out of the triangle before
        if (mesh_.is_boundary(up)) return h;
        const bool apex_above = value(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(up))) >= level;
        h = mesh_.next_halfedge_handle(up);
        if (apex_above) h = mesh_.next_halfedge_handle(h);
    } while (h != crossed);
    return crossed;
}

Contour ArcIndex::contour(std::uint32_t arc, double level) const {
    const Halfedge start = first_of_contour(crossed_edge(arc, level), level);
    return trace_contour(mesh_, field_, level, start);
}

LevelSet ArcIndex::level_set(double level) const {
    LevelSet set{.level = level, .contours = {}};
    for (const std::uint32_t arc : arcs_at(level)) {
        Contour found = contour(arc, level);
        if (found.points.size() > 1) set.contours.push_back(std::move(found));
    }
    return set;
}

}  // namespace stratareeb
