// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"
#include "mesh/fault_seams.h"
#include "mesh/footprint.h"
#include "mesh/layer_regions.h"
#include "mesh/layer_solid.h"
#include "mesh/normals.h"
#include "mesh/plan_mesh.h"

namespace stratareeb {

//! Horizons over one plan triangulation: ground first, then the base of each layer. All coordinates are
//! relative to `origin`. Horizons are in order at every vertex, hence everywhere, since neighbours are linear
//! over the same triangles; where a layer is absent, its two horizons are equal to the last bit.
struct LayerModel {
    std::vector<Unit> units;
    Point3 origin;  // add it for map coordinates
    std::string length_unit = "m";
    PlanMesh plan;
    LayerRegions regions;
    std::vector<std::vector<double>> horizons;  // [k][vertex]; k = 0 ground, k = i + 1 base of unit i
    CompleteColumns columns;                    // the holes' columns, relative to origin, as used
    FaultSeams seams;                           // where the plan is cut along faults; empty without
    double spacing = 0;                         // of the plan mesh; 0 = bare triangulation
    std::vector<std::string> notes;             // what had to be assumed, for people

    double thickness(std::size_t layer, std::size_t vertex) const {
        return horizons[layer][vertex] - horizons[layer + 1][vertex];
    }
};

struct LayerModelOptions {
    InterpolatorKind interpolator = kDefaultInterpolator;
    PinchOutRule pinch_out;
    LayerRules rules;                    // how units lie on older ones; empty = all conformable
    std::optional<Footprint> footprint;  // map coordinates; empty = the holes' hull
    std::optional<double> spacing;       // empty = suitable_spacing; 0 = the bare triangulation of the holes
    std::optional<Point3> origin;        // empty = suitable_origin
    double spacing_factor = 1;           // of suitable_spacing, where that holds
    bool ring_holes = false;             // PlanMeshOptions::ring_holes; for a model that is to be refined
    //! Elevation of a terrain model at map coordinates. The ground follows it, bent smoothly to pass through
    //! the elevations that holes give; layers keep their thickness below it.
    std::function<std::optional<double>(const Point2&)> terrain;
    //! Called between and during the steps with what is being done and its share (0..1), from one thread.
    std::function<void(const char* step, double share)> progress;
    //! Called with the expected number of plan triangles before any is made; may throw to call the run off.
    std::function<void(double triangles)> before_meshing;
};

//! Coordinates beyond this are shifted to a local origin: viewers and STL keep 24 bits.
constexpr double kFarFromOrigin = 10'000;

//! From boreholes to horizons on the plan mesh.
//! \throw InvalidInput for surveys that can't carry a model (the message says why and the way out),
//! GeometryError if rounding defeats the plan triangulation.
LayerModel build_layer_model(const Survey& survey, const LayerModelOptions& options = {});

//! A local origin, 0 where coordinates are small.
Point3 suitable_origin(const std::vector<Point2>& sites, const std::vector<double>& ground);

//! Horizon k as an open surface; all horizons have the same vertices in x, y and the same triangles.
TriMesh horizon_surface(const LayerModel& model, std::size_t k, NormalWeight weight = NormalWeight::Uniform);

//! The closed solid of one layer (0 = top): top and base over its region, walls along the footprint. Empty
//! where absent. Of a faulted model, the solids of all blocks side by side, which may touch.
LayerSolid build_layer_solid(const LayerModel& model, std::size_t layer,
                             NormalWeight weight = NormalWeight::Uniform);

//! The same for each block of a faulted model: closed solids that share the triangles of the walls between them. Without
//! faults, the one solid. Blocks without the layer have none.
std::vector<LayerSolid> build_block_solids(const LayerModel& model, std::size_t layer,
                                           NormalWeight weight = NormalWeight::Uniform);

//! Would the solid of a layer in a block (0 = first) that faults reach into touch itself?
bool touches_itself(const LayerModel& model, std::size_t layer, std::uint32_t block);

//! Volume between ground and the lowest horizon.
double envelope_volume(const LayerModel& model);

}  // namespace stratareeb
