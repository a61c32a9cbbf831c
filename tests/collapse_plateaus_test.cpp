// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/collapse_plateaus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "io/read_mesh.h"
#include "tests/shapes.h"

namespace stratareeb {
namespace {

using NodeKey = std::tuple<double, std::size_t, std::size_t>;  // value, arcs down, arcs up

struct Shape {
    std::vector<NodeKey> nodes;
    std::vector<std::pair<NodeKey, NodeKey>> arcs;
    bool operator==(const Shape&) const = default;

    void sort() {
        std::ranges::sort(nodes);
        std::ranges::sort(arcs);
    }
};

Shape shape_of(const ReebGraph& graph) {
    Shape shape;
    const auto key = [&](std::uint32_t n) {
        return NodeKey(graph.nodes[n].value, graph.nodes[n].down, graph.nodes[n].up);
    };
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) shape.nodes.push_back(key(n));
    for (const ReebArc& arc : graph.arcs) shape.arcs.emplace_back(key(arc.lower), key(arc.upper));
    shape.sort();
    return shape;
}

class Pieces {
 public:
    explicit Pieces(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t root(std::size_t i) const {
        while (parent_[i] != i) i = parent_[i];
        return i;
    }
    void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
    std::vector<std::size_t> parent_;
};

//! The Reeb graph of a field with plateaus, straight from the definition: pieces of the level sets at each value and between
//! each two, and which touch. Of vertices and edges: a vertex v is piece v, an edge e piece V + e.
class PlateauOracle {
 public:
    PlateauOracle(const TriMesh& mesh, const ScalarField& field) : mesh_(mesh), field_(field) {
        const std::set<double> distinct(field.begin(), field.end());
        values_.assign(distinct.begin(), distinct.end());
    }

    Shape shape() {
        // For each piece between two values: the pieces at its lower and at its upper value.
        using Piece = std::pair<std::size_t, std::size_t>;  // index of the value, name
        std::map<Piece, std::set<Piece>> down, up;          // of pieces at values: pieces between
        std::map<Piece, Piece> below, above;                // of pieces between
        std::set<Piece> at;
        std::vector<Pieces> level, between;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            level.push_back(pieces(values_[k], values_[k]));
            for (std::size_t v = 0; v < field_.size(); ++v)
                if (field_[v] == values_[k]) at.insert({k, level[k].root(v)});
        }
        for (std::size_t k = 0; k + 1 < values_.size(); ++k) {
            between.push_back(pieces(values_[k], values_[k + 1]));
            for (const auto e : mesh_.edges()) {
                const auto [a, b] = ends(e);
                if (!(field_[a] <= values_[k] && field_[b] >= values_[k + 1])) continue;
                const std::size_t name = field_.size() + static_cast<std::size_t>(e.idx());
                const Piece piece{k, between[k].root(name)};
                const Piece lower{k, level[k].root(field_[a] == values_[k] ? a : name)},
                    upper{k + 1, level[k + 1].root(field_[b] == values_[k + 1] ? b : name)};
                at.insert({lower, upper});
                up[lower].insert(piece);
                down[upper].insert(piece);
                below[piece] = lower;
                above[piece] = upper;
            }
        }
        Shape shape;
        const auto is_passed = [&](const Piece& p) { return down[p].size() == 1 && up[p].size() == 1; };
        const auto key = [&](const Piece& p) {
            return NodeKey(values_[p.first], down[p].size(), up[p].size());
        };
        for (const Piece& p : at) {
            if (is_passed(p)) continue;
            shape.nodes.push_back(key(p));
            for (Piece piece : up[p]) {
                while (is_passed(above[piece])) piece = *up[above[piece]].begin();
                shape.arcs.emplace_back(key(p), key(above[piece]));
            }
        }
        shape.sort();
        return shape;
    }

 private:
    std::pair<std::size_t, std::size_t> ends(TriMesh::EdgeHandle e) const {
        const auto h = mesh_.halfedge_handle(e, 0);
        auto a = static_cast<std::size_t>(mesh_.from_vertex_handle(h).idx()),
             b = static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx());
        if (field_[a] > field_[b]) std::swap(a, b);
        return {a, b};
    }

    //! Pieces of the level set at a value (low == high) or anywhere between two: in each triangle, what it holds of it hangs
    //! together.
    Pieces pieces(double low, double high) const {
        Pieces pieces(field_.size() + mesh_.n_edges());
        for (const auto f : mesh_.faces()) {
            std::vector<std::size_t> here;
            for (const auto v : mesh_.fv_range(f))
                if (low == high && field_[static_cast<std::size_t>(v.idx())] == low)
                    here.push_back(static_cast<std::size_t>(v.idx()));
            for (const auto e : mesh_.fe_range(f)) {
                const auto [a, b] = ends(e);
                const bool crossed =
                    low == high ? field_[a] < low && field_[b] > low : field_[a] <= low && field_[b] >= high;
                if (crossed) here.push_back(field_.size() + static_cast<std::size_t>(e.idx()));
            }
            for (std::size_t i = 1; i < here.size(); ++i) pieces.unite(here[0], here[i]);
        }
        return pieces;
    }

    const TriMesh& mesh_;
    const ScalarField& field_;
    std::vector<double> values_;
};

std::vector<shapes::Shape> all_shapes() {
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces())
        if (shape.name.find("bius") == std::string::npos) all.push_back(std::move(shape));
    return all;
}

