// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "boreholes/errors.h"
#include "io/write_mesh.h"
#include "mesh/analysis.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace stratareeb {
namespace {

class ReadMesh : public testing::Test {
 protected:
    TriangleSoup read(const std::string& name, const std::string& content) {
        return read_mesh(folder_.file(name, content));
    }
    std::string refusal(const std::string& name, const std::string& content) {
        try {
            read(name, content);
        } catch (const InvalidInput& error) {
            return error.what();
        } catch (const IoError& error) {
            return error.what();
        }
        return "accepted";
    }
    void expect_refusal(const std::string& name, const std::string& content, const std::string& words) {
        EXPECT_NE(refusal(name, content).find(words), std::string::npos) << refusal(name, content);
    }
    TemporaryFolder folder_;
};

template <class T>
std::string bytes(T value, bool big) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    return {raw.data(), raw.size()};
}

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 5\nproperty float x\nproperty float y\n"
    "property float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kPyramid =
    "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

TEST_F(ReadMesh, ply_in_text_with_polygons) {
    const auto report = analyze(read("a.ply", kPlyHeader + kPyramid));
    EXPECT_EQ(report.triangles, 6u);
    EXPECT_TRUE(report.watertight);
    EXPECT_NEAR(report.volume, 4.0, 1e-12);
    std::string crlf = kPlyHeader + kPyramid;
    for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2) crlf.insert(at, "\r");
    EXPECT_TRUE(analyze(read("crlf.ply", crlf)).watertight);
}

TEST_F(ReadMesh, ply_binary_of_both_byte_orders_any_property_order_and_extra_elements) {
    for (const bool big : {false, true}) {
        std::string content =
            std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
            " 1.0\nelement camera 1\nproperty list ushort float shutter\nproperty int8 id\n"
            "element vertex 4\nproperty uint8 flags\nproperty float64 z\nproperty short y\n"
            "property list uint32 double weights\nproperty float x\n"
            "element face 4\nproperty int material\nproperty list uint16 ushort vertex_index\n"
            "property uchar red\nelement edge 1\nproperty int v1\nend_header\n";
        content +=
            bytes<std::uint16_t>(2, big) + bytes(1.0f, big) + bytes(2.0f, big) + bytes<std::int8_t>(-3, big);
        const auto soup = shapes::tetrahedron();
        for (const auto& p : soup.points)
            content += bytes<std::uint8_t>(9, big) + bytes(p.z, big) +
                       bytes(static_cast<std::int16_t>(p.y), big) + bytes<std::uint32_t>(1, big) +
                       bytes(0.5, big) + bytes(static_cast<float>(p.x), big);
        for (const auto& t : soup.triangles) {
            content += bytes<std::int32_t>(-7, big) + bytes<std::uint16_t>(3, big);
            for (const auto v : t) content += bytes(static_cast<std::uint16_t>(v), big);
            content += bytes<std::uint8_t>(255, big);
        }
        content += bytes<std::int32_t>(1, big);
        const auto back = read("a.ply", content);
        EXPECT_EQ(back.points, soup.points);
        EXPECT_EQ(back.triangles, soup.triangles);
    }
}

TEST_F(ReadMesh, obj_with_relative_indices_polygons_and_comments) {
    const auto soup =
        read("a.obj",
             "# a cube\nmtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 1.0\nv 0 0 1\nv 1 0 1\n"
             "v 1 1 1\nv 0 1 +1\nvt 0 0\nvn 0 0 1\ns off\ng bottom\nf 4 3 2 1\ng rest\nusemtl red\n"
             "f -4/1 -3/1 -2/1 -1/1\nf 1//1 2//1 6//1 5//1\nf 2/1/1 3/1/1 \\\n 7/1/1 6/1/1 # end\n"
             "f 3 4 8 7\nf 4 1 5 8\nl 1 2\n");
    const auto report = analyze(soup);
    EXPECT_TRUE(report.watertight);
    EXPECT_NEAR(report.volume, 1.0, 1e-15);
}

TEST_F(ReadMesh, obj_objects_are_parts_with_their_colors) {
    folder_.file("a.mtl", "newmtl clay\nKa 0 0 0\nKd 1 0.5019608 0\n");
    const auto parts = read_mesh_parts(folder_.file("a.obj",
                                                    "mtllib a.mtl\no one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl "
                                                    "clay\nf 1 2 3\no two words\nv 5 5 5\nf 4 2 1\n"));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "one");
    EXPECT_EQ(parts[0].color, (Rgb{255, 128, 0}));
    EXPECT_EQ(parts[1].name, "two words");
    EXPECT_EQ(parts[1].soup.points.size(), 3u);  // vertices of the whole file, as far as used
    EXPECT_EQ(parts[1].soup.points[2], (Point3{5, 5, 5}));
}

