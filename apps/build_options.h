// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "apps/rule_options.h"
#include "io/read_boreholes.h"
#include "io/write_step.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! Options that say how to read a borehole table, the same in every command that reads one.
struct TableArguments {
    std::vector<std::string> tables;
    ReadBoreholesOptions read;
};
void add_table_options(CLI::App& command, TableArguments& arguments);

//! Levels of refinement for a number of holes that leave a model people can handle; 0 for very many.
int suitable_refinement(std::size_t holes);

//! Options of `build`.
struct BuildArguments {
    TableArguments table;
    RuleArguments rules;
    std::string faults;
    std::string output, ground, footprint = "hull", spacing = "auto",
                                interpolator{name_of(kDefaultInterpolator)}, pinch_out = "half",
                                refine = "auto";
    std::vector<std::string> formats;
    std::string crs;      // of the coordinates; empty = the input's own, if it states one
    std::string deliver;  // folder to hand over; empty = none
    NormalWeight normals = NormalWeight::Uniform;
    StepKind step = StepKind::Faceted;
    double margin = -1;           // < 0 = suitable_margin
    double decimate = -1;         // largest error; < 0 = not by error
    std::size_t decimate_to = 0;  // plan triangles; 0 = not by number
    bool overwrite = false, json = false, quiet = false, ignore_memory = false;

    bool wants(const std::string& format) const;
    //! The options as words, for model.json.
    std::map<std::string, std::string> record() const;
};
void add_build_options(CLI::App& command, BuildArguments& arguments);

}  // namespace stratareeb
