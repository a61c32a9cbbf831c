// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of layers: mesh/volume_mesh, cell_faces, cell_quality.
#include "mesh/volume_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "io/read_boreholes.h"
#include "mesh/analysis.h"
#include "mesh/cell_faces.h"
#include "mesh/cell_quality.h"
#include "mesh/layer_volumes.h"
#include "tests/grid_model.h"

namespace stratareeb {
namespace {

using test::constant;
using test::grid_model;

LayerModel random_model(std::uint64_t seed) {
    LayerModelOptions options;
    if (seed % 3 == 0) options.spacing = 0;
    return build_layer_model(random_survey({.holes = 30,
                                            .layers = 4,
                                            .seed = seed,
                                            .corner = seed % 2 ? Point2{} : Point2{5e6, 4e5},
                                            .truth = seed % 2 ? TruthKind::Random : TruthKind::Lens,
                                            .pinch_outs = true,
                                            .resolution = seed % 4 ? 0.001 : 1.0,
                                            .zero_share = 0.3}),
                             options);
}

using Triangle = std::array<std::array<double, 3>, 3>;

Triangle sorted(Triangle t) {
    std::ranges::sort(t);
    return t;
}

//! The triangles of a layer's solid that are not walls, and the area of its walls.
std::pair<std::set<Triangle>, double> sheets_and_walls(const TriMesh& solid) {
    std::pair<std::set<Triangle>, double> result;
    for (const auto f : solid.faces()) {
        Triangle t{};
        std::size_t i = 0;
        for (const auto v : solid.fv_range(f)) {
            const auto& p = solid.point(v);
            t[i++] = {p[0], p[1], p[2]};
        }
        if (std::set<std::pair<double, double>>{{t[0][0], t[0][1]}, {t[1][0], t[1][1]}, {t[2][0], t[2][1]}}
                .size() < 3)
            result.second += solid.calc_face_area(f);
        else
            result.first.insert(sorted(t));
    }
    return result;
}

double wall_area(const VolumeMesh& mesh, const BoundaryFace& face) {
    const auto half = [&](std::size_t i, std::size_t j, std::size_t k) {
        const Point3 &a = mesh.points[face.node[i]], &b = mesh.points[face.node[j]],
                     &c = mesh.points[face.node[k]];
        return cross(OpenMesh::Vec3d(b.x - a.x, b.y - a.y, b.z - a.z),
                     OpenMesh::Vec3d(c.x - a.x, c.y - a.y, c.z - a.z))
                   .norm() /
               2;
    };
    return half(0, 1, 2) + (face.corners == 4 ? half(0, 2, 3) : 0);
}

//! All that is claimed of a mesh of a model: whole faces shared (boundary_faces throws otherwise), outer surfaces those of the
//! solids, volumes theirs, every cell well-turned.
void expect_fills(const LayerModel& model, const VolumeMesh& mesh) {
    const auto qualities = cell_qualities(mesh);
    for (const CellQuality& quality : qualities) {
        ASSERT_GT(quality.volume, 0);
        ASSERT_GT(quality.least_dihedral_deg, 0);
        ASSERT_LT(quality.largest_dihedral_deg, 180);
        ASSERT_GT(quality.aspect, 0.6);
    }
    const auto layers = layer_cells(mesh, qualities);
    const double all = envelope_volume(model);
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        const TriMesh solid = build_layer_solid(model, i).surface;
        EXPECT_NEAR(layers[i].volume, solid.n_faces() == 0 ? 0 : volume(solid), 1e-9 * all);
        auto [sheets, walls] = sheets_and_walls(solid);
        for (const BoundaryFace& face : boundary_faces(mesh, i)) {
            if (face.side == BoundarySide::Side) {
                walls -= wall_area(mesh, face);
                continue;
            }
            Triangle t{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Point3& p = mesh.points[face.node[k]];
                t[k] = {p.x, p.y, p.z};
            }
            EXPECT_EQ(sheets.erase(sorted(t)), 1u);
        }
        EXPECT_TRUE(sheets.empty());
        EXPECT_NEAR(walls, 0, 1e-9 * 300 * 300);
    }
    for (const BoundaryFace& face : boundary_faces(mesh))
        EXPECT_EQ(mesh.cells[face.cell].kind == CellKind::Tetrahedron ? face.corners : 3, 3);
    std::vector<char> used(mesh.points.size(), 0);
    for (const VolumeCell& cell : mesh.cells)
        for (std::size_t i = 0; i < corners_of(cell.kind); ++i) used[cell.node[i]] = 1;
    EXPECT_EQ(std::ranges::count(used, 0), 0);
}

TEST(VolumeMesh, fills_the_solids_in_whole_faces) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        expect_fills(model, volume_mesh(model));
        expect_fills(model, volume_mesh(model, {.tetrahedra = true}));
    }
}

