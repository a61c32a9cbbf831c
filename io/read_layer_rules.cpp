// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_layer_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "boreholes/errors.h"
#include "io/cell_value.h"
#include "io/read_table.h"

namespace stratareeb {

namespace {

std::string lower(std::string_view text) {
    std::string result(trimmed(text));
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string name_in(const TextTable& table, std::size_t row, std::size_t column) {
    return lower(!table.field_names.empty() && row == 0 && column < table.field_names.size()
                     ? std::string_view(table.field_names[column])
                     : table.cell(row, column));
}

struct RuleColumnsOfTable {
    std::optional<std::size_t> code, rule, minimum;
    std::size_t first_row = 0;
};

RuleColumnsOfTable columns_of(const TextTable& table, const std::string& path) {
    RuleColumnsOfTable columns;
    const bool named = !table.field_names.empty();
    columns.first_row = named ? 0 : 1;
    const std::size_t count = named                   ? table.field_names.size()
                              : table.row_count() > 0 ? table.cell_count(0)
                                                      : 0;
    for (std::size_t c = 0; c < count; ++c) {
        const std::string name = name_in(table, 0, c);
        if (name == "code" || name == "unit") columns.code = c;
        if (name == "rule") columns.rule = c;
        if (name == "min_thickness") columns.minimum = c;
    }
    if (!columns.code || (!columns.rule && !columns.minimum))
        throw InvalidInput(
            fmt::format("{}: a table of layer rules has a header with code and rule or min_thickness", path));
    return columns;
}

NamedRule rule_in(const TextTable& table, std::size_t row, const RuleColumnsOfTable& columns,
                  const std::string& path) {
    const auto place = [&] { return fmt::format("{}:{}", path, table.line(row)); };
    NamedRule word{.code = cell_name(table.cell(row, *columns.code)), .rule = {}, .min_thickness = {}};
    if (columns.rule)
        if (const std::string name = lower(table.cell(row, *columns.rule)); !name.empty()) try {
                word.rule = layer_rule(name);
            } catch (const InvalidInput& error) {
                throw InvalidInput(fmt::format("{}: {}", place(), error.what()));
            }
    if (columns.minimum) {
        const CellValue value = cell_value(table.cell(row, *columns.minimum), table.decimal_comma);
        if (value.kind == CellKind::Number && value.number >= 0)
            word.min_thickness = value.number;
        else if (value.kind != CellKind::Empty)
            throw InvalidInput(
                fmt::format("{}: \"{}\" is no minimum thickness (expected a length, 0 or more)", place(),
                            table.cell(row, *columns.minimum)));
    }
    return word;
}

}  // namespace

std::vector<NamedRule> read_layer_rules(const std::string& path) {
    const TextTable table = std::move(read_tables(path).front());
    const RuleColumnsOfTable columns = columns_of(table, path);
    std::vector<NamedRule> rules;
    for (std::size_t row = columns.first_row; row < table.row_count(); ++row) {
        NamedRule word = rule_in(table, row, columns, path);
        if (!word.code.empty()) rules.push_back(std::move(word));
    }
    return rules;
}

}  // namespace stratareeb
