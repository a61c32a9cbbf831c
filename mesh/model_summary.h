// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boreholes/borehole.h"
#include "mesh/layer_model.h"

namespace stratareeb {

//! One layer in numbers: lengths in the model's unit, areas squared, volumes cubed.
struct UnitSummary {
    double volume = 0;
    double area = 0;                               // of the solid's surface
    double plan_area = 0;                          // of the region in plan where the layer is
    double mean_thickness = 0, max_thickness = 0;  // over that region
    std::size_t triangles = 0, components = 0, genus = 0;
    bool watertight = true;  // true for a layer that is absent everywhere
    std::vector<std::string> problems;
    std::size_t holes_present = 0;  // those that end inside the layer included
    std::size_t holes_at_least = 0, holes_absent = 0, holes_unknown = 0;
};

//! Something that was verified about a model, not assumed.
struct ModelCheck {
    std::string name;
    bool ok = false;
    std::string detail;
};

//! Distance between horizons and the contacts that holes give, in the model's unit.
struct Misfit {
    double max = 0, rms = 0;
    std::size_t contacts = 0;
};

//! Measure one solid and count what the holes say of its layer.
UnitSummary summarize_unit(const LayerModel& model, const LayerSolid& solid, const Survey& survey);

//! The same of a layer's solids in all blocks of a faulted model; of none, a layer that is absent everywhere.
UnitSummary summarize_unit(const LayerModel& model, std::size_t layer, const std::vector<LayerSolid>& solids,
                           const Survey& survey);

//! Contacts of holes inside the footprint against the horizons at their places.
Misfit misfit_of(const LayerModel& model, const Survey& survey);

//! The claims of a layer model, each checked: unfolded plan (exact predicates), horizons in order, watertight
//! solids (exact predicates), volumes that add up to the envelope, contacts honoured, absent layers absent.
std::vector<ModelCheck> check_model(const LayerModel& model, const Survey& survey,
                                    const std::vector<UnitSummary>& units);

}  // namespace stratareeb
