// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "io/cell_value.h"

namespace stratareeb {
namespace {

std::optional<PointColumns> columns_by_place(const TableShape& shape) {
    if (shape.column_count() != 4 || !shape.stated.empty()) return std::nullopt;
    for (std::size_t column = 0; column < 3; ++column) {
        const CellCensus census = cell_census(shape, column);
        if (census.other >= census.numbers) return std::nullopt;
    }
    return PointColumns{3, 0, 1, 2, {}, {}};
}

//! A point with its place found, from its own columns or its hole's collar.
struct PlacedPoint {
    std::string hole, unit;
    Point2 at;
    double z = 0;
    std::optional<double> ground;
    std::size_t line = 0;
};

class PointReader {
 public:
    PointReader(const TableShape& shape, const PointColumns& columns, const CollarTable* collars,
                TableContext& context)
        : shape_(shape), columns_(columns), collars_(collars), context_(context) {}

    template <typename Take>
    void read(Take take) {
        for (std::size_t row = shape_.first_row; row < shape_.row_count(); ++row)
            if (const auto point = read_row(row)) take(*point);
        for (const auto& [hole, line] : unknown_)
            warn(line, fmt::format("hole {} has no usable collar; its points are left out", hole));
    }

 private:
    void warn(std::size_t line, std::string text) {
        context_.audit.add_warning(shape_.table->source, line, "", std::move(text));
    }

    std::optional<PlacedPoint> read_row(std::size_t row) {
        const std::size_t errors = context_.audit.error_count();
        PlacedPoint point;
        point.line = shape_.table->line(row);
        point.unit = cell_name(shape_.table->cell(row, columns_.unit));
        if (columns_.hole) point.hole = cell_name(shape_.table->cell(row, *columns_.hole));
        const auto x = number_cell(shape_, row, columns_.x, context_),
                   y = number_cell(shape_, row, columns_.y, context_);
        const auto z = number_cell(shape_, row, columns_.z, context_);
        const auto depth = number_cell(shape_, row, columns_.z ? std::nullopt : columns_.depth, context_);
        if (context_.audit.error_count() > errors) return std::nullopt;
        if (!x && !y && !z && !depth && point.unit.empty()) return std::nullopt;
        const Collar* collar = collars_ && !point.hole.empty() ? collars_->find(point.hole) : nullptr;
        if (!collar && !(x && y)) return left_out(point, columns_.x ? "no x, y" : "");
        if (point.unit.empty()) return left_out(point, "no unit");
        if (!z && !depth) return left_out(point, columns_.z ? "no z" : "no depth");
        if (!z && !(collar && collar->ground))
            return left_out(point, "a depth but no ground elevation of its hole");
        if (depth && *depth < 0) return left_out(point, "a depth above the ground");
        point.at = x && y ? Point2{*x, *y} : collar->at;
        if (collar) point.ground = collar->ground;
        point.z = z ? *z * context_.vertical : *collar->ground - *depth * context_.vertical;
        return point;
    }

    std::optional<PlacedPoint> left_out(const PlacedPoint& point, const std::string& why) {
        if (!why.empty())
            warn(point.line, why + "; the point is left out");
        else if (seen_unknown_.insert(point.hole).second)
            unknown_.emplace_back(point.hole, point.line);
        return std::nullopt;
    }

    const TableShape& shape_;
    const PointColumns& columns_;
    const CollarTable* collars_;
    TableContext& context_;
    std::set<std::string> seen_unknown_;
    std::vector<std::pair<std::string, std::size_t>> unknown_;
};

std::uint32_t file_number(std::vector<std::string>& files, const std::string& file) {
    const auto found = std::find(files.begin(), files.end(), file);
    if (found != files.end()) return static_cast<std::uint32_t>(found - files.begin());
    files.push_back(file);
    return static_cast<std::uint32_t>(files.size() - 1);
}

class Numbering {
 public:
    explicit Numbering(std::vector<std::string>& names) : names_(names) {
        for (std::size_t i = 0; i < names.size(); ++i) numbers_.emplace(names[i], i);
    }
    std::size_t operator()(const std::string& name) {
        const auto [place, is_new] = numbers_.try_emplace(name, names_.size());
        if (is_new) names_.push_back(name);
        return place->second;
    }

