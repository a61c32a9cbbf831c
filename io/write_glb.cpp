// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_glb.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/binary_output.h"
#include "io/gltf.h"
#include "io/write_aside.h"
#include "mesh/measures.h"

namespace stratareeb {
namespace {

using nlohmann::json;

using Position = std::array<float, 3>;

Position local(const Point3& p, const Point3& origin) {
    return {static_cast<float>(p.x - origin.x), static_cast<float>(p.y - origin.y),
            static_cast<float>(p.z - origin.z)};
}

BoundingBox box_of(std::span<const PartData> parts) {
    std::vector<Point3> corners;
    for (const auto& part : parts) {
        if (part.soup.points.empty()) continue;
        const auto box = bounding_box(part.soup.points);
        corners.insert(corners.end(), {box.min, box.max});
    }
    return bounding_box(corners);
}

// The JSON half of the file, and how long the binary half gets.
class Document {
 public:
    explicit Document(const Point3& origin) : origin_(origin) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Stratareeb"}};
        json_["scene"] = 0;
        json_["scenes"] = {{{"nodes", {0}}}};
        // x stays x, z becomes y, y becomes -z; columns one after another.
        json_["nodes"] = {
            {{"name", "z up"},
             {"matrix", {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, origin.x, origin.z, -origin.y, 1}}}};
    }

    void add(const PartData& part) {
        auto& nodes = json_["nodes"];
        nodes[0]["children"].push_back(nodes.size());
        nodes.push_back({{"name", part.name}});
        if (part.soup.triangles.empty()) return;  // glTF knows no empty meshes
        nodes.back()["mesh"] = json_["meshes"].size();
        json_["meshes"].push_back(
            {{"name", part.name},
             {"primitives",
              {{{"attributes", {{"POSITION", positions(part)}, {"NORMAL", normals(part)}}},
                {"indices", indices(part)},
                {"material", json_["materials"].size()}}}}});
        json_["materials"].push_back(material(part));
    }

    std::string text(std::size_t& binary_size) {
        binary_size = size_;
        if (size_ > 0) json_["buffers"] = {{{"byteLength", size_}}};
        auto result = json_.dump(-1, ' ', false, json::error_handler_t::replace);
        result.resize((result.size() + 3) / 4 * 4, ' ');
        return result;
    }

 private:
    std::size_t view(std::size_t bytes, int target) {
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes}, {"target", target}});
        size_ += bytes;
        return json_["bufferViews"].size() - 1;
    }

    std::size_t accessor(json description) {
        json_["accessors"].push_back(std::move(description));
        return json_["accessors"].size() - 1;
    }

    std::size_t positions(const PartData& part) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        Position low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
        for (const auto& point : part.soup.points) {
            const auto p = local(point, origin_);
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], p[k]);
                high[k] = std::max(high[k], p[k]);
            }
        }
        const std::size_t n = part.soup.points.size();
        return accessor({{"bufferView", view(12 * n, gltf::kArrayBuffer)},
                         {"componentType", gltf::kFloat},
                         {"count", n},
                         {"type", "VEC3"},
                         {"min", low},
                         {"max", high}});
    }

    std::size_t normals(const PartData& part) {
        const std::size_t n = part.soup.points.size();
        return accessor({{"bufferView", view(12 * n, gltf::kArrayBuffer)},
                         {"componentType", gltf::kFloat},
                         {"count", n},
                         {"type", "VEC3"}});
    }

    std::size_t indices(const PartData& part) {
        const std::size_t n = 3 * part.soup.triangles.size();
        return accessor({{"bufferView", view(4 * n, gltf::kElementArrayBuffer)},
                         {"componentType", gltf::kUnsignedInt},
                         {"count", n},
                         {"type", "SCALAR"}});
    }

    static json material(const PartData& part) {
        json factor = json::array();
        for (const auto c : part.color) factor.push_back(gltf::linear(c));
        factor.push_back(1.0);
        return {{"name", part.name},
                {"doubleSided", false},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", factor}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}}};
    }

    Point3 origin_;
    json json_;
    std::size_t size_ = 0;
};

void put_geometry(BinaryOutput& out, const PartData& part, const Point3& origin) {
    if (part.soup.triangles.empty()) return;
    for (const auto& p : part.soup.points)
        for (const float value : local(p, origin)) out.put(value);
    for (const auto& n : part.normals)
        for (const float value : local(n, {})) out.put(value);
    for (const auto& triangle : part.soup.triangles)
        for (const auto v : triangle) out.put(v);
}

}  // namespace

void write_glb(const std::filesystem::path& file, std::span<const PartData> parts) {
    const auto origin = box_of(parts).centre();
    Document document(origin);
    for (const auto& part : parts) document.add(part);
    std::size_t binary_size = 0;
    const auto text = document.text(binary_size);
    const std::size_t total = 12 + 8 + text.size() + (binary_size > 0 ? 8 + binary_size : 0);
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw IoError(fmt::format("{}: {} bytes are more than a GLB file can hold; write fewer parts",
                                  file.string(), total));
    write_aside(file, [&](std::ostream& stream) {
        BinaryOutput out(stream);
        const auto put = [&](std::size_t value) { out.put(static_cast<std::uint32_t>(value)); };
        put(gltf::kMagic);
        put(2);
        put(total);
        put(text.size());
        put(gltf::kJsonChunk);
        for (const char c : text) out.put(c);
        if (binary_size == 0) return;
        put(binary_size);
        put(gltf::kBinaryChunk);
        for (const auto& part : parts) put_geometry(out, part, origin);
    });
}

}  // namespace stratareeb
