// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include "boreholes/errors.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

struct Property {
    std::string name;
    Type type = Type::Float;
    std::optional<Type> count_type;  // of a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { Ascii, LittleEndian, BigEndian };

struct Header {
    Encoding encoding = Encoding::Ascii;
    std::vector<Element> elements;
};

std::optional<Type> type_of(std::string_view word) {
    if (word == "char" || word == "int8") return Type::Int8;
    if (word == "uchar" || word == "uint8") return Type::UInt8;
    if (word == "short" || word == "int16") return Type::Int16;
    if (word == "ushort" || word == "uint16") return Type::UInt16;
    if (word == "int" || word == "int32") return Type::Int32;
    if (word == "uint" || word == "uint32") return Type::UInt32;
    if (word == "float" || word == "float32") return Type::Float;
    if (word == "double" || word == "float64") return Type::Double;
    return {};
}

std::size_t size_of(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<int>(type)];
}

Type required_type(TextScanner& scan) {
    const auto word = scan.word();
    const auto type = type_of(word);
    if (!type) scan.fail(fmt::format("unknown property type '{}'", word.substr(0, 20)));
    return *type;
}

Property property(TextScanner& scan) {
    Property p;
    auto copy = scan;
    if (copy.word() == "list") {
        scan.word();
        p.count_type = required_type(scan);
        if (*p.count_type == Type::Float || *p.count_type == Type::Double)
            scan.fail("a list length must be a whole number");
    }
    p.type = required_type(scan);
    p.name = scan.word();
    return p;
}

Encoding encoding(TextScanner& scan) {
    const auto word = scan.word();
    if (word == "ascii") return Encoding::Ascii;
    if (word == "binary_little_endian") return Encoding::LittleEndian;
    if (word == "binary_big_endian") return Encoding::BigEndian;
    scan.fail("unknown PLY format (expected ascii, binary_little_endian or binary_big_endian)");
}

Header header(TextScanner& scan) {
    if (scan.rest_of_line() != "ply") scan.fail("not a PLY file: it does not begin with 'ply'");
    Header h;
    for (bool format_known = false;;) {
        if (scan.at_end()) scan.fail("the PLY header does not end with 'end_header'");
        const auto word = scan.word();
        if (word == "end_header") {
            if (!format_known) scan.fail("the PLY header names no format");
            scan.next_line();
            return h;
        }
        if (word == "format") {
            h.encoding = encoding(scan);
            format_known = true;
        } else if (word == "element") {
            Element element{std::string(scan.word()), 0, {}};
            const auto count = scan.integer(scan.word());
            if (count < 0) scan.fail("a negative number of elements");
            element.count = static_cast<std::uint64_t>(count);
            h.elements.push_back(element);
        } else if (word == "property") {
            if (h.elements.empty()) scan.fail("a property before the first element");
            h.elements.back().properties.push_back(property(scan));
        } else if (!word.empty() && word != "comment" && word != "obj_info") {
            scan.fail("unknown line in the PLY header");
        }
        scan.next_line();
    }
}

// The numbers behind the header, one after another.
class Body {
 public:
    virtual ~Body() = default;
    virtual double number(Type type) = 0;
    virtual std::size_t bytes_left() const = 0;
    [[noreturn]] virtual void fail(const std::string& message) const = 0;

    std::uint32_t index(Type type, std::size_t limit) {
        const double value = number(type);
        if (!(value >= 0 && value < static_cast<double>(limit)) || value != std::floor(value))
            fail(fmt::format("vertex index {} is out of range; there are {} vertices", value, limit));
        return static_cast<std::uint32_t>(value);
    }
    std::size_t list_length(Type type) {
        const double value = number(type);
        if (!(value >= 0) || value != std::floor(value) || value > static_cast<double>(bytes_left()))
            fail(fmt::format("a list of {} numbers does not fit into the rest of the file", value));
        return static_cast<std::size_t>(value);
    }
};

class AsciiBody : public Body {
 public:
    explicit AsciiBody(const TextScanner& scan) : scan_(scan) {}
    double number(Type) override {
        const auto word = scan_.word_anywhere();
        if (word.empty()) scan_.fail("the file ends in the middle of the data");
        return scan_.number(word);
    }
    std::size_t bytes_left() const override { return scan_.rest().size(); }
    [[noreturn]] void fail(const std::string& message) const override { scan_.fail(message); }

 private:
    TextScanner scan_;
};

class BinaryBody : public Body {
 public:
    BinaryBody(std::string file, std::string_view content, std::size_t begin, bool swap)
        : file_(std::move(file)), content_(content), position_(begin), swap_(swap) {}

    double number(Type type) override {
        switch (type) {
            case Type::Int8:
                return take<std::int8_t>();
            case Type::UInt8:
                return take<std::uint8_t>();
            case Type::Int16:
                return take<std::int16_t>();
            case Type::UInt16:
                return take<std::uint16_t>();
            case Type::Int32:
                return take<std::int32_t>();
            case Type::UInt32:
                return take<std::uint32_t>();
            case Type::Float:
                return take<float>();
            case Type::Double:
                return take<double>();
        }
        return 0;
    }
    std::size_t bytes_left() const override { return content_.size() - position_; }
    [[noreturn]] void fail(const std::string& message) const override {
        throw InvalidInput(fmt::format("{}: byte {}: {}", file_, position_, message));
    }

