// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "io/html_table.h"
#include "io/report_style.h"
#include "io/xml_text.h"

namespace stratareeb {
namespace {

constexpr std::size_t kShownHoles = 30;  // more are folded away

std::string escaped(const std::string& text) {
    return xml_attribute(text);
}

class Report {
 public:
    Report(const ReportParts& parts, const std::function<std::string(const std::string&)>& source)
        : parts_(parts),
          saved_(parts.saved),
          model_(saved_.model),
          record_(parts.record.record),
          source_(source),
          unit_(escaped(model_.length_unit)) {}

    std::string html() {
        const std::string title = escaped(parts_.title.empty() ? "Layer model" : parts_.title);
        put("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
            "content=\"width=device-width, "
            "initial-scale=1\">\n<title>{}</title>\n<style>{}</style></head>\n<body><main>\n",
            title, kReportStyle);
        put("<h1>{}</h1>\n", title);
        put_summary();
        put_layers();
        put_figures("Sections", "sections", parts_.figures.sections, "stack");
        put_figures("Maps", "maps", parts_.figures.maps);
        put_validation();
        put_checks();
        put_input();
        put_figures("Reeb graphs", "graphs", parts_.figures.graphs, "stack");
        put_options();
        put("</main></body></html>\n");
        return std::move(html_);
    }

 private:
    template <typename... Values>
    void put(fmt::format_string<Values...> form, Values&&... values) {
        fmt::format_to(std::back_inserter(html_), form, std::forward<Values>(values)...);
    }

    void heading(const char* text, const char* anchor) { put("<h2 id=\"{}\">{}</h2>\n", anchor, text); }

    void put_figure(const ReportFigure& figure) {
        if (figure.file.empty()) return;
        put("<figure><img decoding=\"async\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}",
            escaped(figure.caption), escaped(source_(figure.file)));
        for (const std::string& other : figure.others)
            put(" <a href=\"{}\">{}</a>", escaped(other), escaped(other.substr(other.rfind('.') + 1)));
        put("</figcaption></figure>\n");
    }

    void put_figures(const char* text, const char* anchor, const std::vector<ReportFigure>& figures,
                     const char* layout = "figures") {
        if (figures.empty()) return;
        heading(text, anchor);
        put("<div class=\"{}\">\n", layout);
        for (const ReportFigure& figure : figures) put_figure(figure);
        put("</div>\n");
    }

    void put_fact(const std::string& value, const std::string& name) {
        put("<div><b>{}</b><span>{}</span></div>\n", value, name);
    }

    void put_summary() {
        const auto ok = static_cast<std::size_t>(
            std::ranges::count_if(record_.checks, [](const ModelCheck& check) { return check.ok; }));
        double plan = 0;
        for (const UnitSummary& unit : record_.units) plan = std::max(plan, unit.plan_area);
        put("<div class=\"facts\">\n");
        put_fact(fmt::format("{}", saved_.survey.holes.size()), "boreholes");
        put_fact(fmt::format("{}", model_.units.size()), "layers");
        put_fact(fmt::format("{} {}³", grouped_number(parts_.record.envelope_volume, 4), unit_),
                 "volume of all layers");
        put_fact(misfit_text(parts_.record.misfit.max),
                 fmt::format("largest misfit at {} contacts", parts_.record.misfit.contacts));
        put_fact(fmt::format("{} of {}", ok, record_.checks.size()), "checks passed");
        put("</div>\n");
        if (!parts_.links.empty()) {
            put("<p>");
            for (const std::string& link : parts_.links) put("<a href=\"{0}\">{0}</a> ", escaped(link));
            put("</p>\n");
        }
        put_figure(parts_.figures.model);
    }

    //! What is smaller than rounding is not told digit by digit.
    std::string misfit_text(double misfit) const {
        constexpr double kNothing = 1e-9;
        return misfit < kNothing ? fmt::format("&lt; 1e-9 {}", unit_)
                                 : fmt::format("{:.2g} {}", misfit, unit_);
    }