TEST_F(ReadMesh, stl_in_text_is_welded) {
    std::string content = "solid tetrahedron with a name\n";
    const auto soup = shapes::tetrahedron();
    for (const auto& t : soup.triangles) {
        content += "  facet normal 0 0 1\n    outer loop\n";
        for (const auto v : t)
            content += "      VERTEX " + std::to_string(soup.points[v].x) + " " +
                       std::to_string(soup.points[v].y) + " " + (soup.points[v].z == 0 ? "-0e5" : "1.0E+00") +
                       "\n";
        content += "    endloop\n  endfacet\n";
    }
    const auto back = read("a.stl", content + "endsolid\n");
    EXPECT_EQ(back.points.size(), 4u);  // -0 is 0
    EXPECT_TRUE(analyze(back).watertight);
}

TEST_F(ReadMesh, stl_binary_that_begins_with_solid) {
    write_mesh_parts(folder_ / "a.stl", {{"a", {}, shapes::cube(), {}}});
    auto content = content_of(folder_ / "a.stl");
    content.replace(0, 5, "solid");
    EXPECT_TRUE(analyze(read("b.stl", content)).watertight);
}

TEST_F(ReadMesh, off_with_colors_normals_and_comments) {
    EXPECT_TRUE(analyze(read("a.off", "OFF # pyramid\n\n5 5 8\n" + kPyramid)).watertight);
    EXPECT_TRUE(analyze(read("b.off", "OFF 5 5 8\n" + kPyramid)).watertight);
    const auto rich =
        read("c.off",
             "CNOFF\n# x y z nx ny nz r g b a\n4 4 6\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 1 1 1 1\n"
             "0 1 0 0 0 1 0 0 0 0\n# between\n0 0 1 0 0 1 0 0 0 0\n3 0 2 1 0.5 0.5 0.5\n3 0 1 3\n3 1 2 3 # "
             "face\n3 2 0 3\n");
    EXPECT_NEAR(analyze(rich).volume, 1.0 / 6, 1e-15);
    EXPECT_TRUE(analyze(rich).watertight);
}

// A GLB file from its JSON and binary parts.
std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto number = [](std::size_t value) { return bytes(static_cast<std::uint32_t>(value), false); };
    return "glTF" + number(2) + number(28 + json.size() + binary.size()) + number(json.size()) + "JSON" +
           json + number(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::string tetrahedron_positions() {
    std::string result;
    for (const auto& p : shapes::tetrahedron().points)
        result += bytes(static_cast<float>(p.x), false) + bytes(static_cast<float>(p.y), false) +
                  bytes(static_cast<float>(p.z), false);
    return result;
}

const std::string kGlbMesh =
    R"("asset":{"version":"2.0"},"buffers":[{"byteLength":60}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                 {"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],
    "meshes":[{"name":"tetra","primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";

const std::string kTetrahedronIndices{"\0\2\1\0\1\3\1\2\3\2\0\3", 12};

TEST_F(ReadMesh, glb_applies_the_transformations_of_all_nodes) {
    const auto content = glb("{" + kGlbMesh + R"(,"scenes":[{"nodes":[0,2]}],"nodes":[
        {"translation":[10,0,0],"scale":[2,2,2],"children":[1]},
        {"mesh":0,"name":"big","rotation":[0,0.7071067811865476,0,0.7071067811865476]},
        {"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,-5,0,1]}]})",
                             tetrahedron_positions() + kTetrahedronIndices);
    const auto parts = read_mesh_parts(folder_.file("a.glb", content));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "big");
    EXPECT_EQ(parts[1].name, "tetra");
    EXPECT_NEAR(volume(parts[0].soup), 8.0 / 6, 1e-12);
    EXPECT_NEAR(volume(parts[1].soup), 1.0 / 6,
                1e-12);  // a mirror turns triangles over; they are turned back
    // (1,0,0) turned a quarter around y is (0,0,-1), twice as large and moved by 10: (10,0,-2); with z up
    // (10,2,0).
    EXPECT_NEAR(parts[0].soup.points[1].x, 10, 1e-12);
    EXPECT_NEAR(parts[0].soup.points[1].y, 2, 1e-12);
    EXPECT_NEAR(parts[0].soup.points[1].z, 0, 1e-12);
    EXPECT_EQ(parts[1].soup.points[1], (Point3{-1, 0, -5}));
}

TEST_F(ReadMesh, glb_that_asks_for_too_much_is_refused) {
    const auto binary = tetrahedron_positions() + kTetrahedronIndices;
    const auto with = [&](const std::string& json) { return glb(json, binary); };
    const std::string scene = R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}]})";
    expect_refusal("loop.glb",
                   with("{" + kGlbMesh + R"(,"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]})"),
                   "ancestor");
    expect_refusal("node.glb", with("{" + kGlbMesh + R"(,"scenes":[{"nodes":[7]}]})"),
                   "nodes[7] does not exist");
    auto json = "{" + kGlbMesh + scene;
    const auto changed = [&](const std::string& from, const std::string& to) {
        auto copy = json;
        copy.replace(copy.find(from), from.size(), to);
        return with(copy);
    };
    EXPECT_EQ(refusal("fine.glb", with(json)), "accepted");
    expect_refusal("a.glb", changed("\"count\":4", "\"count\":4000000000"), "reaches to byte");
    expect_refusal("b.glb", changed("\"count\":4", "\"count\":-4"), "whole number");
    expect_refusal("c.glb", changed("\"count\":4", "\"count\":3"), "vertex index 3 is out of range");
    expect_refusal("d.glb", changed("\"byteOffset\":48", "\"byteOffset\":49"), "reaches to byte");
    expect_refusal("e.glb", changed("\"byteOffset\":48", "\"byteOffset\":18446744073709551615"),
                   "whole number");
    expect_refusal("f.glb", changed("\"POSITION\":0", "\"POSITION\":9"), "accessors[9] does not exist");
    expect_refusal("g.glb", changed("\"mesh\":0", "\"mesh\":\"x\""), "whole number");
    expect_refusal("h.glb", changed("5126", "5130"), "component type");
    expect_refusal("i.glb", changed("\"byteLength\":60", "\"uri\":\"x.bin\""), "outside the file");
    expect_refusal("j.glb", with("{"), "JSON chunk is damaged");
    expect_refusal("k.glb", with(std::string(100000, '[')), "JSON chunk is damaged");
    expect_refusal("l.glb", glb(json, tetrahedron_positions()), "reaches to byte");
}

