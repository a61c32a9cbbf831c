// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boreholes/hole_triangulation.h"
#include "boreholes/point.h"
#include "boreholes/variogram.h"

namespace stratareeb {

//! A quantity at the sites of a triangulation. Sites whose `use` is 0 have no say; empty `use` means all. Where `at_least` is
//! not 0 the value is a lower bound: splines and kriging keep above it, other methods leave the site out.
struct SiteField {
    std::span<const double> value;
    std::span<const char> use;
    std::span<const char> at_least = {};

    bool is_measured(std::size_t site) const {
        return (use.empty() || use[site]) && (at_least.empty() || !at_least[site]);
    }
};

//! Layers one above the other, top first, where some may be missing.
struct LayerFields {
    //! Only sites that have the layer have a say.
    std::span<const SiteField> thickness;
    //! [layer][site]: the thickness is known there, be it 0 for a layer that is missing; empty: where a site has a say.
    std::span<const std::vector<char>> known = {};
    //! [layer][place]: the share of a prediction that the place has, less than 1 near where the layer ends; empty: 1.
    std::span<const std::vector<double>> taper = {};
};

//! One field at some places.
struct FieldPrediction {
    std::vector<double> value;
    std::vector<double>
        deviation;  // standard deviation of what a new hole would find there; empty if not known
};

//! A way to predict values between scattered sites. Outside the sites' hull, most give the value of the closest hull point;
//! splines and kriging go on for up to a quarter of the sites' extent, then keep level. None leaves the values' range
//! by more than half of it, or falls below half of the smallest value where all are positive.
class Interpolator {
 public:
    virtual ~Interpolator() = default;

    //! Several fields over the same sites at the same places; result[field][place]. The value is 0 where none
    //! of the sites around a place has a say. At a used site it is that site's value, to the last bit, unless the method was
    //! asked to smooth.
    virtual std::vector<std::vector<double>> predict(std::span<const Point2> where,
                                                     std::span<const SiteField> fields) const = 0;

    //! The same for the thicknesses of layers. Splines and kriging, which fit each field by itself, predict the depths of their
    //! bases as well and bring both together (reconcile_layers.h), so that the sums of layers are predicted as well as the layers.
    virtual std::vector<std::vector<double>> predict_layers(std::span<const Point2> where,
                                                            const LayerFields& layers) const {
        return predict(where, layers.thickness);
    }

    //! As predict, with standard deviations where the method has them.
    virtual std::vector<FieldPrediction> predict_with_deviation(std::span<const Point2> where,
                                                                std::span<const SiteField> fields) const;
    virtual bool has_deviation() const { return false; }
};

enum class InterpolatorKind {
    Linear,            // barycentric on the Delaunay triangulation (TIN), C0; the thesis's method
    NaturalNeighbour,  // Sibson's C1 interpolant (R. Sibson, 1981), smooth away from the sites
    SibsonC0,          // Sibson's C0 interpolant: natural neighbour coordinates as weights
    InverseDistance,   // weights 1 / distance^power of the nearest sites (D. Shepard, 1968)
    Spline,            // thin-plate spline, in tension where that predicts better
    MinimumCurvature,  // a grid of least curvature through the sites (I. C. Briggs, 1974)
    Kriging,           // ordinary kriging: the mean is unknown
    KrigingLinear,     // universal kriging with a linear drift
    KrigingQuadratic,  // universal kriging with a quadratic drift
};

//! Settings of the methods; each looks at its own.
struct InterpolatorOptions {
    double power = 2;             // inverse distance
    std::size_t neighbours = 12;  // inverse distance: how many of the nearest sites have a say

    //! Spline: tension p, as p times the mean gap between sites; 0 is the thin plate, 10 nearly a membrane. By default the one
    //! that predicts left-out sites best.
    std::optional<double> tension;
    //! Spline: 0 passes through the values; more lets it miss them, as the variance of their errors in shares of the values'
    //! variance. "Best" by left-out sites with `smoothing_by_data`.
    double smoothing = 0;
    bool smoothing_by_data = false;

    //! Kriging: in coordinates and values as given. By default fitted to each field.
    std::optional<Variogram> variogram;
    //! Kriging: take the nugget as error of measurement and pass beside the values. By default values are honoured: the
    //! nugget is what changes over less than the gap between sites, and the surface leads there smoothly.
    bool filter_nugget = false;
    //! Kriging: let fitted variograms have a direction. Left-out holes of real surveys were not predicted better by it.
    bool anisotropy = false;

    double curvature_tension = 0;          // minimum curvature: 0 … 1 (W. H. F. Smith and P. Wessel, 1990)
    std::size_t curvature_nodes = 20'000;  // minimum curvature: about so many nodes of its grid at most

    //! Splines and kriging: so many sites or fewer are solved in one piece, more in overlapping patches.
    std::size_t single_patch = 400;
};

//! Of left-out boreholes of real surveys it has the least errors (docs/validate.md).
inline constexpr InterpolatorKind kDefaultInterpolator = InterpolatorKind::Kriging;

//! By name: linear, natural, sibson-c0, inverse-distance, spline, minimum-curvature, kriging, kriging-linear,
//! kriging-quadratic.
//! \throw InvalidInput for any other name.
InterpolatorKind interpolator_kind(std::string_view name);
std::string_view name_of(InterpolatorKind kind);
//! Splines and kriging: "at least" values are met as such, and the surface through values that it predicted itself is the same as
//! without them, so that predictions need not be taken for data.
bool takes_bounds(InterpolatorKind kind);
//! All kinds, in the order of the enumeration.
std::span<const InterpolatorKind> interpolator_kinds();
//! Their names, as "linear, natural, … or kriging-quadratic".
std::string interpolator_names();

std::unique_ptr<Interpolator> make_interpolator(InterpolatorKind kind,
                                                std::shared_ptr<const HoleTriangulation> holes,
                                                const InterpolatorOptions& options = {});

}  // namespace stratareeb
