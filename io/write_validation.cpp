// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_validation.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace stratareeb {

namespace {

using Json = nlohmann::ordered_json;

//! JSON has no infinity.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json as_json(const ErrorSummary& errors) {
    return {{"count", errors.count},
            {"mean", errors.mean},
            {"deviation", errors.deviation},
            {"rmse", errors.rmse},
            {"mae", errors.mae},
            {"median", errors.median},
            {"median_size", errors.median_size},
            {"largest", errors.largest}};
}

Json as_json(const MeanTest& test) {
    return {{"values", test.values},
            {"units", test.units},
            {"mean", test.mean},
            {"standard_error", test.standard_error},
            {"statistic", number(test.statistic)},
            {"p", test.p},
            {"low", number(test.low)},
            {"high", number(test.high)}};
}

Json as_json(const ZTest& test, double p) {
    return {{"mean_actual", test.mean_actual},
            {"mean_predicted", test.mean_predicted},
            {"deviation_actual", test.deviation_actual},
            {"deviation_predicted", test.deviation_predicted},
            {"z", number(test.z)},
            {"p", p}};
}

Json as_json(const ItemValidation& item) {
    Json json{{"name", item.name}};
    json.update(as_json(item.errors));
    json["inside"] = as_json(item.inside);
    json["z_test"] = as_json(item.z, item.z_p);
    json["bias"] = as_json(item.bias);
    json["interval"] = {{"coverage", item.coverage()},
                        {"mean_half_width", item.mean_half_width},
                        {"enough_errors", item.certain}};
    return json;
}

Json layer_json(const ItemValidation& item, const Unit& unit, std::size_t order) {
    Json json{{"order", order}, {"code", unit.code}};
    json.update(as_json(item));
    json["presence_right"] = item.presence_right;
    json["bounds"] = {
        {"count", item.bounds.bounds}, {"below", item.bounds.below}, {"shortfall", item.bounds.shortfall}};
    return json;
}

Json result_json(const Survey& survey, const NamedValidation& validation) {
    const Validation& result = validation.result;
    Json json{
        {"interpolator", validation.name}, {"crossings", result.crossings}, {"coverage", result.coverage}};
    json["pooled"] = as_json(result.pooled);
    json["pooled_naive"] = as_json(result.pooled_naive);
    json["units_right"] = result.layers.empty() ? Json() : Json(result.units.share_right());
    json["layers"] = Json::array();
    for (std::size_t i = 0; i < result.layers.size(); ++i)
        json["layers"].push_back(layer_json(result.layers[i], survey.units[i], i + 1));
    json["horizons"] = Json::array();
    for (const ItemValidation& item : result.horizons) json["horizons"].push_back(as_json(item));
    json["unit_lengths"] = result.units.length;
    json["next_boreholes"] = Json::array();
    for (const NextBorehole& next : result.next)
        json["next_boreholes"].push_back({{"x", next.at.x},
                                          {"y", next.at.y},
                                          {"expected_error", next.expected_error},
                                          {"area", next.area},
                                          {"benefit", next.benefit()}});
    return json;
}

void add_errors(OutputTable& table, const std::string& interpolator, const char* quantity,
                const ItemValidation& item) {
    std::vector<OutputCell> row{interpolator, std::string(quantity), item.name};
    for (const double value : {static_cast<double>(item.errors.count),
                               item.errors.mean,
                               item.errors.rmse,
                               item.errors.mae,
                               item.errors.median,
                               item.errors.median_size,
                               item.errors.largest,
                               static_cast<double>(item.inside.count),
                               item.inside.rmse,
                               item.z.mean_actual,
                               item.z.mean_predicted,
                               item.z.deviation_actual,
                               item.z.deviation_predicted,
                               item.z.z,
                               item.z_p,
                               item.bias.low,
                               item.bias.high,
                               item.bias.p,
                               item.coverage(),
                               item.mean_half_width})
        std::isfinite(value) ? row.emplace_back(value) : row.emplace_back();
    table.rows.push_back(std::move(row));
}

//! Every residual with its quantity and interval, in the order of held-out holes.
template <class Visit>
void for_each_residual(const Validation& result, Visit&& visit) {
    struct Entry {
        const ItemValidation* item;
        const char* quantity;
        std::size_t at;
    };
    std::vector<Entry> entries;
    for (const ItemValidation& item : result.layers)
        for (std::size_t i = 0; i < item.residuals.size(); ++i) entries.push_back({&item, "thickness", i});
    for (const ItemValidation& item : result.horizons)
        for (std::size_t i = 0; i < item.residuals.size(); ++i) entries.push_back({&item, "elevation", i});
    std::ranges::stable_sort(entries, {}, [](const Entry& e) { return e.item->residuals[e.at].held; });
    for (const Entry& entry : entries)
        visit(*entry.item, entry.quantity, entry.item->residuals[entry.at], entry.item->half_width[entry.at]);
}

//! A thickness is never below 0.
double interval_low(const char* quantity, const Residual& residual, double half_width) {
    const double low = residual.predicted - half_width;
    return *quantity == 't' ? std::max(low, 0.0) : low;
}

double error_per_cent(double modelled, double actual) {
    return actual == 0 ? 0 : 100 * (modelled - actual) / actual;
}

}  // namespace

Json validation_json(const Survey& survey, const std::vector<NamedValidation>& validations,
                     const ValidationRecord& record) {
    Json json{{"boreholes", survey.holes.size()}, {"length_unit", survey.length_unit}};
    const Validation& first = validations.front().result;
    json["hold_out"] = {
        {"way", record.hold_out}, {"draws", first.draws.size()}, {"left_out", first.held.size()}};
    json["confidence"] = record.confidence;
    json["law"] = record.law;
    json["units"] = Json::array();
    for (const Unit& unit : survey.units) json["units"].push_back(unit.code);
    json["interpolators"] = Json::array();
    for (const NamedValidation& validation : validations)
        json["interpolators"].push_back(result_json(survey, validation));
    json["warnings"] = record.warnings;
    return json;
}

