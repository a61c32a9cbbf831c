// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stratareeb {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float;
    std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

//! The numbers behind a PLY file's header, one after another.
class PlyBody {
 public:
    virtual ~PlyBody() = default;
    virtual double number(PlyType type) = 0;
    virtual std::size_t bytes_left() const = 0;
    [[noreturn]] virtual void fail(const std::string& message) const = 0;

    std::uint32_t index(PlyType type, std::size_t limit);
    std::size_t list_length(PlyType type);
    void skip(const PlyProperty& property);
    void skip(const PlyElement& element);
};

//! A PLY file, ASCII or binary of either byte order, with its header read.
class PlyFile {
 public:
    //! \throw IoError, InvalidInput as read_mesh does
    explicit PlyFile(const std::filesystem::path& file);
    PlyFile(const PlyFile&) = delete;
    PlyFile& operator=(const PlyFile&) = delete;

    const std::vector<PlyElement>& elements() const { return elements_; }
    PlyBody& body() { return *body_; }

    //! A count in a header is a promise; memory is set aside only for what the bytes left can hold.
    std::size_t plausible_count(const PlyElement& element) const;

 private:
    std::string content_;
    bool ascii_ = true;
    std::vector<PlyElement> elements_;
    std::unique_ptr<PlyBody> body_;
};

}  // namespace stratareeb
