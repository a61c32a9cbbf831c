// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_holes.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "io/checked_json.h"
#include "io/text_scanner.h"
#include "io/write_aside.h"

namespace stratareeb {

namespace {

using Json = nlohmann::ordered_json;

Json fact_json(const LayerFact& fact) {
    if (fact.knowledge == Knowledge::Unknown) return {};
    if (fact.knowledge == Knowledge::AtLeast) return {{"at_least", fact.thickness}};
    return fact.thickness;
}

Json hole_json(const Borehole& hole, std::uint32_t vertex) {
    Json json{{"id", hole.id}, {"row", hole.row}, {"x", hole.at.x}, {"y", hole.at.y}};
    json["vertex"] = vertex == PlanMesh::kNoVertex ? Json() : Json(vertex);
    json["horizons"] = Json::array();
    for (const auto& z : hole.horizons) json["horizons"].push_back(z ? Json(*z) : Json());
    json["layers"] = Json::array();
    for (const LayerFact& fact : hole.layers) json["layers"].push_back(fact_json(fact));
    return json;
}

//! Reads one hole; what is wrong with it becomes a fault with its place.
class HoleReader {
 public:
    HoleReader(std::size_t units, std::size_t plan_vertices) : units_(units), plan_vertices_(plan_vertices) {}

    Borehole read(const JsonItem& item, std::uint32_t& vertex) const {
        Borehole hole;
        if (!item.need_object("a hole")) return hole;
        if (const auto id = item.need("id")) hole.id = id->text().value_or("");
        if (const auto row = item.find("row"))
            hole.row = static_cast<std::size_t>(row->whole_number().value_or(0));
        if (const auto x = item.need("x")) hole.at.x = x->number().value_or(0);
        if (const auto y = item.need("y")) hole.at.y = y->number().value_or(0);
        vertex = vertex_of(item);
        if (const auto list = item.need("horizons"))
            for (const JsonItem& z : entries(*list, units_ + 1))
                hole.horizons.push_back(z.is_null() ? std::nullopt : z.number());
        if (const auto list = item.need("layers"))
            for (const JsonItem& fact : entries(*list, units_)) hole.layers.push_back(fact_of(fact));
        return hole;
    }

 private:
    static std::vector<JsonItem> entries(const JsonItem& list, std::size_t count) {
        auto items = list.list("numbers");
        if (items.size() != count)
            list.fault(fmt::format("has {} entries (expected {})", items.size(), count));
        return items;
    }

    std::uint32_t vertex_of(const JsonItem& item) const {
        const auto vertex = item.find("vertex");
        if (!vertex || vertex->is_null()) return PlanMesh::kNoVertex;
        const auto number = vertex->whole_number();
        if (number && *number >= 0 && static_cast<std::size_t>(*number) < plan_vertices_)
            return static_cast<std::uint32_t>(*number);
        if (number) vertex->expected(fmt::format("a vertex below {}", plan_vertices_));
        return PlanMesh::kNoVertex;
    }

    static LayerFact fact_of(const JsonItem& item) {
        if (item.is_null()) return {};
        LayerFact fact{Knowledge::Measured, 0};
        const bool bound = item.is_object();
        const auto number = bound ? item.need("at_least") : std::optional(item);
        if (bound) fact.knowledge = Knowledge::AtLeast;
        if (number) fact.thickness = number->number().value_or(0);
        if (fact.thickness < 0) item.expected("a thickness of 0 or more");
        return fact;
    }

    std::size_t units_, plan_vertices_;
};

}  // namespace

void write_model_holes(const std::filesystem::path& file, const Survey& survey,
                       const std::vector<std::uint32_t>& vertex) {
    write_aside(file, [&](std::ostream& out) {
        out << "{\"contact_points\": " << (survey.contact_points ? "true" : "false") << ", \"holes\": [";
        for (std::size_t h = 0; h < survey.holes.size(); ++h)
            out << (h == 0 ? "\n" : ",\n")
                << hole_json(survey.holes[h], vertex[h]).dump(-1, ' ', false, Json::error_handler_t::replace);
        out << "\n]}\n";
    });
}

ModelHoles read_model_holes(const std::filesystem::path& file, const std::vector<Unit>& units,
                            std::size_t plan_vertices) {
    const nlohmann::json json = parse_json(file_content(file), file.string());
    FileFaults faults(file.string());
    const JsonItem root(json, "", faults);
    ModelHoles result;
    result.survey.units = units;
    if (root.need_object("boreholes")) {
        if (const auto points = root.find("contact_points"))
            result.survey.contact_points = points->flag().value_or(false);
        const HoleReader reader(units.size(), plan_vertices);
        if (const auto holes = root.need("holes"))
            for (const JsonItem& item : holes->list("holes")) {
                std::uint32_t vertex = PlanMesh::kNoVertex;
                result.survey.holes.push_back(reader.read(item, vertex));
                result.vertex.push_back(vertex);
            }
    }
    faults.throw_if_any();
    return result;
}

}  // namespace stratareeb
