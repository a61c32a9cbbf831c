// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/control_topology.h"

#include <fmt/format.h>
#include <opensubdiv/far/error.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefiner.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boreholes/errors.h"
#include "subdivision/dart_limit.h"
#include "subdivision/osd_values.h"

namespace stratareeb {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using PrimvarRefiner = Far::PrimvarRefinerReal<double>;
using Refiner = std::unique_ptr<Far::TopologyRefiner>;

// What OpenSubdiv says when it refuses; on standard error by default.
thread_local std::string osd_message;
void keep_message(Far::ErrorType, const char* message) {
    osd_message = message;
}

std::string edge_place(const ControlMesh& mesh, std::size_t a, std::size_t b) {
    return fmt::format("edge from vertex {} to vertex {}", place_of(mesh, a), place_of(mesh, b));
}

// OpenSubdiv takes any mesh; ours are 2-manifold, and wound alike.
void require_manifold(const ControlMesh& mesh, const Far::TopologyLevel& base) {
    for (int e = 0; e < base.GetNumEdges(); ++e) {
        const auto ends = base.GetEdgeVertices(e);
        const auto faces = base.GetEdgeFaces(e);
        if (faces.size() > 2)
            throw InvalidInput(fmt::format("{} has {} faces (not a manifold)",
                                           edge_place(mesh, ends[0], ends[1]), faces.size()));
        const auto local = base.GetEdgeFaceLocalIndices(e);
        if (base.IsEdgeNonManifold(e) || (faces.size() == 2 && base.GetFaceVertices(faces[0])[local[0]] ==
                                                                   base.GetFaceVertices(faces[1])[local[1]]))
            throw InvalidInput(fmt::format("{} has faces that are wound against each other",
                                           edge_place(mesh, ends[0], ends[1])));
    }
    for (int v = 0; v < base.GetNumVertices(); ++v)
        if (base.IsVertexNonManifold(v) && !base.GetVertexFaces(v).empty())
            throw InvalidInput(
                fmt::format("vertex {} has more than one fan of faces (not a manifold)", place_of(mesh, v)));
}

void require_creases(const ControlMesh& mesh, const Far::TopologyLevel& base) {
    for (const auto& crease : mesh.creases)
        if (base.FindEdge(static_cast<int>(crease.from), static_cast<int>(crease.to)) < 0)
            throw InvalidInput(fmt::format("the crease from vertex {} to vertex {} is no edge of the mesh",
                                           place_of(mesh, crease.from), place_of(mesh, crease.to)));
}

// Creases and corners in OpenSubdiv's separate arrays.
struct Sharpness {
    std::vector<int> edges, vertices;
    std::vector<float> edge_weights, vertex_weights;
};

Sharpness sharpness(const ControlMesh& mesh) {
    Sharpness all;
    for (const auto& crease : mesh.creases) {
        all.edges.insert(all.edges.end(), {static_cast<int>(crease.from), static_cast<int>(crease.to)});
        all.edge_weights.push_back(static_cast<float>(std::min(crease.sharpness, kInfiniteSharpness)));
    }
    for (const auto& corner : mesh.sharp_corners) {
        all.vertices.push_back(static_cast<int>(corner.vertex));
        all.vertex_weights.push_back(static_cast<float>(std::min(corner.sharpness, kInfiniteSharpness)));
    }
    return all;
}

Refiner base_topology(const ControlMesh& mesh) {
    const Sharpness sharp = sharpness(mesh);
    std::vector<int> triangle_sizes;
    if (mesh.sizes.empty()) triangle_sizes.assign(mesh.corners.size() / 3, 3);
    Far::TopologyDescriptor description;
    description.numVertices = static_cast<int>(mesh.vertices);
    description.numFaces = static_cast<int>(mesh.sizes.empty() ? triangle_sizes.size() : mesh.sizes.size());
    // The same bits, signed: the counts have been checked.
    description.numVertsPerFace =
        mesh.sizes.empty() ? triangle_sizes.data() : reinterpret_cast<const int*>(mesh.sizes.data());
    description.vertIndicesPerFace = reinterpret_cast<const int*>(mesh.corners.data());
    description.numCreases = static_cast<int>(mesh.creases.size());
    description.creaseVertexIndexPairs = sharp.edges.data();
    description.creaseWeights = sharp.edge_weights.data();
    description.numCorners = static_cast<int>(mesh.sharp_corners.size());
    description.cornerVertexIndices = sharp.vertices.data();
    description.cornerWeights = sharp.vertex_weights.data();

    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    const auto scheme = mesh.scheme == SubdivisionScheme::Loop ? OpenSubdiv::Sdc::SCHEME_LOOP
                                                               : OpenSubdiv::Sdc::SCHEME_CATMARK;
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Far::SetErrorCallback(keep_message);
    Far::SetWarningCallback([](const char*) {});  // of creases that are no edges; an error of ours
    Refiner refiner(Factory::Create(description, Factory::Options(scheme, options)));
    if (!refiner) throw InvalidInput("OpenSubdiv refuses the mesh: " + osd_message);
    return refiner;
}

void require_one_each(std::size_t values, const Far::TopologyLevel& level) {
    if (values != static_cast<std::size_t>(level.GetNumVertices()))
        throw InvalidInput(fmt::format("{} values for {} vertices", values, level.GetNumVertices()));
}

// The values of the last level from those of the control mesh, level by level.
template <class Value>
std::vector<Value> values_of_last_level(const Far::TopologyRefiner& topology,
                                        std::span<const Value> control) {
    require_one_each(control.size(), topology.GetLevel(0));
    std::vector<Value> values(control.begin(), control.end()), next;
    const PrimvarRefiner refiner(topology);
    for (int level = 1; level <= topology.GetMaxLevel(); ++level) {
        next.resize(topology.GetLevel(level).GetNumVertices());
        auto to = destination(next);
        refiner.Interpolate(level, values.data(), to);
        std::swap(values, next);
    }
    return values;
}

// The corners of a face from one vertex on.
struct FaceAround {
    int next, opposite, previous;
};

FaceAround face_around(const Far::TopologyLevel& level, int vertex, int place) {
    const auto corners = level.GetFaceVertices(level.GetVertexFaces(vertex)[place]);
    const int n = corners.size(), at = level.GetVertexFaceLocalIndices(vertex)[place];
    return {corners[(at + 1) % n], corners[(at + 2) % n], corners[(at + n - 1) % n]};
}

int crease_end(const Far::TopologyLevel& level, int vertex) {
    for (const int e : level.GetVertexEdges(vertex))
        if (level.GetEdgeSharpness(e) > 0) {
            const auto ends = level.GetEdgeVertices(e);
            return ends[0] == vertex ? ends[1] : ends[0];
        }
    return -1;
}

WeightedVertices dart_terms(const Far::TopologyLevel& level, SubdivisionScheme scheme, int vertex) {
    const int n = level.GetVertexEdges(vertex).size();
    const DartLimit limit = dart_limit(scheme, n);
    WeightedVertices terms{{vertex, limit.vertex}};
    int edge = crease_end(level, vertex);
    for (int i = 0; i < n; ++i) {
        terms.emplace_back(edge, limit.edges[i]);
        int place = 0;
        while (face_around(level, vertex, place).next != edge) ++place;
        const FaceAround face = face_around(level, vertex, place);
        if (scheme == SubdivisionScheme::CatmullClark) terms.emplace_back(face.opposite, limit.faces[i]);
        edge = face.previous;
    }
    return terms;
}

// Put the limits of darts right: OpenSubdiv takes them for smooth.
template <class From, class To>
void correct_darts(const Far::TopologyRefiner& topology, const From& from, To& to) {
    const auto& level = topology.GetLevel(topology.GetMaxLevel());
    const auto scheme = topology.GetSchemeType() == Sdc::SCHEME_LOOP ? SubdivisionScheme::Loop
                                                                     : SubdivisionScheme::CatmullClark;
    for (int v = 0; v < level.GetNumVertices(); ++v) {
        if (level.GetVertexRule(v) != Sdc::Crease::RULE_DART) continue;
        to[v].Clear();
        for (const auto& [vertex, weight] : dart_terms(level, scheme, v))
            to[v].AddWithWeight(from[vertex], weight);
    }
}

template <class Value>
std::vector<Value> limits_of_last_level(const Far::TopologyRefiner& topology,
                                        std::span<const Value> refined) {
    require_one_each(refined.size(), topology.GetLevel(topology.GetMaxLevel()));
    std::vector<Value> limits(refined.size());
    auto to = destination(limits);
    const auto* from = refined.data();
    PrimvarRefiner(topology).Limit(from, to);
    correct_darts(topology, from, to);
    return limits;
}

VertexKind kind_of(const Far::TopologyLevel& level, int vertex) {
    const auto rule = level.GetVertexRule(vertex);  // the end of a crease is smooth: a dart
    if (rule == Sdc::Crease::RULE_CORNER) return VertexKind::Corner;
    if (rule == Sdc::Crease::RULE_CREASE)
        return level.IsVertexBoundary(vertex) ? VertexKind::Outline : VertexKind::Crease;
    return VertexKind::Inside;
}

Point3 unit_normal(const Point3& u, const Point3& v) {
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0 ? Point3{n.x / length, n.y / length, n.z / length} : Point3{0, 0, 1};
}

}  // namespace

