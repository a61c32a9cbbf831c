// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/write_validation.h"

namespace stratareeb {

struct ReportOptions {
    std::string title = {};     // over the report; empty = "Layer model"
    bool for_delivery = false;  // sections and maps as PDF and for CAD and GIS too (.dxf, .gpkg)
    std::string crs = {};       // of the model, for GIS files, as "EPSG:27700"
    std::vector<std::vector<std::string>> fences = {};  // names of boreholes, for sections through them
    bool validate = true;                               // hold boreholes out, ten-fold
    std::size_t most_validated = 2000;                  // surveys of more boreholes are not, it takes long
    std::uint64_t seed = 1;                             // of the folds
    std::map<std::string, std::string>
        build_options{};  // of the model: interpolator and pinch-out rule hold for validation
    //! Called with what is being drawn and its share (0..1) of all.
    std::function<void(const std::string& step, double share)> progress = {};
};

//! A drawing of a report.
struct ReportFigure {
    std::string file;  // relative: "sections/west_east.svg"; empty = there is none
    std::string caption;
    std::vector<std::string> others = {};  // the same in other formats
};

//! The drawings that explain a model, in the order of a report.
struct ReportFigures {
    ReportFigure model;
    std::vector<ReportFigure> layers;  // of each unit; none where absent
    std::vector<ReportFigure> sections, maps, graphs, errors;
    std::optional<NamedValidation> validation;
    std::string validation_note;  // how, or why not
};

//! Draw a saved model: the whole, each layer, sections west to east and south to north through the middle of the boreholes and
//! along fences, the geological map, the ground, each layer's thickness and (up to 12 layers) its base, the Reeb graph of
//! each layer's height, and errors of boreholes held out.
//! `add`: where to write a file of that relative name.
//! \throw InvalidInput for a fence through a borehole that is not there; IoError if a file can't be written
ReportFigures write_report_figures(const SavedModel& saved, const ReportOptions& options,
                                   const std::function<std::filesystem::path(const std::string&)>& add);

}  // namespace stratareeb