    void put_layers() {
        heading("Layers", "layers");
        HtmlTable table({{"", false},
                         {"layer", false},
                         {"code", false},
                         {fmt::format("volume<br>[{}³]", unit_)},
                         {fmt::format("area in plan<br>[{}²]", unit_)},
                         {fmt::format("mean<br>thickness [{}]", unit_)},
                         {fmt::format("largest<br>[{}]", unit_)},
                         {"bodies"},
                         {"holes with /<br>without / unknown"},
                         {"", false}});
        for (std::size_t i = 0; i < std::min(record_.units.size(), model_.units.size()); ++i) {
            const Unit& unit = model_.units[i];
            const UnitSummary& sum = record_.units[i];
            const ReportFigure& picture = parts_.figures.layers[i];
            table.add({fmt::format("<i style=\"background:{}\"></i>{}", escaped(unit.color), i + 1),
                       escaped(unit.name), escaped(unit.code), grouped_number(sum.volume, 6),
                       grouped_number(sum.plan_area, 6), grouped_number(sum.mean_thickness, 4),
                       grouped_number(sum.max_thickness, 4), fmt::format("{}", sum.components),
                       fmt::format("{} / {} / {}", sum.holes_present, sum.holes_absent, sum.holes_unknown),
                       picture.file.empty()
                           ? std::string("absent")
                           : fmt::format("<img class=\"small\" alt=\"{}\" src=\"{}\">",
                                         escaped(picture.caption), escaped(source_(picture.file)))});
        }
        table.add({"", "<b>all</b>", "",
                   fmt::format("<b>{}</b>", grouped_number(parts_.record.envelope_volume, 6)), "", "", "", "",
                   "", ""});
        html_ += table.html();
    }

    void put_checks() {
        heading("Checks", "checks");
        put("<table><tbody>\n");
        for (const ModelCheck& check : record_.checks)
            put("<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n", check.ok ? "good" : "bad",
                check.ok ? "passed" : "failed", escaped(words(check.name)), escaped(check.detail));
        put("</tbody></table>\n");
        if (!record_.smoothness) return;
        const SmoothnessReport& smooth = *record_.smoothness;
        put("<p>Surfaces were refined {} times; the largest angle between neighbouring normals went from "
            "{:.3g}° to {:.3g}°, "
            "the bending energy from {:.4g} to {:.4g}.</p>\n",
            smooth.levels, smooth.before.largest_jump_deg, smooth.after.largest_jump_deg,
            smooth.before.bending_energy, smooth.after.bending_energy);
    }

    static std::string words(std::string name) {
        std::ranges::replace(name, '_', ' ');
        return name;
    }

    void put_input() {
        heading("What went in", "input");
        if (record_.warnings.empty())
            put("<p>Nothing in the tables had to be worked around.</p>\n");
        else {
            put("<p>Worked around, or assumed:</p>\n<ul>\n");
            for (const std::string& warning : record_.warnings) put("<li>{}</li>\n", escaped(warning));
            put("</ul>\n");
        }
        if (saved_.survey.holes.empty()) return;
        const bool many = saved_.survey.holes.size() > kShownHoles;
        if (many) put("<details><summary>The {} boreholes</summary>\n", saved_.survey.holes.size());
        put_holes();
        put("<p class=\"note\">Thickness of each layer; ≥: the borehole ended in it; ?: not known.</p>\n");
        if (many) put("</details>\n");
    }

