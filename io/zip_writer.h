// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace stratareeb {

//! A ZIP archive to a stream, entry by entry, deflated. Time stamps are fixed: same content, same bytes.
class ZipWriter {
 public:
    explicit ZipWriter(std::ostream& stream);
    ~ZipWriter();

    //! \throw IoError if an entry or the archive gets too large for plain ZIP (4 GB)
    void begin(const std::string& name);
    void append(std::string_view content);
    void end();
    void finish();

 private:
    struct Entry;
    struct Deflater;
    void put_header(const Entry& entry, bool central);
    void write(std::string_view bytes);

    std::ostream& stream_;
    std::uint64_t position_ = 0;
    std::vector<Entry> entries_;
    std::unique_ptr<Deflater> deflater_;
};

}  // namespace stratareeb