TEST(VolumeMesh, has_parts_that_fill_a_layer_and_conform_too) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const auto layers = layer_volumes(model);
        for (const bool tetrahedra : {false, true})
            for (const VolumeMeshOptions& options :
                 {VolumeMeshOptions{.tetrahedra = tetrahedra, .parts = 3},
                  VolumeMeshOptions{.tetrahedra = tetrahedra, .max_thickness = 4}}) {
                const VolumeMesh mesh = volume_mesh(model, options);
                const auto outside = boundary_faces(mesh);
                EXPECT_FALSE(outside.empty());
                const auto cells = layer_cells(mesh, cell_qualities(mesh));
                for (std::size_t i = 0; i < layers.size(); ++i)
                    EXPECT_NEAR(cells[i].volume, layers[i], 1e-9 * envelope_volume(model));
                std::map<std::pair<std::uint32_t, std::size_t>, std::array<double, 2>> reach;
                for (const VolumeCell& cell : mesh.cells)
                    for (std::size_t i = 0; i < corners_of(cell.kind); ++i) {
                        const std::uint32_t node = cell.node[i];
                        auto& r = reach
                                      .try_emplace({mesh.column[node], cell.layer * 1000u + cell.part},
                                                   std::array{1e300, -1e300})
                                      .first->second;
                        r = {std::min(r[0], mesh.points[node].z), std::max(r[1], mesh.points[node].z)};
                    }
                if (options.max_thickness > 0) {
                    for (const auto& [key, r] : reach) EXPECT_LE(r[1] - r[0], 4 * (1 + 1e-9));
                }
            }
    }
}

//! The mesh of 24 × 24 squares has the plane x = 0 as the layer's edge.
TEST(VolumeMesh, of_a_wedge_has_its_volume_and_every_kind_of_cell) {
    const LayerModel wedge =
        grid_model({.thickness = {[](double x, double) { return 0.1 * x; }, constant(2)}});
    for (const bool tetrahedra : {false, true}) {
        const VolumeMesh mesh = volume_mesh(wedge, {.tetrahedra = tetrahedra});
        const auto cells = layer_cells(mesh, cell_qualities(mesh));
        EXPECT_NEAR(cells[0].volume, 0.5 * 10 * 100 * 100, 1e-8);
        EXPECT_NEAR(cells[1].volume, 2.0 * 100 * 100, 1e-8);
        if (tetrahedra) continue;
        EXPECT_EQ(cells[0].tetrahedra, 24u);  // triangles with an edge on x = 0
        EXPECT_EQ(cells[0].pyramids, 24u);    // those with a corner there
        EXPECT_EQ(cells[0].prisms, 24u * 24 * 2 - 48);
        EXPECT_EQ(cells[1].prisms, 24u * 24 * 2);
        double ground = 0, sides = 0;
        for (const BoundaryFace& face : boundary_faces(mesh)) {
            if (face.side == BoundarySide::Ground) ground += wall_area(mesh, face);
            if (face.side == BoundarySide::Side) sides += wall_area(mesh, face);
        }
        EXPECT_NEAR(ground, 1e4, 1e-8);
        EXPECT_NEAR(sides, 4 * 100 * 2 + 2 * 0.5 * 100 * 10 + 100 * 10, 1e-8);
    }
}