OutputTable errors_table(const std::vector<NamedValidation>& validations) {
    OutputTable table{{"interpolator",
                       "quantity",
                       "item",
                       "count",
                       "mean_error",
                       "rmse",
                       "mae",
                       "median_error",
                       "median_size",
                       "largest",
                       "inside_count",
                       "inside_rmse",
                       "mean_actual",
                       "mean_predicted",
                       "sd_actual",
                       "sd_predicted",
                       "z",
                       "z_p",
                       "bias_low",
                       "bias_high",
                       "bias_p",
                       "coverage",
                       "mean_half_width"},
                      {}};
    for (const NamedValidation& validation : validations) {
        for (const ItemValidation& item : validation.result.layers)
            add_errors(table, validation.name, "thickness", item);
        for (const ItemValidation& item : validation.result.horizons)
            add_errors(table, validation.name, "elevation", item);
    }
    return table;
}

OutputTable residuals_table(const Survey& survey, const NamedValidation& validation) {
    OutputTable table{{"hole", "x", "y", "draw", "inside", "quantity", "item", "actual", "predicted", "error",
                       "low", "high"},
                      {}};
    for_each_residual(validation.result, [&](const ItemValidation& item, const char* quantity,
                                             const Residual& residual, double half_width) {
        const Borehole& hole = survey.holes[residual.hole];
        table.rows.push_back({hole.id, hole.at.x, hole.at.y, static_cast<double>(residual.draw + 1),
                              residual.inside ? 1.0 : 0.0, std::string(quantity), item.name, residual.actual,
                              residual.predicted, residual.error(),
                              interval_low(quantity, residual, half_width), residual.predicted + half_width});
    });
    return table;
}

std::vector<MapFeature> residual_features(const Survey& survey, const NamedValidation& validation) {
    std::vector<MapFeature> features;
    for_each_residual(validation.result, [&](const ItemValidation& item, const char* quantity,
                                             const Residual& residual, double half_width) {
        const Borehole& hole = survey.holes[residual.hole];
        MapFeature feature{.kind = MapFeature::Kind::Point,
                           .parts = {{{hole.at.x, hole.at.y, 0}}},
                           .layer = std::string(quantity) + " " + item.name,
                           .color = residual.error() < 0 ? "#b2182b" : "#2166ac"};
        feature.attributes = {{"hole", hole.id},
                              {"draw", static_cast<double>(residual.draw + 1)},
                              {"actual", residual.actual},
                              {"predicted", residual.predicted},
                              {"error", residual.error()},
                              {"low", interval_low(quantity, residual, half_width)},
                              {"high", residual.predicted + half_width}};
        features.push_back(std::move(feature));
    });
    return features;
}

OutputTable unit_match_table(const Survey& survey, const NamedValidation& validation) {
    OutputTable table{{"drilled"}, {}};
    for (const Unit& unit : survey.units) table.columns.push_back(unit.code);
    table.columns.push_back("below the model");
    for (std::size_t unit = 0; unit < survey.units.size(); ++unit) {
        std::vector<OutputCell> row{survey.units[unit].code};
        for (const double length : validation.result.units.length[unit]) row.emplace_back(length);
        table.rows.push_back(std::move(row));
    }
    return table;
}

OutputTable next_boreholes_table(const NamedValidation& validation) {
    OutputTable table{{"rank", "x", "y", "expected_error", "area", "benefit"}, {}};
    for (const NextBorehole& next : validation.result.next)
        table.rows.push_back({static_cast<double>(table.rows.size() + 1), next.at.x, next.at.y,
                              next.expected_error, next.area, next.benefit()});
    return table;
}

OutputTable volumes_table(const TrueVolumes& truth, const std::vector<ComparedModel>& models) {
    OutputTable table{{"layer", "actual"}, {}};
    for (const ComparedModel& model : models) {
        const std::string name = model.name + " (" + std::to_string(model.holes) + " holes)";
        table.columns.push_back(name);
        table.columns.push_back(name + ", error %");
    }
    double sum = 0;
    for (std::size_t i = 0; i < truth.codes.size(); ++i) {
        std::vector<OutputCell> row{truth.codes[i], truth.volumes[i]};
        for (const ComparedModel& model : models) {
            row.emplace_back(model.volumes[i]);
            row.emplace_back(error_per_cent(model.volumes[i], truth.volumes[i]));
        }
        table.rows.push_back(std::move(row));
        sum += truth.volumes[i];
    }
    std::vector<OutputCell> all{std::string("all"), sum};
    for (const ComparedModel& model : models) {
        all.emplace_back(model.envelope);
        all.emplace_back(error_per_cent(model.envelope, sum));
    }
    table.rows.push_back(std::move(all));
    return table;
}

Json volumes_json(const TrueVolumes& truth, const std::vector<ComparedModel>& models) {
    Json json{{"layers", truth.codes}, {"actual", truth.volumes}, {"models", Json::array()}};
    for (const ComparedModel& model : models) {
        Json errors = Json::array();
        for (std::size_t i = 0; i < truth.volumes.size(); ++i)
            errors.push_back(error_per_cent(model.volumes[i], truth.volumes[i]));
        json["models"].push_back({{"table", model.name},
                                  {"boreholes", model.holes},
                                  {"volumes", model.volumes},
                                  {"error_per_cent", errors},
                                  {"envelope", model.envelope}});
    }
    return json;
}

}  // namespace stratareeb