TEST_F(ReadMesh, damaged_ply_is_refused_with_its_place) {
    expect_refusal("a.ply", "", "a.ply:1: not a PLY file");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\n", "does not end");
    expect_refusal("a.ply", "ply\nformat binary_middle_endian 1.0\nend_header\n",
                   "a.ply:2: unknown PLY format");
    expect_refusal("a.ply", "ply\nend_header\n", "names no format");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
                   "before the first element");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", "negative");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty number x\nend_header\n",
                   "property type");
    expect_refusal(
        "a.ply",
        "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
        "before the vertices");
    expect_refusal(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
        "x, y and z once each");
    const auto edited = [&](const std::string& from, const std::string& to) {
        auto body = kPyramid;
        body.replace(body.find(from), from.size(), to);
        return kPlyHeader + body;
    };
    expect_refusal("a.ply", edited("1 1 3", "1 x 3"), "a.ply:15: 'x' is not a finite number");
    expect_refusal("a.ply", edited("1 1 3", "1 nan 3"), "a.ply:15: 'nan' is not a finite number");
    expect_refusal("a.ply", edited("1 1 3", "1 1e999 3"), "not a finite number");
    expect_refusal("a.ply", edited("3 0 1 4", "3 0 1 5"),
                   "a.ply:17: vertex index 5 is out of range; there are 5");
    expect_refusal("a.ply", edited("3 0 1 4", "3 0 1 -1"), "out of range");
    expect_refusal("a.ply", edited("3 0 1 4", "2 0 1"), "face 1 has 2 corners");
    expect_refusal("a.ply", edited("3 3 0 4", "3 3 0"), "ends in the middle");
    expect_refusal("a.ply", edited("3 3 0 4", "1000000000 3 0 4"), "does not fit");
}

TEST_F(ReadMesh, huge_counts_without_data_take_neither_memory_nor_time) {
    const std::string count = "4000000000";
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        const auto head = "ply\nformat " + format + " 1.0\nelement ";
        expect_refusal(
            "a.ply",
            head + "vertex " + count + "\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
            "ends in the middle");
        EXPECT_NE(refusal("a.ply", head + "nothing 9000000000000000000\nend_header\n"), "accepted");
    }
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nend_header\n",
                   "whole number");
    expect_refusal("a.off", "OFF\n" + count + " " + count + " 0\n0 0 0\n", "a.off:4: the file ends");
    expect_refusal("a.stl", std::string(80, ' ') + bytes(4000000000u, false), "cut off or no STL");
}

