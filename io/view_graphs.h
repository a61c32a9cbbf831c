// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "io/view_streams.h"
#include "mesh/layer_model.h"

namespace stratareeb {

struct ViewGraphOptions {
    std::size_t most_nodes =
        60;  // of a layer's graph; it is simplified until it has no more, people can't read more
};

//! The Reeb graphs of height of all layers' solids, and the layered one of them, for the 3D page. Plateaus count as one.
//! \return {"layers": [{"layer", "share" (simplified by), "nodes": [{"at": [x, y, z], "type": "minimum" | "saddle" | "maximum",
//! "column"}], "arcs": [{"from", "to", "column", "curve": [[x, y, z], …]}], "loops", "width", "runs": a list of arc + 1 (0: none) and
//! how many triangles in a row have it}], "layered": {"share", "nodes": [{"z", "center", "layers": [layer, …]}], "arcs": [{"from",
//! "to", "layer"}]}}. Triangles of a solid count as: tops by plan triangle, bases by plan triangle, walls by half-edge of the outline.
//! \pre the model is in_view_order
nlohmann::json view_graphs(const LayerModel& model, ViewStreams& streams,
                           const ViewGraphOptions& options = {});

}  // namespace stratareeb