TEST(VolumeMesh, divides_any_numbering_through_the_lowest_points) {
    const std::array<std::array<double, 3>, 6> prism{
        {{0, 0, 0}, {2, 0, 0.3}, {0.4, 1.5, -0.2}, {0, 0, 1}, {2, 0, 1.7}, {0.4, 1.5, 2}}};
    for (const CellKind kind : {CellKind::Prism, CellKind::Pyramid}) {
        const std::size_t corners = corners_of(kind);
        // The pyramid: the quadrangle over the edge 1–2, and corner 0.
        const std::array<std::size_t, 6> shape = kind == CellKind::Prism
                                                     ? std::array<std::size_t, 6>{0, 1, 2, 3, 4, 5}
                                                     : std::array<std::size_t, 6>{1, 4, 5, 2, 0, 0};
        std::vector<std::uint32_t> number(corners);
        std::iota(number.begin(), number.end(), 0u);
        double expected = -1;
        int numberings = 0;
        do {
            ++numberings;
            VolumeMesh mesh;
            mesh.points.resize(corners);
            VolumeCell cell{.kind = kind};
            for (std::size_t i = 0; i < corners; ++i) {
                const auto& p = prism[shape[i]];
                mesh.points[number[i]] = {p[0], p[1], p[2]};
                cell.node[i] = number[i];
            }
            mesh.cells.push_back(cell);
            VolumeMesh divided = mesh;
            divided.cells.clear();
            double sum = 0;
            for (const auto& t : tetrahedra_of(cell)) {
                divided.cells.push_back(
                    {.kind = CellKind::Tetrahedron, .node = {t[0], t[1], t[2], t[3], 0, 0}});
                const double part = cell_quality(divided, divided.cells.back()).volume;
                EXPECT_GT(part, 0);
                sum += part;
            }
            ASSERT_EQ(divided.cells.size(), corners - 3);
            if (expected < 0) expected = sum;
            EXPECT_NEAR(sum, expected, 1e-14);
            divided.column.resize(corners);
            const auto outside = boundary_faces(divided);
            EXPECT_EQ(outside.size(), kind == CellKind::Prism ? 8u : 6u);
            for (const CellFace& face : faces_of(kind)) {
                if (face.corners == 3) continue;
                std::vector<std::uint32_t> quad;
                for (const auto c : face.corner) quad.push_back(cell.node[c]);
                const std::uint32_t least = *std::ranges::min_element(quad);
                int halves = 0;  // both halves have the lowest point
                for (const BoundaryFace& half : outside) {
                    int on = 0;
                    bool has_least = false;
                    for (std::size_t i = 0; i < 3; ++i) {
                        on += std::ranges::count(quad, half.node[i]) > 0;
                        has_least |= half.node[i] == least;
                    }
                    halves += on == 3 && has_least;
                }
                EXPECT_EQ(halves, 2);
            }
        } while (std::ranges::next_permutation(number).found);
        EXPECT_EQ(numberings, kind == CellKind::Prism ? 720 : 120);
    }
}

TEST(CellQuality, knows_regular_cells) {
    VolumeMesh mesh;
    mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const CellQuality regular =
        cell_quality(mesh, {.kind = CellKind::Tetrahedron, .node = {0, 2, 1, 3, 0, 0}});
    EXPECT_NEAR(std::abs(regular.volume), 8.0 / 3, 1e-14);
    mesh.points = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
    const CellQuality turned =
        cell_quality(mesh, {.kind = CellKind::Tetrahedron, .node = {0, 2, 1, 3, 0, 0}});
    const CellQuality& right = regular.volume > 0 ? regular : turned;
    EXPECT_NEAR(right.least_dihedral_deg, std::acos(1.0 / 3) * 180 / M_PI, 1e-12);
    EXPECT_NEAR(right.largest_dihedral_deg, std::acos(1.0 / 3) * 180 / M_PI, 1e-12);
    EXPECT_NEAR(right.aspect, 1, 1e-14);
    const double h = std::sqrt(3) / 2;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0, 0, 2}, {1, 0, 2}, {0.5, h, 2}};
    const CellQuality prism = cell_quality(mesh, {.kind = CellKind::Prism, .node = {0, 1, 2, 3, 4, 5}});
    EXPECT_NEAR(prism.volume, h, 1e-14);
    EXPECT_NEAR(prism.least_dihedral_deg, 60, 1e-12);
    EXPECT_NEAR(prism.largest_dihedral_deg, 90, 1e-12);
    EXPECT_NEAR(prism.aspect, 2 / (2 * std::sqrt(6)) * (h + 6) / (3 * h), 1e-14);
}

