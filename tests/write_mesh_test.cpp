// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_mesh.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>
#include <locale>

#include "boreholes/errors.h"
#include "io/read_mesh.h"
#include "io/write_meshlab_project.h"
#include "mesh/analysis.h"
#include "mesh/normals.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

constexpr const char* kExact[] = {"ply", "obj", "off"};
constexpr const char* kAll[] = {"ply", "obj", "stl", "off", "glb", "3mf"};
constexpr const char* kWithParts[] = {"obj", "glb", "3mf"};

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

PartData part(const TriangleSoup& soup, const std::string& name = "clay", Rgb color = {205, 133, 63}) {
    return {name, color, soup, {}};
}

double largest_distance(const TriangleSoup& a, const TriangleSoup& b) {
    double largest = 0;
    for (std::size_t v = 0; v < a.points.size(); ++v)
        largest =
            std::max({largest, std::abs(a.points[v].x - b.points[v].x),
                      std::abs(a.points[v].y - b.points[v].y), std::abs(a.points[v].z - b.points[v].z)});
    return largest;
}

TEST(WriteMesh, comes_back_bit_by_bit_from_formats_with_doubles) {
    const TemporaryFolder folder;
    auto all = shapes::solids();
    for (auto& shape : shapes::open_surfaces()) all.push_back(shape);
    auto odd = shapes::tetrahedron();
    odd.points = {{1.0 / 3, -1e-310, 1e300},
                  {-0.0, 5e-324, 4999999.123456789},
                  {M_PI, 1e-20, -1e-9},
                  {0.1 + 0.2, 2, 3}};
    all.push_back({"odd numbers", odd});
    for (const auto& shape : all) {
        for (const std::string extension : kExact) {
            const auto file = folder / ("mesh." + extension);
            write_mesh_parts(file, {part(shape.soup)});
            const auto back = read_mesh(file);
            EXPECT_EQ(back.points, shape.soup.points) << shape.name << " " << extension;
            EXPECT_EQ(back.triangles, shape.soup.triangles) << shape.name << " " << extension;
        }
    }
}

TEST(WriteMesh, comes_back_to_float_precision_from_formats_with_floats) {
    const TemporaryFolder folder;
    for (const auto& shape : shapes::solids()) {
        if (shape.name == "far away") continue;
        for (const std::string extension : {"stl", "glb", "3mf"}) {
            SCOPED_TRACE(shape.name + " " + extension);
            const auto file = folder / ("mesh." + extension);
            write_mesh_parts(file, {part(shape.soup)});
            const auto back = read_mesh(file);
            ASSERT_EQ(back.triangles.size(), shape.soup.triangles.size());
            ASSERT_EQ(back.points.size(), shape.soup.points.size());
            if (extension != "stl") {  // which numbers vertices anew
                EXPECT_LT(largest_distance(back, shape.soup), 1e-6);
            }
            const auto report = analyze(back);
            EXPECT_TRUE(report.watertight);
            EXPECT_NEAR(report.volume, volume(shape.soup), 1e-5 * volume(shape.soup));
            EXPECT_EQ(report.genus, analyze(shape.soup).genus);
        }
    }
}

TEST(WriteMesh, glb_and_3mf_keep_millimetres_at_map_coordinates) {
    const TemporaryFolder folder;
    const auto soup =
        shapes::moved(shapes::terrain_solid(20, 1.25, [](double x, double y) { return x * y / 1024; }),
                      500000, 5000000, 100);
    for (const std::string extension : {"glb", "3mf"}) {
        const auto file = folder / ("mesh." + extension);
        write_mesh_parts(file, {part(soup)});
        EXPECT_LT(largest_distance(read_mesh(file), soup), 1e-5) << extension;
    }
}

TEST(WriteMesh, keeps_parts_apart_with_name_and_color) {
    const TemporaryFolder folder;
    const std::vector<PartData> parts{
        part(shapes::cube(), "Sable <fin> & \"gris\" é", {1, 2, 3}),
        part(shapes::moved(shapes::tetrahedron(), 5, 0, 0), "clay", {250, 128, 0}),
        part(shapes::moved(shapes::torus(3, 1, 12, 8), 20, 0, 0), "clay", {0, 0, 255})};
    for (const std::string extension : kWithParts) {
        SCOPED_TRACE(extension);
        const auto file = folder / ("mesh." + extension);
        write_mesh_parts(file, parts);
        const auto back = read_mesh_parts(file);
        ASSERT_EQ(back.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            auto name = parts[i].name;
            if (extension == "obj") std::replace(name.begin(), name.end(), ' ', '_');
            EXPECT_EQ(back[i].name, name);
            EXPECT_EQ(back[i].color, parts[i].color);
            EXPECT_NEAR(volume(back[i].soup), volume(parts[i].soup), 1e-4);
            EXPECT_TRUE(analyze(back[i].soup).watertight);
        }
    }
    for (const std::string extension : kAll) {  // and as one mesh, in every format
        const auto file = folder / ("all." + extension);
        write_mesh_parts(file, parts);
        const auto report = analyze(read_mesh(file));
        EXPECT_EQ(report.components, 3u) << extension;
        EXPECT_TRUE(report.watertight) << extension;
    }
}

