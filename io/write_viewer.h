// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "io/read_model.h"

namespace stratareeb {

struct ViewerOptions {
    std::string title = {};  // empty: the folder's name
    std::string report =
        {};  // address of a report that the page links to; empty: report.html if it is beside the page
};

//! The 3D page of a saved model as one HTML file that needs no network: the page that viewer/ is built to, with the model in
//! it (view_payload, deflated, base64), and beside it the one that refinement began with, if given. The same model gives the same bytes.
std::string viewer_page(const SavedModel& saved, const ViewerOptions& options,
                        const std::filesystem::path& summary = {}, const LayerModel* unrefined = nullptr);

//! Write the page of the folder that `build` wrote.
//! \return the file's size in bytes
//! \throw what read_model throws; IoError if the file can't be written
std::size_t write_viewer(const std::filesystem::path& folder, const std::filesystem::path& file,
                         const ViewerOptions& options = {});

}  // namespace stratareeb
