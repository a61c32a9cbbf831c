// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "mesh/cut_lines.h"

namespace stratareeb {

namespace {

using Vertex = TriMesh::VertexHandle;

constexpr double kBump = 0.05;  // of the thickness around, where a body would touch itself along a line
constexpr double kKept = 0.1;   // of its thickness, by a layer from which thickness is taken

std::size_t index(OpenMesh::BaseHandle handle) {
    return static_cast<std::size_t>(handle.idx());
}

void add_scaled(std::vector<double>& sum, const std::vector<double>& values, double factor) {
    sum.resize(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += factor * values[i];
}

//! A plan vertex with all that is linear over the triangles.
struct CutVertex {
    UncutColumn uncut;
    std::vector<double> base;  // uncut_bases
    std::vector<double> z;     // horizons as far as they are cut
    LayerSet zero;             // layers without thickness

    void add(const CutVertex& other, double factor) {
        uncut.ground += factor * other.uncut.ground;
        add_scaled(uncut.anchor, other.uncut.anchor, factor);
        add_scaled(uncut.thickness, other.uncut.thickness, factor);
        add_scaled(uncut.taper, other.uncut.taper, factor);
        add_scaled(base, other.base, factor);
        add_scaled(z, other.z, factor);
    }
};

class LayerCut {
 public:
    LayerCut(LayerModel& model, const std::vector<LayerSequence>& sequences, const LayerRules& rules,
             double thinnest)
        : model_(model),
          mesh_(model.plan.surface),
          layers_(model.units.size()),
          sequences_(sequences),
          rules_(rules),
          thinnest_(thinnest) {}

    void run(std::vector<UncutColumn> columns, double opening) {
        start(std::move(columns));
        for (std::size_t n = sequences_.size(); n-- > 0;)
            if (sequences_[n].on_onlap) lap_on(n);
        for (CutVertex& v : vertices_) v.base = uncut_bases(v.uncut, sequences_);
        for (CutVertex& v : vertices_) v.z.assign(1, v.uncut.ground);
        for (std::size_t h = 0; h < model_.plan.hole_vertex.size(); ++h)
            if (const auto v = model_.plan.hole_vertex[h]; v != PlanMesh::kNoVertex)
                vertices_[v].z[0] = model_.columns.ground[h];
        for (const LayerSequence& s : sequences_)
            for (std::size_t i = s.first; i <= s.last; ++i) place_layer(s, i);
        mend(opening);
        set_horizons();
    }

 private:
    static constexpr std::uint32_t kNoHole = ~0u;

    void start(std::vector<UncutColumn> columns) {
        vertices_.resize(columns.size());
        for (std::size_t v = 0; v < columns.size(); ++v) {
            vertices_[v].uncut = std::move(columns[v]);
            vertices_[v].zero = model_.regions.zero_at[v];
        }
        hole_at_.assign(columns.size(), kNoHole);
        for (std::size_t h = 0; h < model_.plan.hole_vertex.size(); ++h)
            if (const auto v = model_.plan.hole_vertex[h]; v != PlanMesh::kNoVertex)
                hole_at_[v] = static_cast<std::uint32_t>(h);
    }

    double in_hole(std::size_t layer, std::size_t v) const {
        return model_.columns.thickness[layer][hole_at_[v]];
    }

    //! The sign is what the hole says; rounding is 0.
    double signed_value(std::size_t layer, std::size_t v, double value) const {
        if (std::abs(value) <= thinnest_) value = 0;
        if (hole_at_[v] == kNoHole) return value;
        const double there = in_hole(layer, v);
        return there > 0 ? (value > 0 ? value : there) : std::min(value, 0.0);
    }

    //! Holes, the outline and places where a layer ends stay where they are.
    std::vector<char> fixed_vertices() const {
        std::vector<char> fixed(vertices_.size(), 0);
        for (const Vertex v : mesh_.vertices()) {
            const std::size_t i = index(v);
            fixed[i] = hole_at_[i] != kNoHole || mesh_.is_boundary(v);
            const LayerSet zero = vertices_[i].zero;
            for (const auto f : mesh_.vf_range(v)) {
                const LayerSet lacking = all_layers() & ~model_.regions.in_face[index(f)];
                if (lacking != zero) fixed[i] = 1;
            }
        }
        return fixed;
    }

    LayerSet all_layers() const {
        LayerSet all;
        for (std::size_t i = 0; i < layers_; ++i) all.set(i);
        return all;
    }

    void set_mean(const VertexMean& mean) {
        CutVertex sum;
        sum.zero = all_layers();
        for (const auto& [v, share] : mean.of) {
            sum.add(vertices_[v], share);
            sum.zero &= vertices_[v].zero;
        }
        if (mean.vertex == vertices_.size()) {
            vertices_.push_back(std::move(sum));
            hole_at_.push_back(kNoHole);
        } else {
            vertices_[mean.vertex] = std::move(sum);
        }
    }

    //! Lead the line along which `value` is 0 through the layer's triangles; the layer has no thickness where it is not above 0.
    void cut_along(std::size_t layer, const std::vector<double>& value) {
        const bool crosses = std::ranges::any_of(value, [](double d) { return d <= 0; });
        if (!crosses) return;
        const std::vector<char> fixed = fixed_vertices();
        for (std::size_t v = 0; v < value.size(); ++v)
            if (value[v] <= 0) vertices_[v].zero.set(layer);
        const auto on_line = insert_level_line(
            mesh_, model_.regions.in_face,
            {.value = value, .layer = layer, .fixed = fixed, .on_vertex = [this](const VertexMean& mean) {
                 set_mean(mean);
             }});
        for (const std::uint32_t v : on_line) vertices_[v].zero.set(layer);
        for (const auto f : mesh_.faces()) {
            bool flat = true;
            for (const Vertex v : mesh_.fv_range(f)) flat &= vertices_[index(v)].zero[layer];
            if (flat) model_.regions.in_face[index(f)].reset(layer);
        }
    }

    //! The line along which an onlapping unit's top meets the relief below it.
    void lap_on(std::size_t n) {
        const std::size_t layer = sequences_[n].last + 1;
        std::vector<double> value(vertices_.size());
        for (std::size_t v = 0; v < value.size(); ++v) {
            const UncutColumn& column = vertices_[v].uncut;
            value[v] = signed_value(layer, v, column.anchor[n] - uncut_bases(column, sequences_)[layer]);
        }
        cut_along(layer, value);
    }

    void place_layer(const LayerSequence& s, std::size_t layer) {
        std::vector<double> value(vertices_.size());
        for (std::size_t v = 0; v < value.size(); ++v) {
            const CutVertex& vertex = vertices_[v];
            value[v] = signed_value(
                layer, v, place_unit(vertex.uncut, vertex.base, s, layer, vertex.z.back()).clearance);
            if (vertex.zero[layer]) value[v] = std::min(value[v], outside(v, layer) ? value[v] : 0.0);
        }
        cut_along(layer, value);
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            CutVertex& vertex = vertices_[v];
            double t = place_unit(vertex.uncut, vertex.base, s, layer, vertex.z.back()).thickness;
            t = vertex.zero[layer] ? 0 : std::max(t, thinnest_);
            if (hole_at_[v] != kNoHole) t = in_hole(layer, v);
            vertex.z.push_back(vertex.z.back() - t);
        }
    }

    //! On the pinch-out line, where thickness is 0 whatever the clearance.
    bool outside(std::size_t v, std::size_t layer) const { return vertices_[v].uncut.taper[layer] <= 0; }

    void mend(double opening) {
        model_.regions.zero_at.resize(vertices_.size());
        for (std::size_t v = 0; v < vertices_.size(); ++v) model_.regions.zero_at[v] = vertices_[v].zero;
        mend_layer_regions(
            model_.plan, model_.regions, layers_,
            {.opening = opening, .on_vertex = [this](const VertexMean& mean) { set_mean(mean); }});
    }

    void set_horizons() {
        model_.horizons.assign(layers_ + 1, std::vector<double>(vertices_.size()));
        for (std::size_t v = 0; v < vertices_.size(); ++v)
            hole_at_[v] == kNoHole ? set_column(v) : set_hole_column(v);
    }

    //! Horizons keep their elevations, but for what a layer needs where it is present: that pushes those below it down.
    void set_column(std::size_t v) {
        const auto& wanted = vertices_[v].z;
        double z = wanted[0];
        model_.horizons[0][v] = z;
        for (std::size_t i = 0; i < layers_; ++i) {
            if (!model_.regions.zero_at[v][i]) {
                const double uncut = wanted[i] - wanted[i + 1];
                double least = std::max({thinnest_, kKept * uncut, rules_.minimum(i)});
                if (uncut <= 10 * thinnest_) least = std::max(least, kBump * thickness_around(v, i));
                z = std::min(wanted[i + 1], z - least);
            }
            model_.horizons[i + 1][v] = z;
        }
    }

    double thickness_around(std::size_t v, std::size_t layer) const {
        double sum = 0, count = 0;
        for (const Vertex u : mesh_.vv_range(Vertex(static_cast<int>(v)))) {
            sum += vertices_[index(u)].z[layer] - vertices_[index(u)].z[layer + 1];
            count += 1;
        }
        return sum / count;
    }

    void set_hole_column(std::size_t v) {
        double z = model_.columns.ground[hole_at_[v]];
        model_.horizons[0][v] = z;
        for (std::size_t i = 0; i < layers_; ++i) {
            const double there = in_hole(i, v);
            if ((there > 0) == static_cast<bool>(model_.regions.zero_at[v][i]))
                throw GeometryError(fmt::format("layer '{}' can't {} at hole {} under its rule",
                                                model_.units[i].code, there > 0 ? "be kept" : "end",
                                                hole_at_[v] + 1));
            if (there > 0) z -= std::max(there, thinnest_);
            model_.horizons[i + 1][v] = z;
        }
    }

    LayerModel& model_;
    TriMesh& mesh_;
    std::size_t layers_;
    const std::vector<LayerSequence>& sequences_;
    const LayerRules& rules_;
    double thinnest_;
    std::vector<CutVertex> vertices_;
    std::vector<std::uint32_t> hole_at_;
};

}  // namespace

void cut_layers(LayerModel& model, const std::vector<LayerSequence>& sequences, const LayerRules& rules,
                std::vector<UncutColumn> columns, double thinnest, double opening) {
    LayerCut(model, sequences, rules, thinnest).run(std::move(columns), opening);
}

}  // namespace stratareeb