struct ControlTopology::Osd {
    Refiner refiner;
};

ControlTopology::ControlTopology(const ControlMesh& mesh, int levels, LimitsWanted limits) {
    require_faces(mesh, levels);
    osd_ = std::make_unique<Osd>(Osd{base_topology(mesh)});
    require_manifold(mesh, osd_->refiner->GetLevel(0));
    require_creases(mesh, osd_->refiner->GetLevel(0));
    if (levels == 0) return;
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = limits == LimitsWanted::Yes;
    osd_->refiner->RefineUniform(options);
}

ControlTopology::~ControlTopology() = default;
ControlTopology::ControlTopology(ControlTopology&&) noexcept = default;
ControlTopology& ControlTopology::operator=(ControlTopology&&) noexcept = default;

int ControlTopology::levels() const {
    return osd_->refiner->GetMaxLevel();
}

std::size_t ControlTopology::vertex_count(int level) const {
    return osd_->refiner->GetLevel(level).GetNumVertices();
}

std::size_t ControlTopology::face_count(int level) const {
    return osd_->refiner->GetLevel(level).GetNumFaces();
}

std::vector<std::uint32_t> ControlTopology::corners(int level) const {
    const auto& faces = osd_->refiner->GetLevel(level);
    std::vector<std::uint32_t> corners;
    corners.reserve(faces.GetNumFaceVertices());
    for (int f = 0; f < faces.GetNumFaces(); ++f)
        for (const auto v : faces.GetFaceVertices(f)) corners.push_back(static_cast<std::uint32_t>(v));
    return corners;
}

