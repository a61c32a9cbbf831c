// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_glb.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "boreholes/errors.h"
#include "io/gltf.h"
#include "io/text_scanner.h"
#include "io/weld.h"

namespace stratareeb {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMostTriangles =
    200'000'000;  // what nodes may add up to by using a mesh again and again

class GlbReader {
 public:
    GlbReader(std::string file, std::string_view content) : file_(std::move(file)), content_(content) {}

    std::vector<PartData> parts() {
        split_chunks();
        visited_.assign(list("nodes").size(), false);
        if (document_.contains("scenes")) {
            const auto& scene = item("scenes", number_or(document_, "scene", 0));
            if (scene.contains("nodes"))
                for (const auto& node : scene.at("nodes")) visit(whole(node), Eigen::Affine3d::Identity(), 0);
        } else {
            for (std::size_t mesh = 0; mesh < list("meshes").size(); ++mesh)
                add_part("", mesh, Eigen::Affine3d::Identity());
        }
        return std::move(parts_);
    }

 private:
    [[noreturn]] void fail(const std::string& message) const { throw InvalidInput(file_ + ": " + message); }

    // The file: header, a JSON chunk, and a binary chunk unless there is no geometry.
    void split_chunks() {
        if (content_.size() < 20 || u32(content_, 0) != gltf::kMagic)
            fail("not a GLB file: it does not begin with 'glTF'");
        if (u32(content_, 4) != 2)
            fail(fmt::format("glTF version {} is not read (expected 2)", u32(content_, 4)));
        const std::uint64_t text_size = u32(content_, 12);
        if (u32(content_, 16) != gltf::kJsonChunk || 20 + text_size > content_.size())
            fail("byte 12: the JSON chunk is damaged or cut off");
        document_ = json::parse(content_.substr(20, text_size));
        if (!document_.is_object()) fail("the JSON chunk is not an object");
        const auto rest = content_.substr(20 + text_size);
        if (rest.size() < 8) return;
        if (u32(rest, 4) != gltf::kBinaryChunk || 8 + std::uint64_t{u32(rest, 0)} > rest.size())
            fail(fmt::format("byte {}: the binary chunk is damaged or cut off", 20 + text_size));
        binary_ = rest.substr(8, u32(rest, 0));
    }

    static std::uint32_t u32(std::string_view bytes, std::size_t at) {
        return little_endian<std::uint32_t>(bytes, at);
    }

    template <class T>
    static T little_endian(std::string_view bytes, std::size_t at) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
        if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }

    const json& list(const char* name) const {
        static const json nothing = json::array();
        const auto found = document_.find(name);
        if (found == document_.end()) return nothing;
        if (!found->is_array()) fail(fmt::format("'{}' is not a list", name));
        return *found;
    }

    const json& item(const char* name, std::uint64_t index) const {
        if (index >= list(name).size())
            fail(fmt::format("{}[{}] does not exist; there are {}", name, index, list(name).size()));
        return list(name)[index];
    }

