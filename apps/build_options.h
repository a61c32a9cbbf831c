// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "io/read_boreholes.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! Options that say how to read a borehole table, the same in every command that reads one.
struct TableArguments {
    std::vector<std::string> tables;
    ReadBoreholesOptions read;
};
void add_table_options(CLI::App& command, TableArguments& arguments);

//! Options of `build`.
struct BuildArguments {
    TableArguments table;
    std::string output, ground, footprint = "hull", spacing = "auto", interpolator = "natural",
                                pinch_out = "half";
    std::vector<std::string> formats;
    NormalWeight normals = NormalWeight::Uniform;
    double margin = -1;  // < 0 = suitable_margin
    bool overwrite = false, json = false, quiet = false, ignore_memory = false;

    bool wants(const std::string& format) const;
    //! The options as words, for model.json.
    std::map<std::string, std::string> record() const;
};
void add_build_options(CLI::App& command, BuildArguments& arguments);

}  // namespace stratareeb
