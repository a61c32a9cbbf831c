// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_off.h"

#include <fmt/format.h>

#include <algorithm>

#include "boreholes/errors.h"
#include "io/polygon_fan.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

// The first word of the next line that has more than a comment.
std::string_view first_word(TextScanner& scan) {
    while (!scan.at_end()) {
        const auto word = scan.word();
        if (!word.empty() && word[0] != '#') return word;
        scan.next_line();
    }
    scan.fail("the file ends in the middle of the data");
}

std::uint64_t count(const TextScanner& scan, std::string_view word) {
    const auto n = scan.integer(word);
    if (n < 0) scan.fail("a negative number of elements");
    return static_cast<std::uint64_t>(n);
}

// "OFF", with letters before it for what follows x y z in a vertex line. The counts may follow on the same
// line.
std::string_view skip_header(TextScanner& scan) {
    const auto word = first_word(scan);
    if (!word.ends_with("OFF")) scan.fail("not an OFF file: it does not begin with 'OFF'");
    const auto extras = word.substr(0, word.size() - 3);
    if (extras.find_first_not_of("STCN") != std::string_view::npos)
        scan.fail("OFF files in other than three dimensions are not read");
    const auto next = scan.word();
    if (next == "BINARY") scan.fail("binary OFF files are not read; save it as text");
    if (!next.empty() && next[0] != '#') return next;
    scan.next_line();
    return first_word(scan);
}

}  // namespace

PolygonPart read_off_polygons(const std::filesystem::path& file) {
    const auto content = file_content(file);
    TextScanner scan(file.string(), content);
    const auto vertices = count(scan, skip_header(scan));
    const auto faces = count(scan, scan.word());
    scan.next_line();
    PolygonPart polygons;
    PartData& part = polygons.part;
    // Counts are promises; a line of a vertex or face has at least six bytes.
    part.soup.points.reserve(std::min<std::uint64_t>(vertices, content.size() / 6 + 1));
    for (std::uint64_t v = 0; v < vertices; ++v) {
        Point3 p;
        p.x = scan.number(first_word(scan));
        p.y = scan.number(scan.word());
        p.z = scan.number(scan.word());
        part.soup.points.push_back(p);
        scan.next_line();
    }
    part.soup.triangles.reserve(std::min<std::uint64_t>(faces, content.size() / 6 + 1));
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < faces; ++f) {
        const auto n = count(scan, first_word(scan));
        corners.clear();
        for (std::uint64_t k = 0; k < n; ++k) {
            const auto v = scan.integer(scan.word());
            if (v < 0 || static_cast<std::uint64_t>(v) >= vertices)
                scan.fail(fmt::format("vertex index {} is out of range; there are {} vertices", v, vertices));
            corners.push_back(static_cast<std::uint32_t>(v));
        }
        if (n < 3) scan.fail(fmt::format("face {} has {} corners", f, n));
        append_fan(corners, part.soup.triangles, polygons.fans);
        scan.next_line();
    }
    return polygons;
}

PartData read_off(const std::filesystem::path& file) {
    return read_off_polygons(file).part;
}

}  // namespace stratareeb
