// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_true_volumes.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "boreholes/errors.h"
#include "io/checked_json.h"

namespace stratareeb {

TrueVolumes read_true_volumes(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw IoError(file + ": can't be opened for reading");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const nlohmann::json json = parse_json(text, file);
    FileFaults faults(file);
    const JsonItem root(json, "", faults);
    TrueVolumes truth;
    if (root.need_object("the truth of a sample")) {
        if (const auto box = root.need("box")) {
            const auto corners = box->numbers();
            if (corners && corners->size() == 4 && (*corners)[0] < (*corners)[2] &&
                (*corners)[1] < (*corners)[3]) {
                const double x0 = (*corners)[0], y0 = (*corners)[1], x1 = (*corners)[2], y1 = (*corners)[3];
                truth.footprint = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
            } else if (corners) {
                box->expected("x0, y0, x1, y1 of a box with an area");
            }
        }
        if (const auto units = root.need("units"))
            for (const JsonItem& unit : units->list("a list of units")) {
                const auto code = unit.need("code"), volume = unit.need("volume");
                truth.codes.push_back(code ? code->text().value_or("") : "");
                truth.volumes.push_back(volume ? volume->number().value_or(0) : 0);
            }
    }
    faults.throw_if_any();
    return truth;
}

}  // namespace stratareeb
