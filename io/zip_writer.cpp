// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/zip_writer.h"

#include <zlib.h>

#include <limits>
#include <ostream>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

constexpr std::uint64_t kLimit = std::numeric_limits<std::uint32_t>::max();

void put16(std::string& bytes, std::uint64_t value) {
    bytes += static_cast<char>(value & 0xff);
    bytes += static_cast<char>(value >> 8 & 0xff);
}

void put32(std::string& bytes, std::uint64_t value) {
    put16(bytes, value & 0xffff);
    put16(bytes, value >> 16);
}

}  // namespace

struct ZipWriter::Entry {
    std::string name;
    std::uint64_t offset = 0, size = 0, packed_size = 0;
    std::uint32_t checksum = 0;
};

// The deflated bytes are kept until the entry ends, since its header comes first and holds their number.
struct ZipWriter::Deflater {
    z_stream state{};
    std::string packed;

    Deflater() {
        constexpr int kRaw = -15;  // negative: without zlib's own header
        if (deflateInit2(&state, 6, Z_DEFLATED, kRaw, 8, Z_DEFAULT_STRATEGY) != Z_OK)
            throw IoError("zlib can't be started");
    }
    ~Deflater() { deflateEnd(&state); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void feed(std::string_view content, int flush) {
        state.next_in =
            reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));  // zlib does not write there
        state.avail_in = static_cast<uInt>(content.size());
        std::string block(1 << 16, '\0');
        do {
            state.next_out = reinterpret_cast<Bytef*>(block.data());
            state.avail_out = static_cast<uInt>(block.size());
            deflate(&state, flush);
            packed.append(block, 0, block.size() - state.avail_out);
        } while (state.avail_out == 0);
    }
};

ZipWriter::ZipWriter(std::ostream& stream) : stream_(stream) {}
ZipWriter::~ZipWriter() = default;

void ZipWriter::begin(const std::string& name) {
    entries_.push_back({name, position_, 0, 0, 0});
    deflater_ = std::make_unique<Deflater>();
}

void ZipWriter::append(std::string_view content) {
    constexpr std::size_t kBlock = 1 << 30;  // zlib counts in 32 bits
    for (; !content.empty(); content.remove_prefix(std::min(kBlock, content.size()))) {
        const auto block = content.substr(0, kBlock);
        auto& entry = entries_.back();
        entry.size += block.size();
        entry.checksum = static_cast<std::uint32_t>(crc32(
            entry.checksum, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(block.size())));
        deflater_->feed(block, Z_NO_FLUSH);
    }
}

void ZipWriter::end() {
    deflater_->feed({}, Z_FINISH);
    auto& entry = entries_.back();
    entry.packed_size = deflater_->packed.size();
    if (entry.size > kLimit || position_ + entry.packed_size > kLimit)
        throw IoError(entry.name + ": more than 4 GB, too large for a ZIP archive");
    put_header(entry, false);
    write(deflater_->packed);
    deflater_.reset();
}

// The header stands before the entry's bytes and, a little longer, in the directory at the end of the
// archive.
void ZipWriter::put_header(const Entry& entry, bool central) {
    std::string header;
    put32(header, central ? 0x02014b50 : 0x04034b50);
    if (central) put16(header, 20);  // made by version 2.0
    put16(header, 20);               // needs version 2.0
    put16(header, 0);
    put16(header, 8);       // deflated
    put16(header, 0);       // 00:00
    put16(header, 0x0021);  // 1 January 1980
    put32(header, entry.checksum);
    put32(header, entry.packed_size);
    put32(header, entry.size);
    put16(header, entry.name.size());
    put16(header, 0);
    if (central) {
        header.append(6, '\0');  // no comment, first disk, binary
        put32(header, 0);
        put32(header, entry.offset);
    }
    write(header + entry.name);
}

void ZipWriter::finish() {
    const auto begin = position_;
    for (const auto& entry : entries_) put_header(entry, true);
    const auto size = position_ - begin;
    if (position_ > kLimit) throw IoError("more than 4 GB, too large for a ZIP archive");
    std::string tail;
    put32(tail, 0x06054b50);
    put32(tail, 0);
    put16(tail, entries_.size());
    put16(tail, entries_.size());
    put32(tail, size);
    put32(tail, begin);
    put16(tail, 0);
    write(tail);
}

void ZipWriter::write(std::string_view bytes) {
    stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    position_ += bytes.size();
}

}  // namespace stratareeb
