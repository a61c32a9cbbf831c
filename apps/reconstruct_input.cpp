// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/reconstruct_input.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "apps/choice.h"
#include "boreholes/errors.h"
#include "io/read_enhanced_graph.h"
#include "io/text_scanner.h"

namespace stratareeb {

namespace {

constexpr const char* kStackOptions[] = {"--elevation",   "--part",         "--leave-out-open", "--ends",
                                         "--end-spacing", "--most-spacing", "--least-share"};

//! The first character that is neither blank nor of a byte order mark; 0 if there is none.
char first_character(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    for (char c = 0; stream.get(c);)
        if (std::string_view(" \t\r\n\xEF\xBB\xBF").find(c) == std::string_view::npos) return c;
    return 0;
}

//! The names in the outermost object of a JSON text, as far as it is one.
std::set<std::string> outer_keys(const std::string& text) {
    using Json = nlohmann::json;
    std::set<std::string> keys;
    const auto note = [&](int depth, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::key && depth == 1) keys.insert(value.get<std::string>());
        return event != Json::parse_event_t::key || depth != 1;  // what is in it is not kept
    };
    const auto document = Json::parse(text, note, false);
    return keys;
}

void tell_dropped(const std::string& file, const StackGraph& stack) {
    constexpr std::size_t kTold = 5;
    const auto id = [&](std::uint32_t c) { return text_of(stack.graph.contours[c].id); };
    for (std::size_t i = 0; i < stack.dropped.size() && i < kTold; ++i) {
        const auto& [lower, upper, share] = stack.dropped[i];
        fmt::print(
            stderr,
            "{}: contours {} and {} share {:.3g} % of the smaller one and are not joined: more of them "
            "meet there than a merge or a division takes\n",
            file, id(lower), id(upper), 100 * share);
    }
    if (stack.dropped.size() > kTold)
        fmt::print(stderr, "{}: and {} more\n", file, stack.dropped.size() - kTold);
}

}  // namespace

void add_stack_options(CLI::App& command, StackOptions& options) {
    command.add_option("--elevation", options.read.elevation,
                       "Contours: attribute or column with the height (else recognised, or the points' z)");
    command.add_option(
        "--part", options.read.part,
        "Contours: the body to read of several, by its value in the column roi, body, part, …");
    command.add_flag("--leave-out-open", options.read.leave_out_open,
                     "Contours: leave out lines that are not closed; else they are faults");
    add_choice(command, "--ends", options.graph.ends,
               {{"domes", StackEnds::Domes}, {"flat", StackEnds::Flat}},
               "Contours: close the body by domes, or flat, beyond a contour that nothing follows");
    command
        .add_option("--end-spacing", options.graph.end_spacing,
                    "Contours: spacing beyond the first and the last level (else that to their neighbours)")
        ->check(CLI::PositiveNumber);
    command
        .add_option("--most-spacing", options.graph.most_spacing,
                    "Contours: levels further apart than this are not joined")
        ->check(CLI::PositiveNumber);
    command
        .add_option("--least-share", options.graph.least_share,
                    "Contours: join those that share at least this part of the smaller one")
        ->check(CLI::Range(0.0, 1.0));
}

bool is_enhanced_graph_file(const std::string& file) {
    if (first_character(file) != '{') return false;
    const auto keys = outer_keys(file_content(file));
    if (keys.contains("nodes") && keys.contains("arcs"))
        throw InvalidInput(file +
                           ": a Reeb graph without its contours; `reeb MESH --enhanced` writes one with");
    return (keys.contains("nodes") || keys.contains("edges")) && !keys.contains("type");
}

ReconstructInput read_reconstruct_input(const std::string& file, const StackOptions& options) {
    if (is_enhanced_graph_file(file)) {
        EnhancedGraphFile graph = parse_enhanced_graph(file_content(file), file);
        return {std::move(graph.graph), std::nullopt, graph.axes, {}};
    }
    const ContourStack contours = read_contour_stack(file, options.read);
    try {
        ReconstructInput input{{}, graph_of_stack(contours, options.graph), {}, {}};
        for (const std::uint32_t c : input.stack->source)
            input.sources.push_back(
                fmt::format("{}, at height {:.10g}", contours.contours[c].name, contours.contours[c].z));
        tell_dropped(file, *input.stack);
        input.graph = std::move(input.stack->graph);
        return input;
    } catch (const InvalidInput& error) {
        throw InvalidInput(fmt::format("{}: {}", file, error.what()));
    }
}

std::string contours_named_in(const std::string& message, const ReconstructInput& input) {
    std::string text;
    for (std::size_t c = 0; c < input.sources.size(); ++c) {
        const std::string name = "contour " + text_of(input.graph.contours[c].id);
        for (auto at = message.find(name); at != std::string::npos; at = message.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if (end < message.size() && message[end] >= '0' && message[end] <= '9') continue;
            text += fmt::format("  {}: {}\n", name, input.sources[c]);
            break;
        }
    }
    return text;
}

void refuse_stack_options(const CLI::App& command) {
    for (const char* option : kStackOptions)
        if (command.count(option) > 0)
            throw CLI::ValidationError(option, "is about contours, and the file is a graph");
}

}  // namespace stratareeb