    std::uint64_t whole(const json& value) const {
        if (!value.is_number_unsigned() ||
            value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
            fail(fmt::format("'{}' stands where a whole number is expected", value.dump().substr(0, 40)));
        return value.get<std::uint64_t>();
    }
    std::uint64_t number(const json& object, const char* key) const { return whole(object.at(key)); }
    std::uint64_t number_or(const json& object, const char* key, std::uint64_t otherwise) const {
        return object.contains(key) ? number(object, key) : otherwise;
    }

    // glTF nodes are a tree; a node seen twice would let a small file unfold without end.
    void visit(std::uint64_t index, const Eigen::Affine3d& above, int depth) {
        const auto& node = item("nodes", index);
        if (visited_[index] || depth > 200)
            fail(fmt::format("nodes[{}] is its own ancestor or has two parents", index));
        visited_[index] = true;
        const Eigen::Affine3d here = above * transform(node);
        if (node.contains("mesh")) add_part(node.value("name", ""), number(node, "mesh"), here);
        if (node.contains("children"))
            for (const auto& child : node.at("children")) visit(whole(child), here, depth + 1);
    }

    std::vector<double> numbers(const json& values, std::size_t n) const {
        auto result = values.get<std::vector<double>>();
        if (result.size() != n)
            fail(fmt::format("a transformation with {} numbers (expected {})", result.size(), n));
        return result;
    }

    Eigen::Affine3d transform(const json& node) const {
        Eigen::Affine3d result = Eigen::Affine3d::Identity();
        if (node.contains("matrix")) {
            const auto m = numbers(node.at("matrix"), 16);
            result.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
            return result;
        }
        if (node.contains("translation")) {
            const auto t = numbers(node.at("translation"), 3);
            result.translate(Eigen::Vector3d(t[0], t[1], t[2]));
        }
        if (node.contains("rotation")) {
            const auto q = numbers(node.at("rotation"), 4);
            result.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
        }
        if (node.contains("scale")) {
            const auto s = numbers(node.at("scale"), 3);
            result.scale(Eigen::Vector3d(s[0], s[1], s[2]));
        }
        return result;
    }

    void add_part(std::string name, std::uint64_t index, const Eigen::Affine3d& place) {
        const auto& mesh = item("meshes", index);
        PartData part;
        part.name = name.empty() ? mesh.value("name", "") : std::move(name);
        bool colored = false;
        for (const auto& primitive : mesh.at("primitives")) {
            if (!add_primitive(primitive, place, part.soup) || colored) continue;
            part.color = color(primitive);
            colored = true;
        }
        if (place.linear().determinant() < 0)  // a mirror turns the winding over
            for (auto& t : part.soup.triangles) std::swap(t[1], t[2]);
        weld(part.soup);
        parts_.push_back(std::move(part));
    }

    // Bytes of an accessor, checked to lie in the file.
    struct Numbers {
        const char* data = nullptr;
        std::size_t count = 0, stride = 0;
        int type = 0;
    };

    Numbers accessor(std::uint64_t index, const char* shape, std::size_t components) const {
        const auto& a = item("accessors", index);
        if (!a.contains("bufferView") || a.contains("sparse"))
            fail(fmt::format("accessors[{}] is sparse or compressed, which is not read; export it plain",
                             index));
        if (a.at("type") != shape) fail(fmt::format("accessors[{}] is not of type {}", index, shape));
        const auto& view = item("bufferViews", number(a, "bufferView"));
        if (number(view, "buffer") != 0 || item("buffers", 0).contains("uri"))
            fail("geometry outside the file is not read; export it as one GLB");
        Numbers n;
        n.count = number(a, "count");
        n.type = static_cast<int>(number(a, "componentType"));
        const std::uint64_t size = components * component_size(n.type);
        n.stride = number_or(view, "byteStride", size);
        const auto begin = number_or(view, "byteOffset", 0) + number_or(a, "byteOffset", 0);
        const auto end = n.count == 0 ? begin : begin + (n.count - 1) * n.stride + size;
        if (n.stride < size || end > binary_.size())
            fail(fmt::format("accessors[{}] reaches to byte {} of {} binary bytes", index, end,
                             binary_.size()));
        n.data = binary_.data() + begin;
        return n;
    }

    std::uint64_t component_size(int type) const {
        if (type == gltf::kUnsignedByte || type == 5120) return 1;
        if (type == gltf::kUnsignedShort || type == 5122) return 2;
        if (type == gltf::kUnsignedInt || type == gltf::kFloat) return 4;
        fail(fmt::format("unknown component type {}", type));
    }

    // Append the triangles of a primitive; false if it has none (points, lines).
    bool add_primitive(const json& primitive, const Eigen::Affine3d& place, TriangleSoup& soup) {
        const auto mode = number_or(primitive, "mode", gltf::kTriangles);
        if (mode != gltf::kTriangles && mode != gltf::kTriangleStrip && mode != gltf::kTriangleFan)
            return false;
        const auto positions = accessor(number(primitive.at("attributes"), "POSITION"), "VEC3", 3);
        if (positions.type != gltf::kFloat) fail("quantized positions are not read; export them as floats");
        const auto offset = soup.points.size();
        append_points(positions, place, soup);
        const auto corners = corner_indices(primitive, positions.count);
        triangles_ += corners.size() / 3;
        if (triangles_ > kMostTriangles) fail("the nodes unfold to more triangles than are read");
        append_triangles(corners, static_cast<int>(mode), static_cast<std::uint32_t>(offset), soup);
        return true;
    }

    // glTF's y is up, ours is z.
    void append_points(const Numbers& positions, const Eigen::Affine3d& place, TriangleSoup& soup) const {
        const std::string_view bytes(
            positions.data, positions.count == 0 ? 0 : (positions.count - 1) * positions.stride + 12);
        for (std::size_t i = 0; i < positions.count; ++i) {
            Eigen::Vector3d p;
            for (int k = 0; k < 3; ++k)
                p[k] = double{little_endian<float>(bytes, i * positions.stride + 4 * k)};
            p = place * p;
            if (!p.allFinite())
                fail(fmt::format("vertex {} has a coordinate that is not a finite number", i));
            soup.points.push_back({p.x(), -p.z(), p.y()});
        }
    }

    std::vector<std::uint32_t> corner_indices(const json& primitive, std::size_t vertices) const {
        std::vector<std::uint32_t> corners;
        if (!primitive.contains("indices")) {
            for (std::uint32_t i = 0; i < vertices; ++i) corners.push_back(i);
            return corners;
        }
        const auto n = accessor(number(primitive, "indices"), "SCALAR", 1);
        const auto size = component_size(n.type);
        const std::string_view bytes(n.data, n.count == 0 ? 0 : (n.count - 1) * n.stride + size);
        for (std::size_t i = 0; i < n.count; ++i) {
            const auto at = i * n.stride;
            const std::uint32_t v = size == 1   ? little_endian<std::uint8_t>(bytes, at)
                                    : size == 2 ? little_endian<std::uint16_t>(bytes, at)
                                                : little_endian<std::uint32_t>(bytes, at);
            if (v >= vertices)
                fail(fmt::format("vertex index {} is out of range; there are {} vertices", v, vertices));
            corners.push_back(v);
        }
        return corners;
    }

    static void append_triangles(const std::vector<std::uint32_t>& c, int mode, std::uint32_t offset,
                                 TriangleSoup& soup) {
        const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
            soup.triangles.push_back({c[i] + offset, c[j] + offset, c[k] + offset});
        };
        if (mode == gltf::kTriangles)
            for (std::uint32_t i = 0; i + 2 < c.size(); i += 3) add(i, i + 1, i + 2);
        if (mode == gltf::kTriangleStrip)
            for (std::uint32_t i = 0; i + 2 < c.size(); ++i)
                i % 2 == 0 ? add(i, i + 1, i + 2) : add(i, i + 2, i + 1);
        if (mode == gltf::kTriangleFan)
            for (std::uint32_t i = 1; i + 1 < c.size(); ++i) add(0, i, i + 1);
    }

    Rgb color(const json& primitive) const {
        if (!primitive.contains("material")) return PartData{}.color;
        const auto factor =
            item("materials", number(primitive, "material"))
                .value(json::json_pointer("/pbrMetallicRoughness/baseColorFactor"), json::array());
        if (factor.size() < 3) return PartData{}.color;
        Rgb result;
        for (int k = 0; k < 3; ++k) result[k] = gltf::srgb(factor[k].get<double>());
        return result;
    }

    std::string file_;
    std::string_view content_, binary_;
    json document_;
    std::vector<bool> visited_;
    std::uint64_t triangles_ = 0;
    std::vector<PartData> parts_;
};

}  // namespace

std::vector<PartData> read_glb(const std::filesystem::path& file) {
    const auto content = file_content(file);
    try {
        return GlbReader(file.string(), content).parts();
    } catch (const json::exception& error) {
        throw InvalidInput(fmt::format("{}: the JSON chunk is damaged: {}", file.string(), error.what()));
    }
}

}  // namespace stratareeb
