// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "boreholes/field_sites.h"
#include "boreholes/patch_cover.h"
#include "boreholes/radial_system.h"

namespace stratareeb {

//! The surface through a field's sites, solved in one piece where they are few, else in overlapping patches that are blended with
//! smooth weights, so that there is no jump anywhere. Values are scaled to mean 0 and variance 1 before they are solved for.
class BlendedSurface {
 public:
    //! `sites` must outlive this. The model is in the sites' local coordinates and in scaled values.
    //! \pre at least one measured site.
    BlendedSurface(const FieldSites& sites, RadialModel model, const PatchCoverOptions& options);

    struct Result {
        std::vector<double> value, deviation;
    };
    //! At local places; each patch's values are kept within its sites' `value_limits`. Deviations on request.
    Result at(std::span<const Point2> where, bool deviations) const;

    //! Root of the mean squared leave-one-out error over some patches (all sites, where they are few), in scaled values.
    double leave_one_out_rms() const;
    //! Mean of what patches' values ask for as the kernel's factor, over the same patches.
    double energy_per_freedom() const;

 private:
    struct Place {
        std::size_t number;
        double weight;
    };
    RadialSystem system(std::uint32_t patch) const;
    std::vector<std::uint32_t> some_patches() const;

    const FieldSites& sites_;
    RadialModel model_;
    PatchCover cover_;
    double mean_ = 0, spread_ = 1;
    std::vector<double> scaled_;
};

//! Mean and standard deviation of the measured values; the latter is 1 where it would be 0.
struct ValueScale {
    double mean = 0, spread = 1;
};
ValueScale value_scale(const FieldSites& sites);

}  // namespace stratareeb