TEST(WriteMesh, ply_has_the_header_that_is_promised) {
    const TemporaryFolder folder;
    const auto mesh = half_edge_mesh(shapes::tetrahedron());
    write_mesh(folder / "a.ply", {.name = "clay", .color = "#ff8000", .mesh = &mesh});
    const auto content = content_of(folder / "a.ply");
    EXPECT_EQ(content.substr(0, content.find("end_header")),
              "ply\nformat binary_little_endian 1.0\ncomment Stratareeb\nelement vertex 4\n"
              "property double x\nproperty double y\nproperty double z\n"
              "property double nx\nproperty double ny\nproperty double nz\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\n"
              "element face 4\nproperty list uchar int vertex_indices\n");
    EXPECT_EQ(content.size(), content.find("end_header\n") + 11 + 4 * 51 + 4 * 13);
    EXPECT_EQ(read_mesh_parts(folder / "a.ply")[0].color, (Rgb{255, 128, 0}));
}

TEST(WriteMesh, writes_the_normals_of_the_mesh_or_computes_them) {
    const TemporaryFolder folder;
    auto mesh = half_edge_mesh(shapes::cube());
    const MeshPart part{.name = "clay", .color = "", .mesh = &mesh};
    write_mesh(folder / "computed.ply", part);
    update_vertex_normals(mesh);
    write_mesh(folder / "uniform.ply", part);
    for (const auto v : mesh.vertices()) mesh.set_normal(v, {0, 1, 0});
    write_mesh(folder / "own.ply", part);
    EXPECT_EQ(content_of(folder / "computed.ply"), content_of(folder / "uniform.ply"));
    EXPECT_NE(content_of(folder / "own.ply"), content_of(folder / "uniform.ply"));
}

TEST(WriteMesh, glb_is_read_by_tinygltf_as_it_was_meant) {
    const TemporaryFolder folder;
    write_mesh_parts(folder / "a.glb",
                     {part(shapes::slab(3, 2, 1), "clay", {255, 0, 255}), part(TriangleSoup{}, "empty"),
                      part(shapes::moved(shapes::cube(), 9, 9, 9), "sand")});
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error, warning;
    ASSERT_TRUE(loader.LoadBinaryFromFile(&model, &error, &warning, (folder / "a.glb").string())) << error;
    EXPECT_EQ(warning, "");
    ASSERT_EQ(model.nodes.size(), 4u);
    EXPECT_EQ(model.nodes[0].children, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(model.nodes[1].name, "clay");
    EXPECT_EQ(model.nodes[2].mesh, -1);  // glTF has no empty meshes
    ASSERT_EQ(model.meshes.size(), 2u);
    const auto& primitive = model.meshes[1].primitives.at(0);
    const auto& positions = model.accessors[primitive.attributes.at("POSITION")];
    EXPECT_EQ(positions.count, 8u);
    // y up: our z from 9 to 10 is height after the root's matrix, which maps the local z axis to y.
    const auto& m = model.nodes[0].matrix;
    ASSERT_EQ(m.size(), 16u);
    EXPECT_EQ(m[2 * 4 + 1], 1.0);
    EXPECT_EQ(positions.minValues[2] + m[13], 9.0);
    EXPECT_EQ(positions.maxValues[2] + m[13], 10.0);
    EXPECT_FALSE(model.materials[0].doubleSided);
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorFactor, (std::vector<double>{1, 0, 1, 1}));
}

