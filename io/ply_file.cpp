// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "boreholes/errors.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

enum class Encoding { Ascii, LittleEndian, BigEndian };

struct Header {
    Encoding encoding = Encoding::Ascii;
    std::vector<PlyElement> elements;
};

std::optional<PlyType> type_of(std::string_view word) {
    if (word == "char" || word == "int8") return PlyType::Int8;
    if (word == "uchar" || word == "uint8") return PlyType::UInt8;
    if (word == "short" || word == "int16") return PlyType::Int16;
    if (word == "ushort" || word == "uint16") return PlyType::UInt16;
    if (word == "int" || word == "int32") return PlyType::Int32;
    if (word == "uint" || word == "uint32") return PlyType::UInt32;
    if (word == "float" || word == "float32") return PlyType::Float;
    if (word == "double" || word == "float64") return PlyType::Double;
    return {};
}

std::size_t size_of(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<int>(type)];
}

PlyType required_type(TextScanner& scan) {
    const auto word = scan.word();
    const auto type = type_of(word);
    if (!type) scan.fail(fmt::format("unknown property type '{}'", word.substr(0, 20)));
    return *type;
}

PlyProperty property(TextScanner& scan) {
    PlyProperty p;
    auto copy = scan;
    if (copy.word() == "list") {
        scan.word();
        p.count_type = required_type(scan);
        if (*p.count_type == PlyType::Float || *p.count_type == PlyType::Double)
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
            PlyElement element{std::string(scan.word()), 0, {}};
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

class AsciiBody : public PlyBody {
 public:
    explicit AsciiBody(const TextScanner& scan) : scan_(scan) {}
    double number(PlyType) override {
        const auto word = scan_.word_anywhere();
        if (word.empty()) scan_.fail("the file ends in the middle of the data");
        return scan_.number(word);
    }
    std::size_t bytes_left() const override { return scan_.rest().size(); }
    [[noreturn]] void fail(const std::string& message) const override { scan_.fail(message); }

 private:
    TextScanner scan_;
};

class BinaryBody : public PlyBody {
 public:
    BinaryBody(std::string file, std::string_view content, std::size_t begin, bool swap)
        : file_(std::move(file)), content_(content), position_(begin), swap_(swap) {}

    double number(PlyType type) override {
        switch (type) {
            case PlyType::Int8:
                return take<std::int8_t>();
            case PlyType::UInt8:
                return take<std::uint8_t>();
            case PlyType::Int16:
                return take<std::int16_t>();
            case PlyType::UInt16:
                return take<std::uint16_t>();
            case PlyType::Int32:
                return take<std::int32_t>();
            case PlyType::UInt32:
                return take<std::uint32_t>();
            case PlyType::Float:
                return take<float>();
            case PlyType::Double:
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

std::unique_ptr<PlyBody> body_behind(const std::string& file, const TextScanner& scan,
                                     std::string_view content, Encoding encoding) {
    if (encoding == Encoding::Ascii) return std::make_unique<AsciiBody>(scan);
    const bool file_is_little = encoding == Encoding::LittleEndian;
    const bool swap = file_is_little != (std::endian::native == std::endian::little);
    return std::make_unique<BinaryBody>(file, content, content.size() - scan.rest().size(), swap);
}

}  // namespace

std::uint32_t PlyBody::index(PlyType type, std::size_t limit) {
    const double value = number(type);
    if (!(value >= 0 && value < static_cast<double>(limit)) || value != std::floor(value))
        fail(fmt::format("vertex index {} is out of range; there are {} vertices", value, limit));
    return static_cast<std::uint32_t>(value);
}

std::size_t PlyBody::list_length(PlyType type) {
    const double value = number(type);
    if (!(value >= 0) || value != std::floor(value) || value > static_cast<double>(bytes_left()))
        fail(fmt::format("a list of {} numbers does not fit into the rest of the file", value));
    return static_cast<std::size_t>(value);
}

void PlyBody::skip(const PlyProperty& property) {
    const std::size_t n = property.count_type ? list_length(*property.count_type) : 1;
    for (std::size_t i = 0; i < n; ++i) number(property.type);
}

void PlyBody::skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // no bytes, however many are announced
    for (std::uint64_t i = 0; i < element.count; ++i)
        for (const auto& p : element.properties) skip(p);
}

PlyFile::PlyFile(const std::filesystem::path& file) : content_(file_content(file)) {
    TextScanner scan(file.string(), content_);
    Header h = header(scan);
    ascii_ = h.encoding == Encoding::Ascii;
    elements_ = std::move(h.elements);
    body_ = body_behind(file.string(), scan, content_, h.encoding);
}

std::size_t PlyFile::plausible_count(const PlyElement& element) const {
    std::size_t size = 0;
    for (const auto& p : element.properties)
        size += ascii_ ? 2 : size_of(p.count_type ? *p.count_type : p.type);
    return std::min<std::uint64_t>(element.count, body_->bytes_left() / std::max<std::size_t>(size, 1) + 1);
}

}  // namespace stratareeb
