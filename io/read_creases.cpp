// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_creases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>

#include "boreholes/errors.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

// The words of a line, up to a comment.
std::vector<std::string_view> words_of_line(TextScanner& scan) {
    std::vector<std::string_view> words;
    for (auto word = scan.word(); !word.empty() && word[0] != '#'; word = scan.word()) words.push_back(word);
    return words;
}

std::uint32_t vertex(const TextScanner& scan, std::string_view word) {
    const long long number = scan.integer(word);
    if (number < 0 || number >= std::numeric_limits<std::uint32_t>::max())
        scan.fail(fmt::format("{} is no number of a vertex; they begin with 0", number));
    return static_cast<std::uint32_t>(number);
}

double sharpness(const TextScanner& scan, std::string_view word) {
    const double value = scan.number(word);
    if (value < 0) scan.fail(fmt::format("a sharpness of {}; it is 0 or more", value));
    return value;
}

void read_line(const TextScanner& scan, const std::vector<std::string_view>& words, CreaseList& list) {
    if (words.size() < 3) scan.fail("a line of edges needs two vertices or more");
    for (std::size_t i = 2; i < words.size(); ++i)
        list.creases.push_back({vertex(scan, words[i - 1]), vertex(scan, words[i])});
}

void read_corner(const TextScanner& scan, const std::vector<std::string_view>& words, CreaseList& list) {
    if (words.size() != 2 && words.size() != 3) scan.fail("expected: corner VERTEX [SHARPNESS]");
    SharpCorner corner{vertex(scan, words[1])};
    if (words.size() == 3) corner.sharpness = sharpness(scan, words[2]);
    list.corners.push_back(corner);
}

void read_edge(const TextScanner& scan, const std::vector<std::string_view>& words, CreaseList& list) {
    if (words.size() != 2 && words.size() != 3) scan.fail("expected: FROM TO [SHARPNESS]");
    Crease crease{vertex(scan, words[0]), vertex(scan, words[1])};
    if (words.size() == 3) crease.sharpness = sharpness(scan, words[2]);
    list.creases.push_back(crease);
}

void require_known(const std::filesystem::path& file, const std::vector<std::string>& wanted,
                   const std::set<std::string>& known) {
    for (const auto& name : wanted)
        if (!known.contains(name))
            throw InvalidInput(
                fmt::format("{}: there is no feature {}; there are {}", file.string(), name,
                            known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

}  // namespace

CreaseList read_creases(const std::filesystem::path& file, const std::vector<std::string>& features) {
    std::string content = file_content(file);
    std::ranges::replace_if(
        content, [](char c) { return c == ',' || c == ';'; }, ' ');
    TextScanner scan(file.string(), content);
    CreaseList list, passed_over;
    std::set<std::string> known;
    bool wanted = features.empty();
    for (bool is_first = true; !scan.at_end(); scan.next_line()) {
        const auto words = words_of_line(scan);
        if (words.empty()) continue;
        CreaseList& into = wanted ? list : passed_over;
        if (words[0] == "feature") {
            if (words.size() != 2) scan.fail("expected: feature NAME, in one word");
            known.emplace(words[1]);
            wanted = features.empty() || std::ranges::find(features, words[1]) != features.end();
        } else if (words[0] == "line") {
            read_line(scan, words, into);
        } else if (words[0] == "corner") {
            read_corner(scan, words, into);
        } else if (!is_first || words[0] != "from") {
            read_edge(scan, words, into);
        }
        is_first = false;
    }
    require_known(file, features, known);
    return list;
}

}  // namespace stratareeb
