// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_table.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string_view>

#include "boreholes/errors.h"
#include "io/text_output.h"
#include "io/write_aside.h"

namespace stratareeb {
namespace {

//! In quotes where a comma, a quote or a line end, or spaces at an end that readers trim, would be misread.
std::string quoted(const std::string& text) {
    const bool padded = !text.empty() && (text.front() == ' ' || text.back() == ' ');
    if (text.find_first_of(",\"\r\n") == std::string::npos && !padded) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

std::string cell_text(const OutputCell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    return {};
}

void write_csv(const std::filesystem::path& file, const OutputTable& table) {
    write_aside(file, [&](std::ostream& stream) {
        TextOutput out(stream);
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            out.print("{}{}", i > 0 ? "," : "", quoted(table.columns[i]));
        out.print("\n");
        for (const auto& row : table.rows) {
            for (std::size_t i = 0; i < row.size(); ++i)
                out.print("{}{}", i > 0 ? "," : "", quoted(cell_text(row[i])));
            out.print("\n");
        }
    });
}

bool has_text(const OutputTable& table, std::size_t column) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
}

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw IoError(fmt::format("{}: can't be written: {}", file.string(), CPLGetLastErrorMsg()));
}

void fill_sheet(OGRLayer& layer, const OutputTable& table, const std::filesystem::path& file) {
    std::vector<bool> is_text;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        is_text.push_back(has_text(table, i));
        OGRFieldDefn field(table.columns[i].c_str(), is_text[i] ? OFTString : OFTReal);
        if (layer.CreateField(&field) != OGRERR_NONE) fail(file);
    }
    for (const auto& row : table.rows) {
        OGRFeature feature(layer.GetLayerDefn());
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (std::holds_alternative<std::monostate>(row[i])) continue;
            if (is_text[i])
                feature.SetField(static_cast<int>(i), cell_text(row[i]).c_str());
            else
                feature.SetField(static_cast<int>(i), std::get<double>(row[i]));
        }
        if (layer.CreateFeature(&feature) != OGRERR_NONE) fail(file);
    }
}

void write_xlsx(const std::filesystem::path& file, const OutputTable& table) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("XLSX");
    if (driver == nullptr)
        throw IoError(fmt::format("{}: this GDAL can't write XLSX; write .csv", file.string()));
    replace_aside(file, [&](const std::filesystem::path& temporary) {
        CPLErrorReset();
        GDALDatasetUniquePtr workbook(driver->Create(temporary.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        if (!workbook) fail(file);
        OGRLayer* sheet = workbook->CreateLayer("Sheet1");
        if (sheet == nullptr) fail(file);
        fill_sheet(*sheet, table, file);
        workbook.reset();  // writes the file
        if (CPLGetLastErrorType() == CE_Failure) fail(file);
    });
}

}  // namespace

void write_table(const std::filesystem::path& file, const OutputTable& table) {
    const auto extension = file.extension();
    if (extension == ".csv") return write_csv(file, table);
    if (extension == ".xlsx") return write_xlsx(file, table);
    throw IoError(fmt::format("{}: tables are written as .csv or .xlsx", file.string()));
}

}  // namespace stratareeb