TEST_F(ReadMesh, damaged_text_formats_are_refused_with_their_line) {
    expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
                   "a.obj:4: vertex index 4 is out of range");
    expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "a.obj:4: vertex index 0");
    expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 2 1\n", "vertex index -4");
    expect_refusal("a.obj", "v 0 0\n", "a.obj:1: a number is missing");
    expect_refusal("a.obj", "v 0 0 1,5\n", "'1,5' is not a finite number");
    expect_refusal("a.obj", "v 0 0 0\nf 1 1\n", "a face with 2 corners");
    expect_refusal("a.obj", "", "there are no vertices");
    expect_refusal("a.obj", std::string("\x01\x02\x03\0\xff", 5), "not a line of an OBJ file");
    expect_refusal("a.off", "PLY\n", "does not begin with 'OFF'");
    expect_refusal("a.off", "4OFF\n", "three dimensions");
    expect_refusal("a.off", "OFF BINARY\n", "binary OFF");
    expect_refusal("a.off", "OFF\n1 1 0\n0 0 inf\n", "a.off:3: 'inf' is not a finite number");
    expect_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6: vertex index 3");
    expect_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n99999999999 0 1 2\n",
                   "whole number is missing");
    expect_refusal("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n",
                   "a facet with 1");
    expect_refusal("a.stl", "solid a\nvertex 0 0 0\nvertex 0 0 0\n", "middle of a facet");
    expect_refusal("a.stl", "solid a\nhello\n", "a.stl:2: unknown line");
    expect_refusal("a.stl", "hello\n", "neither binary");
    expect_refusal("a.3mf", "no archive at all", "not a sound 3MF file");
}

TEST_F(ReadMesh, coordinates_in_a_binary_file_must_be_finite) {
    write_mesh_parts(folder_ / "a.stl", {{"a", {}, shapes::cube(), {}}});
    auto stl = content_of(folder_ / "a.stl");
    stl.replace(84 + 50 + 12, 4, bytes(std::numeric_limits<float>::quiet_NaN(), false));
    expect_refusal("b.stl", stl, "triangle 1 (byte 134) has a coordinate that is not a finite number");
    write_mesh_parts(folder_ / "a.ply", {{"a", {}, shapes::cube(), {}}});
    auto ply = content_of(folder_ / "a.ply");
    ply.replace(ply.find("end_header\n") + 11 + 51, 8, bytes(std::numeric_limits<double>::infinity(), false));
    expect_refusal("b.ply", ply, "vertex 1 has a coordinate that is not a finite number");
}

TEST_F(ReadMesh, missing_files_folders_and_unknown_formats_are_named) {
    EXPECT_THROW(read_mesh(folder_ / "missing.ply"), IoError);
    EXPECT_THROW(read_mesh(folder_ / "a.docx"), IoError);
    EXPECT_THROW(read_mesh(folder_ / "noextension"), IoError);
    std::filesystem::create_directory(folder_ / "folder.ply");
    EXPECT_THROW(read_mesh(folder_ / "folder.ply"), IoError);
}

// Cut off at every length, and with random bytes changed: a result or an error of ours, nothing else.
TEST_F(ReadMesh, survives_any_damage) {
    std::mt19937 random(5);
    for (const std::string extension : {"ply", "obj", "stl", "off", "glb", "3mf"}) {
        const auto file = folder_ / ("good." + extension);
        write_mesh_parts(
            file, {{"a", {1, 2, 3}, shapes::wedge(3, 2, 1), {}}, {"b", {4, 5, 6}, shapes::cube(), {}}});
        const auto good = content_of(file);
        for (std::size_t length = 0; length < good.size(); length += 1 + length / 40)
            refusal("cut." + extension, good.substr(0, length));
        for (int trial = 0; trial < 300; ++trial) {
            auto bad = good;
            for (int change = 0; change < 1 + trial % 8; ++change) {
                const auto at = random() % bad.size();
                switch (random() % 4) {
                    case 0:
                        bad[at] = static_cast<char>(random());
                        break;
                    case 1:
                        bad[at] = static_cast<char>(bad[at] ^ (1 << random() % 8));
                        break;
                    case 2:
                        bad.erase(at, 1 + random() % 20);
                        break;
                    default:
                        bad.insert(at, bad.substr(random() % bad.size(), random() % 20));
                }
                if (bad.empty()) bad += 'x';
            }
            refusal("bad." + extension, bad);
        }
    }
}

}  // namespace
}  // namespace stratareeb