std::vector<double> ControlTopology::refined(std::span<const double> control) const {
    return values_of_last_level(*osd_->refiner, control);
}

std::vector<Point3> ControlTopology::refined(std::span<const Point3> control) const {
    return values_of_last_level(*osd_->refiner, control);
}

std::vector<double> ControlTopology::limit(std::span<const double> refined) const {
    return limits_of_last_level(*osd_->refiner, refined);
}

std::vector<Point3> ControlTopology::limit(std::span<const Point3> refined) const {
    return limits_of_last_level(*osd_->refiner, refined);
}

LimitSurface ControlTopology::limit_surface(std::span<const Point3> refined) const {
    require_one_each(refined.size(), osd_->refiner->GetLevel(levels()));
    LimitSurface surface{std::vector<Point3>(refined.size()), std::vector<Point3>(refined.size())};
    std::vector<Point3> v_tangents(refined.size());
    Points points{surface.points.data()}, u{surface.normals.data()}, v{v_tangents.data()};
    const auto* from = refined.data();
    PrimvarRefiner(*osd_->refiner).Limit(from, points, u, v);
    correct_darts(*osd_->refiner, from, points);
    for (std::size_t i = 0; i < refined.size(); ++i)
        surface.normals[i] = unit_normal(surface.normals[i], v_tangents[i]);
    return surface;
}

std::vector<VertexKind> ControlTopology::kinds() const {
    const auto& level = osd_->refiner->GetLevel(levels());
    std::vector<VertexKind> kinds(level.GetNumVertices());
    for (int v = 0; v < level.GetNumVertices(); ++v) kinds[v] = kind_of(level, v);
    return kinds;
}

SparseRows ControlTopology::refined_rows() const {
    SparseRows rows;
    if (levels() == 0) {  // for which OpenSubdiv makes no table
        for (std::uint32_t v = 0; v < vertex_count(0); ++v) {
            rows.column.push_back(v);
            rows.weight.push_back(1);
            rows.first.push_back(v + 1);
        }
        return rows;
    }
    using Factory = Far::StencilTableFactoryReal<double>;
    Factory::Options options;
    options.generateIntermediateLevels = false;
    const std::unique_ptr<const Far::StencilTableReal<double>> table(
        Factory::Create(*osd_->refiner, options));
    rows.first.reserve(table->GetNumStencils() + 1);
    for (const auto size : table->GetSizes())
        rows.first.push_back(rows.first.back() + static_cast<std::uint32_t>(size));
    rows.column.assign(table->GetControlIndices().begin(), table->GetControlIndices().end());
    rows.weight = table->GetWeights();
    return rows;
}

SparseRows ControlTopology::limit_rows(std::span<const std::uint32_t> control_vertices) const {
    // The limit masks of the control vertices themselves: those of a copy that is not refined and shares the control mesh.
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const Refiner unrefined(Factory::Create(*osd_->refiner));
    std::vector<WeightedVertices> terms(vertex_count(0));
    WeightRows to{&terms};
    PrimvarRefiner(*unrefined).Limit(VertexNumbers{}, to);
    correct_darts(*unrefined, VertexNumbers{}, to);
    SparseRows rows;
    for (const auto vertex : control_vertices) {
        if (vertex >= terms.size()) throw InvalidInput(fmt::format("vertex {} of {}", vertex, terms.size()));
        auto& row = terms[vertex];
        std::erase_if(row, [](const auto& term) { return term.second == 0; });
        std::sort(row.begin(), row.end());
        for (const auto& [column, weight] : row) {
            rows.column.push_back(column);
            rows.weight.push_back(weight);
        }
        rows.first.push_back(static_cast<std::uint32_t>(rows.column.size()));
    }
    return rows;
}

}  // namespace stratareeb