    void put_holes() {
        std::vector<HtmlColumn> columns{{"borehole", false},
                                        {fmt::format("x [{}]", unit_)},
                                        {fmt::format("y [{}]", unit_)},
                                        {fmt::format("ground [{}]", unit_)}};
        for (const Unit& unit : model_.units) columns.push_back({escaped(unit.name)});
        HtmlTable table(columns);
        for (const Borehole& hole : saved_.survey.holes) {
            const bool has_ground = !hole.horizons.empty() && hole.horizons[0];
            std::vector<std::string> cells{escaped(hole.id), fmt::format("{:.10g}", hole.at.x),
                                           fmt::format("{:.10g}", hole.at.y),
                                           has_ground ? fmt::format("{:.6g}", *hole.horizons[0]) : "?"};
            for (const LayerFact& fact : hole.layers)
                cells.push_back(fact.knowledge == Knowledge::Unknown
                                    ? "?"
                                    : fmt::format("{}{:.4g}",
                                                  fact.knowledge == Knowledge::AtLeast ? "≥ " : "",
                                                  fact.thickness));
            table.add(cells);
        }
        html_ += table.html();
    }

    void put_validation() {
        heading("How well boreholes predict boreholes", "validation");
        put("<p>{}</p>\n", escaped(parts_.figures.validation_note));
        if (!parts_.figures.validation) return;
        const Validation& result = parts_.figures.validation->result;
        HtmlTable table({{"", false},
                         {"", false},
                         {"boreholes"},
                         {fmt::format("mean error<br>[{}]", unit_)},
                         {fmt::format("RMSE<br>[{}]", unit_)},
                         {fmt::format("MAE<br>[{}]", unit_)},
                         {fmt::format("median<br>[{}]", unit_)},
                         {fmt::format("95 % of mean<br>[{}]", unit_)},
                         {"within 95 %<br>intervals"}});
        add_items(table, "thickness", result.layers);
        add_items(table, "elevation", result.horizons);
        html_ += table.html();
        put("<p>Values within their 95 % intervals: {:.1f} %. Horizons that cross: "
            "{}.",
            100 * result.coverage, result.crossings);
        if (!result.layers.empty())
            put(" Unit right at depth: {:.1f} % of the drilled length.", 100 * result.units.share_right());
        put("</p>\n");
        if (!result.next.empty()) {
            put("<p>Further boreholes would help most at");
            for (std::size_t i = 0; i < result.next.size(); ++i)
                put("{} ({:.10g}, {:.10g})", i > 0 ? "," : "", result.next[i].at.x, result.next[i].at.y);
            put(".</p>\n");
        }
        put("<div class=\"stack\">\n");
        for (const ReportFigure& figure : parts_.figures.errors) put_figure(figure);
        put("</div>\n");
    }

    static void add_items(HtmlTable& table, const char* quantity, const std::vector<ItemValidation>& items) {
        for (const ItemValidation& item : items) {
            if (item.errors.count == 0) continue;
            table.add({quantity, escaped(item.name), fmt::format("{}", item.errors.count),
                       fmt::format("{:.3g}", item.errors.mean), fmt::format("{:.3g}", item.errors.rmse),
                       fmt::format("{:.3g}", item.errors.mae), fmt::format("{:.3g}", item.errors.median),
                       fmt::format("{:.3g} to {:.3g}", item.bias.low, item.bias.high),
                       fmt::format("{:.1f} %", 100 * item.coverage())});
        }
    }

    void put_options() {
        heading("Options and files", "options");
        put("<div class=\"wide\"><table><tbody>\n");
        for (const auto& [name, value] : record_.options)
            if (!value.empty())
                put("<tr><td>{}</td><td>{}</td></tr>\n", escaped(words(name)), escaped(value));
        put("</tbody></table></div>\n<p>Coordinates in the meshes are relative to {:.12g}, {:.12g}, "
            "{:.12g}.</p>\n<p>",
            model_.origin.x, model_.origin.y, model_.origin.z);
        for (const std::string& file : record_.files) put("<code>{}</code> ", escaped(file));
        put("</p>\n");
    }

    const ReportParts& parts_;
    const SavedModel& saved_;
    const LayerModel& model_;
    const ModelRecord& record_;
    const std::function<std::string(const std::string&)>& source_;
    std::string unit_, html_;
};

}  // namespace

std::string report_html(const ReportParts& parts,
                        const std::function<std::string(const std::string& file)>& source) {
    return Report(parts, source).html();
}

}  // namespace stratareeb