 private:
    template <class T>
    T take() {
        if (bytes_left() < sizeof(T)) fail("the file ends in the middle of the data");
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), content_.data() + position_, sizeof(T));
        if (swap_) std::reverse(bytes.begin(), bytes.end());
        position_ += sizeof(T);
        return std::bit_cast<T>(bytes);
    }

    std::string file_;
    std::string_view content_;
    std::size_t position_;
    bool swap_;
};

void skip(Body& body, const Property& property) {
    const std::size_t n = property.count_type ? body.list_length(*property.count_type) : 1;
    for (std::size_t i = 0; i < n; ++i) body.number(property.type);
}

// A count in a header is a promise; memory is set aside only for what the bytes left can hold.
std::size_t plausible_count(const Element& element, const Body& body, bool ascii) {
    std::size_t size = 0;
    for (const auto& p : element.properties)
        size += ascii ? 2 : size_of(p.count_type ? *p.count_type : p.type);
    return std::min<std::uint64_t>(element.count, body.bytes_left() / std::max<std::size_t>(size, 1) + 1);
}

// Which of x y z red green blue a property is; 6 for others.
int slot(const Property& p) {
    constexpr std::string_view names[] = {"x", "y", "z", "red", "green", "blue"};
    if (p.count_type) return 6;
    return static_cast<int>(std::find(std::begin(names), std::end(names), p.name) - std::begin(names));
}

void read_vertices(Body& body, const Element& element, bool ascii, PartData& part) {
    std::vector<int> slots;
    for (const auto& p : element.properties) slots.push_back(slot(p));
    for (int k = 0; k < 3; ++k)
        if (std::count(slots.begin(), slots.end(), k) != 1) body.fail("vertices need x, y and z once each");
    const bool colored =
        std::count_if(slots.begin(), slots.end(), [](int s) { return s >= 3 && s < 6; }) == 3;
    bool one_color = colored;
    std::array<double, 7> values{};
    Rgb color{};
    part.soup.points.reserve(plausible_count(element, body, ascii));
    for (std::uint64_t v = 0; v < element.count; ++v) {
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (element.properties[i].count_type)
                skip(body, element.properties[i]);
            else
                values[slots[i]] = body.number(element.properties[i].type);
        }
        if (!std::isfinite(values[0]) || !std::isfinite(values[1]) || !std::isfinite(values[2]))
            body.fail(fmt::format("vertex {} has a coordinate that is not a finite number", v));
        part.soup.points.push_back({values[0], values[1], values[2]});
        if (!one_color) continue;
        Rgb here{};
        for (int k = 0; k < 3; ++k)
            here[k] = static_cast<std::uint8_t>(std::clamp(values[3 + k], 0.0, 255.0));
        if (v == 0) color = here;
        one_color = here == color;
    }
    if (one_color && element.count > 0) part.color = color;
}

void read_faces(Body& body, const Element& element, bool ascii, TriangleSoup& soup) {
    const auto is_corners = [](const Property& p) {
        return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    soup.triangles.reserve(plausible_count(element, body, ascii));
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < element.count; ++f) {
        for (const auto& p : element.properties) {
            if (!is_corners(p)) {
                skip(body, p);
                continue;
            }
            corners.resize(body.list_length(*p.count_type));
            for (auto& corner : corners) corner = body.index(p.type, soup.points.size());
            if (corners.size() < 3) body.fail(fmt::format("face {} has {} corners", f, corners.size()));
            append_fan(corners, soup.triangles);
        }
    }
}

std::unique_ptr<Body> body_behind(const std::string& file, const TextScanner& scan, std::string_view content,
                                  Encoding encoding) {
    if (encoding == Encoding::Ascii) return std::make_unique<AsciiBody>(scan);
    const bool file_is_little = encoding == Encoding::LittleEndian;
    const bool swap = file_is_little != (std::endian::native == std::endian::little);
    return std::make_unique<BinaryBody>(file, content, content.size() - scan.rest().size(), swap);
}

}  // namespace

PartData read_ply(const std::filesystem::path& file) {
    const auto content = file_content(file);
    TextScanner scan(file.string(), content);
    const auto h = header(scan);
    const auto body = body_behind(file.string(), scan, content, h.encoding);
    const bool ascii = h.encoding == Encoding::Ascii;
    PartData part;
    bool vertices_known = false;
    for (const auto& element : h.elements) {
        if (element.properties.empty()) continue;  // no bytes, however many are announced
        if (element.name == "vertex") {
            if (vertices_known) body->fail("a second list of vertices");
            if (element.count >= std::numeric_limits<std::uint32_t>::max()) body->fail("too many vertices");
            read_vertices(*body, element, ascii, part);
            vertices_known = true;
        } else if (element.name == "face") {
            if (!vertices_known) body->fail("faces come before the vertices");
            read_faces(*body, element, ascii, part.soup);
        } else {
            for (std::uint64_t i = 0; i < element.count; ++i)
                for (const auto& p : element.properties) skip(*body, p);
        }
    }
    if (!vertices_known) body->fail("there are no vertices");
    return part;
}

}  // namespace stratareeb