TEST(VolumeMesh, leaves_thin_places_to_the_neighbour) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const LayerModel model = random_model(seed);
        for (const bool tetrahedra : {false, true}) {
            const VolumeMesh mesh = volume_mesh(model, {.tetrahedra = tetrahedra, .min_thickness = 1.5});
            boundary_faces(mesh);
            const auto qualities = cell_qualities(mesh);
            double sum = 0, thinnest = 1e300;
            for (const CellQuality& quality : qualities) sum += quality.volume;
            EXPECT_NEAR(sum, envelope_volume(model), 1e-9 * envelope_volume(model));
            std::map<std::uint32_t, std::set<double>> columns;
            for (std::size_t i = 0; i < mesh.points.size(); ++i)
                columns[mesh.column[i]].insert(mesh.points[i].z);
            for (const auto& [column, z] : columns)
                for (auto a = z.begin(), b = std::next(a); b != z.end(); ++a, ++b)
                    if (model.horizons.front()[column] - model.horizons.back()[column] >= 1.5)
                        thinnest = std::min(thinnest, *b - *a);
            EXPECT_GE(thinnest, 1.5);
        }
    }
}

TEST(VolumeMesh, refuses_what_has_no_volume_in_map_coordinates) {
    LayerModel model = grid_model({.cells = 4, .thickness = {constant(1e-7), constant(1)}});
    EXPECT_NO_THROW(volume_mesh(model));
    model.origin = {0, 0, 1e10};
    EXPECT_NO_THROW(volume_mesh(model));
    EXPECT_THROW(volume_mesh(model, {.map_coordinates = true}), GeometryError);
    EXPECT_THROW(volume_mesh(model, {.parts = 0}), InvalidInput);
    EXPECT_THROW(volume_mesh(model, {.max_thickness = -1}), InvalidInput);
    EXPECT_THROW(volume_mesh(model, {.max_thickness = 1e-12}), InvalidInput);
}

TEST(CellFaces, refuses_cells_that_lie_on_the_same_side_of_a_face) {
    VolumeMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
    mesh.column = {0, 1, 2, 0, 0};
    mesh.cells = {{.kind = CellKind::Tetrahedron, .node = {0, 1, 2, 3, 0, 0}},
                  {.kind = CellKind::Tetrahedron, .node = {0, 1, 2, 4, 0, 0}}};
    EXPECT_THROW(boundary_faces(mesh), GeometryError);
}

TEST(VolumeMesh, fills_the_layers_of_real_sets) {
    const std::string shared = STRATAREEB_SOURCE_DIR "/../shared/data/",
                      examples = STRATAREEB_SOURCE_DIR "/examples/";
    const std::vector<std::array<std::string, 2>> sets{
        {examples + "sighthill/intervals.csv", examples + "sighthill/collars.csv"},
        {examples + "thesis_sample3.csv", ""},
        {shared + "thesis/thesis_sample1_wide_noheader.csv", ""},
        {shared + "ags_uk/dlr_city_airport/intervals.csv", shared + "ags_uk/dlr_city_airport/collars.csv"},
        {shared + "llobregat_delta/intervals.csv", shared + "llobregat_delta/collars.csv"}};
    for (const auto& [table, collars] : sets) {
        if (!std::filesystem::exists(table)) continue;  // the sets beside the source tree
        SCOPED_TRACE(table);
        ReadBoreholesOptions read;
        read.collars = collars;
        const LayerModel model = build_layer_model(read_boreholes({table}, read).survey);
        for (const bool tetrahedra : {false, true}) {
            const VolumeMesh mesh = volume_mesh(model, {.tetrahedra = tetrahedra});
            EXPECT_FALSE(boundary_faces(mesh).empty());
            const auto cells = layer_cells(mesh, cell_qualities(mesh));
            const auto volumes = layer_volumes(model);
            for (std::size_t i = 0; i < volumes.size(); ++i)
                EXPECT_NEAR(cells[i].volume, volumes[i], 1e-9 * envelope_volume(model));
        }
    }
}

}  // namespace
}  // namespace stratareeb
