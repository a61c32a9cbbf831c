// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/random_survey.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

using std::numbers::pi;

//! Own mapping from bits to numbers: the distributions of the standard library differ between libraries.
class Dice {
 public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    bool chance(double share) { return between(0, 1) < share; }
    std::size_t below(std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>(between(0, static_cast<double>(n))));
    }

 private:
    std::mt19937_64 engine_;
};

// Truth, places and lost facts draw from streams of their own: more holes in the same ground, for example.
constexpr std::uint64_t kPlaceStream = 0x9e3779b97f4a7c15;
constexpr std::uint64_t kLossStream = 0xd1b54a32d192ed03;

void check(const RandomSurveyOptions& options) {
    const auto is_share = [](double share) { return share >= 0 && share <= 1; };
    if (options.holes < 3)
        throw InvalidInput("a survey needs at least 3 holes, not " + std::to_string(options.holes));
    if (options.layers < 1) throw InvalidInput("a survey needs at least 1 layer");
    if (!(options.extent > 0 && std::isfinite(options.extent)))
        throw InvalidInput("the extent of a survey must be positive");
    if (!(options.thickness > 0 && std::isfinite(options.thickness)))
        throw InvalidInput("the thickness of layers must be positive");
    if (!(options.resolution >= 0)) throw InvalidInput("the resolution of a survey can't be negative");
    if (!is_share(options.zero_share) || !is_share(options.unknown_share) || !is_share(options.cut_off_share))
        throw InvalidInput("shares of absent, unknown and cut-off facts lie between 0 and 1");
}

//! A few long waves whose amplitudes add up to `height`.
std::vector<Wave> random_waves(Dice& dice, double extent, double height) {
    constexpr int kWaves = 3;
    std::vector<Wave> waves(kWaves);
    for (Wave& wave : waves) {
        wave.amplitude = height / kWaves;
        wave.kx = 2 * pi * dice.between(0.3, 1.5) / extent;
        wave.px = dice.between(0, 2 * pi);
        wave.ky = 2 * pi * dice.between(0.3, 1.5) / extent;
        wave.py = dice.between(0, 2 * pi);
    }
    return waves;
}

//! A layer that ends inside the square: along a line, around a lens or around an opening.
TrueThickness random_pinch_out(Dice& dice, double extent, double thickness) {
    constexpr TrueThickness::Shape kShapes[] = {TrueThickness::Shape::Ramp, TrueThickness::Shape::Cone,
                                                TrueThickness::Shape::Window};
    TrueThickness field{.shape = kShapes[dice.below(3)], .thickness = thickness};
    if (field.shape == TrueThickness::Shape::Ramp) {
        field.inner = extent * dice.between(0.2, 0.5);
        field.outer = extent * dice.between(0.6, 0.9);
        field.mirrored = dice.chance(0.5);
        return field;
    }
    field.outer = extent * dice.between(0.25, 0.4);
    field.inner = field.outer / 2;
    field.center = {dice.between(field.outer, extent - field.outer),
                    dice.between(field.outer, extent - field.outer)};
    return field;
}

TrueThickness layer_field(const RandomSurveyOptions& options, std::size_t layer, Dice& dice) {
    const double extent = options.extent;
    TrueThickness field{.thickness = options.thickness};
    if (options.truth == TruthKind::Wedge)
        field = {.shape = TrueThickness::Shape::Ramp,
                 .thickness = 2 * options.thickness,
                 .outer = extent,
                 .mirrored = layer % 2 == 1};
    if (options.truth == TruthKind::Lens && layer % 2 == 1)
        field = {.shape = TrueThickness::Shape::Cone,
                 .thickness = options.thickness,
                 .outer = 0.4 * extent,
                 .center = {extent / 2, extent / 2}};
    if (options.truth != TruthKind::Random) return field;
    if (options.pinch_outs && layer > 0) return random_pinch_out(dice, extent, options.thickness);
    field.waves = random_waves(dice, extent, dice.between(0.2, 0.7));
    return field;
}

//! The places of the holes in local coordinates, drawn one by one.
class HolePlaces {
 public:
    HolePlaces(const RandomSurveyOptions& options, Dice& dice) : options_(options), dice_(dice) {
        const auto n = static_cast<double>(options.holes);
        side_ = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(std::sqrt(n))));
        for (int i = 0; i < std::ceil(std::sqrt(n) / 2); ++i) centers_.push_back(anywhere());
    }

    Point2 place(std::size_t hole) {
        const double extent = options_.extent;
        const bool scattered = options_.plan == HolePlan::Random || options_.plan == HolePlan::Clustered;
        if (scattered && options_.corners && options_.holes >= 4 && hole < 4)
            return {hole % 2 == 0 ? 0 : extent, hole < 2 ? 0 : extent};
        switch (options_.plan) {
            case HolePlan::Random:
                return anywhere();
            case HolePlan::Clustered:
                return near(centers_[dice_.below(centers_.size())]);
            case HolePlan::Grid: {
                const double step = extent / static_cast<double>(side_ - 1);
                const std::size_t column = hole % side_, row = hole / side_;
                return {static_cast<double>(column) * step, static_cast<double>(row) * step};
            }
            case HolePlan::Line: {
                const double along = dice_.between(0, extent);
                return {along, std::clamp(along + dice_.between(-1e-3, 1e-3) * extent, 0.0, extent)};
            }
        }
        return {};
    }

 private:
    Point2 anywhere() { return {dice_.between(0, options_.extent), dice_.between(0, options_.extent)}; }

    Point2 near(Point2 center) {
        const double reach = options_.extent / 15;
        const auto offset = [&] { return reach * (dice_.between(-1, 1) + dice_.between(-1, 1)) / 2; };
        const double x = center.x + offset(), y = center.y + offset();
        return {std::clamp(x, 0.0, options_.extent), std::clamp(y, 0.0, options_.extent)};
    }

    const RandomSurveyOptions& options_;
    Dice& dice_;
    std::size_t side_ = 2;  // of the grid
    std::vector<Point2> centers_;
};

