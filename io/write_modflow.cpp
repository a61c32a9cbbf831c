// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_modflow.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "io/text_output.h"
#include "io/write_aside.h"
#include "io/write_table.h"

namespace stratareeb {

namespace {

template <class Value>
void write_array(StagedFolder& folder, const std::string& name, const PlanGrid& plan,
                 const std::vector<Value>& values) {
    write_aside(folder.add(name), [&](std::ostream& stream) {
        TextOutput out(stream);
        for (std::size_t i = 0; i < values.size(); ++i)
            out.print("{}{}", values[i], (i + 1) % plan.columns == 0 ? "\n" : " ");
    });
}

//! MODFLOW 6 knows feet, metres and centimetres.
const char* length_words(const std::string& unit) {
    return unit == "m" ? "METERS" : unit == "ft" || unit == "us-ft" ? "FEET" : "UNKNOWN";
}

std::string discretisation(const FlowGrid& grid, const LayerModel& model) {
    const PlanGrid& plan = grid.plan;
    std::string text = fmt::format(
        "# One layer a unit; layers.csv names them.\n"
        "BEGIN OPTIONS\n  LENGTH_UNITS {}\n  XORIGIN {}\n  YORIGIN {}\nEND OPTIONS\n\n"
        "BEGIN DIMENSIONS\n  NLAY {}\n  NROW {}\n  NCOL {}\nEND DIMENSIONS\n\n"
        "BEGIN GRIDDATA\n  DELR\n    CONSTANT {}\n  DELC\n    CONSTANT {}\n  TOP\n    OPEN/CLOSE top.txt\n",
        length_words(model.length_unit), plan.north_west.x,
        plan.north_west.y - plan.cell * static_cast<double>(plan.rows), model.units.size(), plan.rows,
        plan.columns, plan.cell, plan.cell);
    for (const char* array : {"botm", "idomain"}) {
        text += fmt::format("  {} LAYERED\n", std::string_view(array) == "botm" ? "BOTM" : "IDOMAIN");
        for (std::size_t i = 0; i < model.units.size(); ++i)
            text += fmt::format("    OPEN/CLOSE {}_{:02}.txt\n", array, i + 1);
    }
    return text + "END GRIDDATA\n";
}

}  // namespace

FlowGrid flow_grid(const LayerModel& model, const PlanGrid& plan, double thinnest) {
    std::vector<const std::vector<double>*> fields;
    for (const auto& horizon : model.horizons) fields.push_back(&horizon);
    auto horizons = rasterized(model, plan, fields);
    FlowGrid grid{.plan = plan, .top = {}, .bottom = {}, .idomain = {}};
    const std::size_t cells = grid.cells();
    grid.idomain.assign(model.units.size(), std::vector<int>(cells, 0));
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const bool inside = !std::isnan(horizons[0][cell]);
        for (auto& horizon : horizons) horizon[cell] = inside ? horizon[cell] + model.origin.z : 0;
        for (std::size_t i = 0; inside && i < model.units.size(); ++i) {
            const double thickness = horizons[i][cell] - horizons[i + 1][cell];
            grid.idomain[i][cell] = thickness > 0 && thickness >= thinnest ? 1 : -1;
        }
    }
    grid.top = std::move(horizons[0]);
    for (std::size_t i = 0; i < model.units.size(); ++i) grid.bottom.push_back(std::move(horizons[i + 1]));
    return grid;
}

void write_modflow(StagedFolder& folder, const FlowGrid& grid, const LayerModel& model) {
    write_aside(folder.add("model.dis"), [&](std::ostream& out) { out << discretisation(grid, model); });
    write_array(folder, "top.txt", grid.plan, grid.top);
    OutputTable layers{.columns = {"layer", "code", "name", "active_cells", "pass_through_cells"},
                       .rows = {}};
    for (std::size_t i = 0; i < model.units.size(); ++i) {
        write_array(folder, fmt::format("botm_{:02}.txt", i + 1), grid.plan, grid.bottom[i]);
        write_array(folder, fmt::format("idomain_{:02}.txt", i + 1), grid.plan, grid.idomain[i]);
        double active = 0, passed = 0;
        for (const int domain : grid.idomain[i]) {
            active += domain == 1;
            passed += domain == -1;
        }
        layers.rows.push_back(
            {static_cast<double>(i + 1), model.units[i].code, model.units[i].name, active, passed});
    }
    write_table(folder.add("layers.csv"), layers);
}

}  // namespace stratareeb
