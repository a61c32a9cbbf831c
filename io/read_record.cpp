// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_record.h"

#include <nlohmann/json.hpp>

#include "io/checked_json.h"
#include "io/text_scanner.h"

namespace stratareeb {
namespace {

double number(const JsonItem& item, std::string_view key) {
    const auto member = item.need(key);
    return member ? member->number().value_or(0) : 0;
}

std::size_t count(const JsonItem& item, std::string_view key) {
    const double value = number(item, key);
    return value > 0 ? static_cast<std::size_t>(value) : 0;
}

std::string text(const JsonItem& item, std::string_view key) {
    const auto member = item.need(key);
    return member ? member->text().value_or("") : "";
}

UnitSummary unit(const JsonItem& item) {
    UnitSummary summary;
    summary.volume = number(item, "volume");
    summary.area = number(item, "area");
    summary.plan_area = number(item, "plan_area");
    summary.mean_thickness = number(item, "mean_thickness");
    summary.max_thickness = number(item, "max_thickness");
    summary.triangles = count(item, "triangles");
    summary.components = count(item, "components");
    summary.genus = count(item, "genus");
    summary.holes_present = count(item, "holes_present");
    summary.holes_absent = count(item, "holes_absent");
    summary.holes_unknown = count(item, "holes_unknown");
    summary.holes_at_least = count(item, "holes_at_least");
    return summary;
}

SmoothnessReport smoothness(const JsonItem& item) {
    const auto values = [](const std::optional<JsonItem>& part) {
        Smoothness smoothness;
        if (!part) return smoothness;
        smoothness.largest_jump_deg = number(*part, "largest_jump_deg");
        smoothness.bending_energy = number(*part, "bending_energy");
        return smoothness;
    };
    SmoothnessReport report;
    report.levels = static_cast<int>(count(item, "levels"));
    report.before = values(item.need("before"));
    report.after = values(item.need("after"));
    report.largest_misfit = number(item, "largest_misfit");
    report.thinnest = number(item, "thinnest");
    return report;
}

std::map<std::string, std::string> options(const nlohmann::json& json) {
    std::map<std::string, std::string> options;
    const auto found = json.find("options");
    if (found == json.end() || !found->is_object()) return options;
    for (const auto& [name, value] : found->items())
        options[name] = value.is_string() ? value.get<std::string>() : value.dump();
    return options;
}

}  // namespace

SavedRecord read_record(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "model.json";
    const nlohmann::json json = parse_json(file_content(file), file.string());
    FileFaults faults(file.string());
    const JsonItem root(json, "", faults);
    SavedRecord saved;
    if (root.need_object("a model")) {
        saved.envelope_volume = number(root, "envelope_volume");
        if (const auto list = root.need("units"))
            for (const JsonItem& item : list->list("units"))
                if (item.need_object("a unit")) saved.record.units.push_back(unit(item));
        if (const auto list = root.need("checks"))
            for (const JsonItem& item : list->list("checks")) {
                if (!item.need_object("a check")) continue;
                const auto ok = item.need("ok");
                saved.record.checks.push_back(
                    {text(item, "name"), ok && ok->flag().value_or(false), text(item, "detail")});
            }
        if (const auto misfit = root.need("misfit"); misfit && misfit->need_object("a misfit"))
            saved.misfit = {number(*misfit, "max"), number(*misfit, "rms"), count(*misfit, "contacts")};
        if (const auto part = root.find("smoothness"); part && part->need_object("a smoothness"))
            saved.record.smoothness = smoothness(*part);
        if (const auto list = root.find("warnings"))
            for (const JsonItem& item : list->list("warnings"))
                saved.record.warnings.push_back(item.text().value_or(""));
        if (const auto list = root.find("files"))
            for (const JsonItem& item : list->list("files"))
                saved.record.files.push_back(item.text().value_or(""));
        saved.record.options = options(json);
    }
    faults.throw_if_any();
    return saved;
}

}  // namespace stratareeb
