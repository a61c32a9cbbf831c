// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "io/read_model.h"

namespace stratareeb {

struct ViewPayloadOptions {
    std::string title;
    std::string report;  // address of a report beside the page; none if empty
    //! Numbers of layers as model.json has them: {"volume", "plan_area", …} by unit. Not read if empty.
    std::filesystem::path summary = {};
    const LayerModel* unrefined = nullptr;  // what refinement began with, to be shown beside the model
};

//! What the 3D page shows, before it is packed: the length of a JSON header in four bytes (little-endian), the header, lists of
//! numbers (see ViewStreams), whose offsets count from the header's end. The header: {"format": "stratareeb view 1", "title", "report",
//! "length_unit", "origin", "units", "holes": [{"id", "x", "y", "top", "intervals": [[layer, top, base, whole (1) or ended inside
//! (0)], …]}], "model", "straight" (null where three holes make no triangle), "unrefined" (null where there is none): see view_surfaces, "graphs": see view_graphs}.
//! Coordinates are relative to the origin.
std::string view_payload(const SavedModel& saved, const ViewPayloadOptions& options);

}  // namespace stratareeb