double rounded(double value, double resolution) {
    if (resolution == 0) return value;
    // For a resolution such as 0.001 dividing by 1000 gives the double nearest to the decimal number.
    const double per_unit = std::round(1 / resolution);
    if (per_unit >= 1 && std::abs(per_unit * resolution - 1) < 1e-12)
        return std::round(value * per_unit) / per_unit;
    return std::round(value / resolution) * resolution;
}

std::vector<Point2> hole_places(const RandomSurveyOptions& options, Dice& dice) {
    constexpr int kTries =
        1000;  // a place is taken with a chance well below one half unless the square is nearly full
    HolePlaces source(options, dice);
    std::set<std::pair<double, double>> taken;
    std::vector<Point2> places;
    for (std::size_t hole = 0; hole < options.holes; ++hole) {
        Point2 place;
        int tries = 0;
        do {
            if (++tries > kTries)
                throw InvalidInput("the square of " + std::to_string(options.extent) + " has no room for " +
                                   std::to_string(options.holes) + " holes at this resolution");
            const Point2 local = source.place(hole);
            place = {rounded(options.corner.x + local.x, options.resolution),
                     rounded(options.corner.y + local.y, options.resolution)};
        } while (!taken.insert({place.x, place.y}).second);
        places.push_back(place);
    }
    return places;
}

LayerFact measured(double thickness) {
    return {Knowledge::Measured, thickness};
}

//! Take away what a share of cells and holes is not to know.
void lose_facts(std::vector<LayerFact>& layers, const RandomSurveyOptions& options, Dice& dice) {
    for (LayerFact& fact : layers) {
        if (dice.chance(options.zero_share)) fact = measured(0);
        if (dice.chance(options.unknown_share)) fact = {};
    }
    const bool cut_off = dice.chance(options.cut_off_share);
    const std::size_t last = dice.below(layers.size());
    const double part = rounded(layers[last].thickness * dice.between(0.1, 0.9), options.resolution);
    if (!cut_off || !layers[last].is_present() || part <= 0) return;
    layers[last] = {Knowledge::AtLeast, part};
    std::fill(layers.begin() + static_cast<std::ptrdiff_t>(last) + 1, layers.end(), LayerFact{});
}

//! Elevations that follow from the ground and the measured layers below it.
std::vector<std::optional<double>> known_horizons(double ground, const std::vector<LayerFact>& layers) {
    std::vector<std::optional<double>> horizons(layers.size() + 1);
    horizons[0] = ground;
    for (std::size_t i = 0; i < layers.size() && layers[i].knowledge == Knowledge::Measured; ++i)
        horizons[i + 1] = *horizons[i] - layers[i].thickness;
    return horizons;
}

std::vector<Unit> numbered_units(std::size_t count) {
    constexpr const char* kColors[] = {"#c8a165", "#7f9f6a", "#d9c68f", "#8a7aa8",
                                       "#b5694f", "#6f9bb3", "#a8a29a", "#d08c60"};
    std::vector<Unit> units;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string code = "L" + std::to_string(i + 1);
        units.push_back({code, code, kColors[i % std::size(kColors)]});
    }
    return units;
}

}  // namespace

AnalyticTruth random_truth(const RandomSurveyOptions& options) {
    check(options);
    Dice dice(options.seed);
    AnalyticTruth truth{.corner = options.corner, .extent = options.extent, .level = options.level};
    const double height = options.thickness;
    if (options.truth == TruthKind::Dipping) {
        truth.slope_x = 0.3 * height / options.extent;
        truth.slope_y = -0.2 * height / options.extent;
    }
    if (options.truth == TruthKind::Dome) truth.dome_height = height;
    if (options.truth == TruthKind::Random)
        truth.ground_waves = random_waves(dice, options.extent, height / 2);
    for (std::size_t layer = 0; layer < options.layers; ++layer)
        truth.layers.push_back(layer_field(options, layer, dice));
    return truth;
}

Survey random_survey(const RandomSurveyOptions& options) {
    const AnalyticTruth truth = random_truth(options);
    Dice place_dice(options.seed ^ kPlaceStream), loss_dice(options.seed ^ kLossStream);
    Survey survey;
    survey.units = numbered_units(options.layers);
    for (const Point2& at : hole_places(options, place_dice)) {
        Borehole hole;
        hole.id = "H" + std::to_string(survey.holes.size() + 1);
        hole.at = at;
        for (std::size_t layer = 0; layer < options.layers; ++layer)
            hole.layers.push_back(measured(rounded(truth.thickness(layer, at), options.resolution)));
        lose_facts(hole.layers, options, loss_dice);
        hole.horizons = known_horizons(rounded(truth.ground(at), options.resolution), hole.layers);
        survey.holes.push_back(std::move(hole));
    }
    return survey;
}

}  // namespace stratareeb
