// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boreholes/borehole.h"
#include "boreholes/complete_columns.h"
#include "mesh/volume_between.h"

namespace stratareeb {

struct VolumeUncertaintyOptions {
    CompletionOptions prediction;  // as the model was made
    std::size_t folds = 10;        // of the hold-out, at most; fewer holes: each by itself
    std::uint64_t seed = 1;
    double confidence = 0.95;
};

//! How far off a volume may be. Errors are those of the thickness in the window, predicted - actual; in their mean each hole
//! counts by the part of the model's plan nearest to it.
struct VolumeUncertainty {
    std::size_t holes =
        0;  // that were left out and know the thickness; with fewer than 2 nothing else is known
    std::size_t groups = 0;  // that those holes stood in; their number where each was left out by itself
    double rmse = 0, mean_error = 0;
    double standard_error = 0;  // of the volume
    double half_width = 0;      // volume ± this
};

//! For each layer, and last for all of them together, from boreholes left out and predicted by the others (matched_draws: where
//! they stand in groups, groups together). Each hole stands for the part of the window's plan nearest to it, a_h. Errors of holes of one group
//! are alike, so that a group g counts as one, by its mean error e_g and the area a_g of its holes; a hole that stands alone is a group.
//! standard error² = (mean error · sum a_g)² + mean of e_g² · sum w_g², half width = Student's t with groups - 1 degrees of freedom · that.
//! Crowded holes so count for no more than the area that they cover. w is a with places that are farther from their hole than
//! left-out holes were from theirs (a mean by area) counted by the root of that ratio, as errors grow with distance for a linear
//! variogram, up to the deviation of the thickness itself. docs/volume.md has the share of true volumes that ± held.
//! \throw InvalidInput as hold_out does
std::vector<VolumeUncertainty> volume_uncertainty(const LayerModel& model, const Survey& survey,
                                                  const VolumeWindow& window, const WindowVolumes& volumes,
                                                  const VolumeUncertaintyOptions& options = {});

}  // namespace stratareeb
