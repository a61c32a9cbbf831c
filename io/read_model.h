// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "boreholes/borehole.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! A model as `build` left it in a folder.
struct SavedModel {
    //! Horizons, plan and regions to the last bit; `columns` has the holes' places alone, relative to the origin.
    LayerModel model;
    //! The boreholes it was made from, in map coordinates; none in folders written before they were kept.
    Survey survey;
    std::string crs = {};  // of map coordinates, "EPSG:27700" or WKT; empty if not known

    //! What was asked for, else the model's own.
    const std::string& crs_or(const std::string& asked) const { return asked.empty() ? crs : asked; }
};

//! Read a folder that `build` wrote: model.json, the horizons, and boreholes.json.
//! \throw IoError if a file can't be read; InvalidInput naming file and place if the folder is no model, a file
//! is damaged, horizons differ in x, y or triangles, or cross.
SavedModel read_model(const std::filesystem::path& folder);

//! The model that refinement began with, on the coarse plan, without holes; none if `build` didn't refine it or it has faults.
//! \throw as read_model
std::optional<LayerModel> read_unrefined(const std::filesystem::path& folder);

}  // namespace stratareeb
