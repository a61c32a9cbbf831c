// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boreholes/field_sites.h"
#include "boreholes/interpolator.h"
#include "boreholes/patch_cover.h"
#include "boreholes/radial_system.h"

namespace stratareeb {

//! What splines and kriging share: a model for each field, one piece or patches, values met to the last bit, the hull.
class RadialInterpolator : public Interpolator {
 public:
    std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                             std::span<const SiteField> fields) const override;
    std::vector<std::vector<double>> predict_layers(std::span<const Point2> where,
                                                    const LayerFields& layers) const override;
    std::vector<FieldPrediction> predict_with_deviation(std::span<const Point2> where,
                                                        std::span<const SiteField> fields) const override;
    bool has_deviation() const override { return true; }

 protected:
    //! A model in the coordinates of `frame`, of values scaled to variance 1.
    struct FieldModel {
        PlanFrame frame;
        RadialModel radial;
        double variance_factor = 1;  // of the kernel, for deviations
        bool honours_values = true;
    };

    RadialInterpolator(std::shared_ptr<const HoleTriangulation> holes, std::size_t single_patch)
        : holes_(std::move(holes)), single_patch_(single_patch) {}

    //! \pre two sites or more, not all measured values equal.
    virtual FieldModel model_of(const FieldSites& sites) const = 0;
    PatchCoverOptions cover() const { return {.single = single_patch_}; }
    const HoleTriangulation& holes() const { return *holes_; }

 private:
    //! What is asked for beside the values.
    struct Extras {
        bool deviations = false, error = false;
    };
    struct RatedField {
        FieldPrediction prediction;
        double error = 0;  // root of the mean squared leave-one-out error
    };
    RatedField predict_field(std::span<const Point2> where, const SiteField& field, Extras extras) const;
    std::vector<Point2> in_reach(std::span<const Point2> where) const;
    void predict_run(std::span<const Point2> where, const LayerFields& layers, std::size_t begin,
                     std::size_t end, std::vector<std::vector<double>>& result) const;

    std::shared_ptr<const HoleTriangulation> holes_;
    std::size_t single_patch_;
};

}  // namespace stratareeb