TEST(WriteMesh, stl_leaves_out_what_collapses_and_stays_closed) {
    const TemporaryFolder folder;
    // Cells a tenth of a float's step wide at northing 5,000,000 next to cells of many steps.
    auto soup = shapes::terrain_solid(3, 2, [](double, double) { return 0.0; });
    for (auto& p : soup.points) p = {p.x == 1 ? 0.01 : p.x, p.y + 5000000, p.z};
    for (auto& p : soup.points) p.x += 5000000;
    ASSERT_TRUE(analyze(soup).watertight);
    write_mesh_parts(folder / "a.stl", {part(soup)});
    const auto back = read_mesh(folder / "a.stl");
    EXPECT_LT(back.triangles.size(), soup.triangles.size());
    const auto report = analyze(back);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.degenerate_triangles, 0u);
    EXPECT_NEAR(report.volume, 18, 1e-9);
}

TEST(WriteMesh, writes_the_same_bytes_every_time) {
    const TemporaryFolder folder;
    for (const std::string extension : kAll) {
        const auto a = folder / ("a." + extension), b = folder / ("a2." + extension);
        write_mesh_parts(a, {part(shapes::torus(3, 1, 12, 8)), part(shapes::cube(), "sand")});
        const auto first = content_of(a);
        write_mesh_parts(a, {part(shapes::torus(3, 1, 12, 8)), part(shapes::cube(), "sand")});
        EXPECT_EQ(content_of(a), first) << extension;
    }
}

TEST(WriteMesh, is_the_same_in_a_locale_with_decimal_commas) {
    const TemporaryFolder folder;
    const auto previous = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    for (const std::string extension : kAll) {
        write_mesh_parts(folder / ("a." + extension), {part(shapes::uv_sphere(1, 8, 8))});
        EXPECT_TRUE(analyze(read_mesh(folder / ("a." + extension))).watertight) << extension;
    }
    std::locale::global(previous);
}

TEST(WriteMesh, takes_empty_and_non_manifold_meshes) {
    const TemporaryFolder folder;
    auto wing = shapes::tetrahedron();
    wing.points.push_back({5, 5, 5});
    wing.triangles.push_back({0, 1, 4});
    for (const std::string extension : kAll) {
        write_mesh_parts(folder / ("wing." + extension), {part(wing)});
        EXPECT_EQ(analyze(read_mesh(folder / ("wing." + extension))).non_manifold_edges, 1u) << extension;
        EXPECT_NO_THROW(write_mesh_parts(folder / ("none." + extension), {})) << extension;
        EXPECT_NO_THROW(write_mesh_parts(folder / ("empty." + extension), {part({})})) << extension;
    }
    for (const std::string extension : {"ply", "stl", "off", "glb"})
        EXPECT_TRUE(read_mesh(folder / ("empty." + extension)).triangles.empty()) << extension;
}

TEST(WriteMesh, refuses_unknown_formats_and_colors_and_keeps_the_old_file) {
    const TemporaryFolder folder;
    const auto mesh = half_edge_mesh(shapes::cube());
    EXPECT_THROW(write_mesh(folder / "a.dae", {.name = "a", .color = "", .mesh = &mesh}), IoError);
    EXPECT_THROW(write_mesh(folder / "missing/a.ply", {.name = "a", .color = "", .mesh = &mesh}), IoError);
    folder.file("a.ply", "old");
    for (const char* color : {"red", "#12345", "#1234567", "#12345g", "123456", "#-12345"})
        EXPECT_THROW(write_mesh(folder / "a.ply", {.name = "a", .color = color, .mesh = &mesh}), InvalidInput)
            << color;
    EXPECT_EQ(content_of(folder / "a.ply"), "old");
    EXPECT_EQ(text_from_rgb(rgb_from_text("#0aFf10")), "#0aff10");
}

TEST(WriteMesh, extension_decides_in_upper_case_too) {
    const TemporaryFolder folder;
    write_mesh_parts(folder / "A.STL", {part(shapes::cube())});
    EXPECT_EQ(content_of(folder / "A.STL").size(), 84u + 12 * 50);
    EXPECT_TRUE(analyze(read_mesh(folder / "A.STL")).watertight);
}

TEST(WriteMeshlabProject, lists_meshes_with_escaped_names) {
    const TemporaryFolder folder;
    write_meshlab_project(folder / "model.mlp",
                          {{"Clay & <sand>", "layers/01_clay.ply"}, {"\"b\"", "layers/02_b.ply"}});
    const auto content = content_of(folder / "model.mlp");
    EXPECT_NE(content.find("label=\"Clay &amp; &lt;sand&gt;\" filename=\"layers/01_clay.ply\""),
              std::string::npos);
    EXPECT_NE(content.find("label=\"&quot;b&quot;\""), std::string::npos);
}

}  // namespace
}  // namespace stratareeb