 private:
    std::vector<std::string>& names_;
    std::unordered_map<std::string, std::size_t> numbers_;
};

struct Sample {
    double depth = 0;
    std::size_t unit = 0, row = 0;
};

double usual_spacing(const std::vector<std::vector<Sample>>& holes) {
    std::vector<double> steps;
    for (const auto& samples : holes)
        for (std::size_t i = 1; i < samples.size(); ++i)
            if (samples[i].depth > samples[i - 1].depth)
                steps.push_back(samples[i].depth - samples[i - 1].depth);
    if (steps.empty()) return 1;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

void add_sample_intervals(const std::vector<Sample>& samples, double spacing, std::uint32_t file,
                          HoleLog& hole) {
    const double half = 0.5 * spacing;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto reach = [&](std::size_t neighbour) {
            const double step = std::abs(samples[neighbour].depth - samples[i].depth);
            return step <= 1.5 * spacing ? 0.5 * step : half;
        };
        const double up = i > 0 ? reach(i - 1) : half, down = i + 1 < samples.size() ? reach(i + 1) : half;
        hole.intervals.push_back(
            {samples[i].depth - up, samples[i].depth + down, samples[i].unit, samples[i].row, file});
    }
}

}  // namespace

std::optional<PointColumns> find_point_columns(const TableShape& shape, TableValues values) {
    if (!shape.has_header && shape.stated.empty()) return columns_by_place(shape);
    const auto unit = find_column(shape, Role::Unit);
    if (!unit) return std::nullopt;
    PointColumns columns{*unit,
                         find_column(shape, Role::X),
                         find_column(shape, Role::Y),
                         find_column(shape, Role::Z),
                         find_column(shape, Role::Hole),
                         find_column(shape, Role::Depth)};
    if (columns.hole == columns.unit) columns.hole.reset();
    if (values == TableValues::Depth && columns.depth) columns.z.reset();
    const bool placed = columns.x && columns.y && columns.z, in_hole = columns.hole && columns.depth;
    if (!placed && !in_hole) return std::nullopt;
    return columns;
}

bool looks_like_samples(const TableShape& shape, const PointColumns& columns) {
    if (!columns.hole) return false;
    std::set<std::pair<std::string, std::string>> met;
    std::size_t rows = 0;
    for (std::size_t row = shape.first_row; row < shape.row_count() && rows < 5000; ++row, ++rows)
        met.emplace(shape.table->cell(row, *columns.hole), shape.table->cell(row, columns.unit));
    return rows >= 10 && rows > 2 * met.size();
}

void read_points(const TableShape& shape, const PointColumns& columns, const CollarTable* collars,
                 ContactSet& contacts, TableContext& context) {
    const std::uint32_t file = file_number(contacts.files, shape.table->source);
    Numbering units(contacts.units);
    PointReader(shape, columns, collars, context).read([&](const PlacedPoint& point) {
        contacts.points.push_back(
            {point.at, point.z, units(point.unit), point.hole, point.ground, point.line, file});
    });
}

void read_samples(const TableShape& shape, const PointColumns& columns, const CollarTable* collars,
                  LogSet& logs, TableContext& context) {
    const std::uint32_t file = file_number(logs.files, shape.table->source);
    Numbering units(logs.units);
    std::vector<std::string> ids;
    Numbering holes(ids);
    const std::size_t first = logs.holes.size();
    std::vector<std::vector<Sample>> samples;
    PointReader(shape, columns, collars, context).read([&](const PlacedPoint& point) {
        const std::size_t hole = holes(point.hole);
        if (hole == samples.size()) {
            samples.emplace_back();
            logs.holes.push_back({point.hole, point.at, point.ground, {}, point.line, file});
        }
        samples[hole].push_back({-point.z, units(point.unit), point.line});
    });
    for (auto& hole : samples)
        std::stable_sort(hole.begin(), hole.end(),
                         [](const Sample& a, const Sample& b) { return a.depth < b.depth; });
    const double spacing = usual_spacing(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        HoleLog& hole = logs.holes[first + i];
        if (!hole.ground) hole.ground = 0.5 * spacing - samples[i].front().depth;
        for (Sample& sample : samples[i]) sample.depth += *hole.ground;
        add_sample_intervals(samples[i], spacing, file, hole);
    }
}

}  // namespace stratareeb