TEST(CollapsePlateaus, gives_the_graph_of_the_definition) {
    std::mt19937_64 random(31);
    int compared = 0;
    for (const auto& shape : all_shapes()) {
        const TriMesh mesh = half_edge_mesh(shape.soup);
        if (mesh.n_vertices() > 600) continue;
        for (int round = 0; round < 40; ++round) {
            ScalarField field = height_field(mesh);
            if (round > 0)
                for (double& value : field) value = static_cast<double>(random() % (round % 2 ? 3 : 6));
            const ReebGraph graph = reeb_graph(mesh, field), collapsed = collapse_plateaus(graph);
            ASSERT_EQ(shape_of(collapsed), PlateauOracle(mesh, field).shape())
                << shape.name << ", round " << round;
            EXPECT_EQ(collapsed.loops(), graph.loops()) << shape.name;
            EXPECT_EQ(collapsed.components, graph.components) << shape.name;
            ++compared;
        }
    }
    EXPECT_GE(compared, 400);
}

//! The same surface with its vertices in another order and its triangles turned.
TriangleSoup renumbered(const TriangleSoup& soup, std::mt19937_64& random) {
    std::vector<std::uint32_t> to(soup.points.size());
    std::iota(to.begin(), to.end(), 0u);
    for (std::size_t v = to.size(); v > 1; --v) std::swap(to[v - 1], to[random() % v]);
    TriangleSoup result{.points = soup.points, .triangles = {}};
    for (std::size_t v = 0; v < to.size(); ++v) result.points[to[v]] = soup.points[v];
    for (const auto& t : soup.triangles) result.triangles.push_back({to[t[1]], to[t[2]], to[t[0]]});
    for (std::size_t i = result.triangles.size(); i > 1; --i)
        std::swap(result.triangles[i - 1], result.triangles[random() % i]);
    return result;
}

TEST(CollapsePlateaus, does_not_depend_on_the_numbering_of_vertices) {
    std::mt19937_64 random(32);
    for (const auto& shape : all_shapes()) {
        const auto rounded_height = [](const TriMesh& mesh) {
            ScalarField field = height_field(mesh, {0.3, 0.2, 1});
            for (double& value : field) value = std::round(3 * value);
            return field;
        };
        const TriMesh mesh = half_edge_mesh(shape.soup);
        const ReebGraph graph = reeb_graph(mesh, rounded_height(mesh));
        const Shape expected = shape_of(collapse_plateaus(graph));
        for (int round = 0; round < 10; ++round) {
            const TriMesh other = half_edge_mesh(renumbered(shape.soup, random));
            const ReebGraph renumbered_graph = reeb_graph(other, rounded_height(other));
            EXPECT_EQ(renumbered_graph.loops(), graph.loops()) << shape.name;
            EXPECT_EQ(shape_of(collapse_plateaus(renumbered_graph)), expected) << shape.name;
        }
    }
}

TEST(CollapsePlateaus, of_public_models_does_not_depend_on_the_numbering_of_vertices) {
    const std::string folder = STRATAREEB_SOURCE_DIR "/../shared/data/models/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
    std::mt19937_64 random(33);
    for (const char* name : {"3holes_g3", "adis16480_g24", "beetle_11holes", "bunny_5holes", "casting_g9",
                             "face_1hole", "gears_7comp", "igea", "menger2_g81", "plate3x3_axis_g9",
                             "rocker-arm_g1", "spot", "terrain129_disk", "torus60x30_flat_g1"}) {
        const TriangleSoup soup = read_mesh(folder + name + ".ply");
        const TriMesh mesh = half_edge_mesh(soup), other = half_edge_mesh(renumbered(soup, random));
        const ReebGraph graph = reeb_graph(mesh, height_field(mesh)),
                        renumbered_graph = reeb_graph(other, height_field(other));
        EXPECT_EQ(renumbered_graph.loops(), graph.loops()) << name;
        EXPECT_EQ(shape_of(collapse_plateaus(renumbered_graph)), shape_of(collapse_plateaus(graph))) << name;
    }
}

// A plate with a hole, lying flat: its underside and its top are one node each, the ring's two walls are the arcs.
TEST(CollapsePlateaus, makes_one_node_of_a_ring) {
    const TriMesh mesh = half_edge_mesh(shapes::plate(3, 3, [](auto i, auto j) { return i == 1 && j == 1; }));
    const ScalarField field = height_field(mesh);
    const ReebGraph ring = collapse_plateaus(reeb_graph(mesh, field));
    ASSERT_EQ(ring.nodes.size(), 2u);
    EXPECT_EQ(ring.nodes[0].up, 2u);
    EXPECT_EQ(ring.nodes[1].down, 2u);
    EXPECT_EQ(ring.arcs.size(), 2u);
    EXPECT_EQ(ring.loops(), 1u);
    EXPECT_EQ(ring.hidden_loops, 0u);
    for (const std::uint32_t arc : ring.vertex_arc) EXPECT_LT(arc, ring.arcs.size());
    for (const std::uint32_t arc : ring.triangle_arc) EXPECT_LT(arc, ring.arcs.size());
    // Seen from the side with all heights alike, the whole surface is one node; its handle is hidden there.
    const ReebGraph point = collapse_plateaus(reeb_graph(mesh, ScalarField(mesh.n_vertices(), 4.0)));
    EXPECT_EQ(point.nodes.size(), 1u);
    EXPECT_TRUE(point.arcs.empty());
    EXPECT_EQ(point.loops(), 1u);
    EXPECT_EQ(point.vertex_arc.front(), ReebGraph::kNone);
}

}  // namespace
}  // namespace stratareeb
