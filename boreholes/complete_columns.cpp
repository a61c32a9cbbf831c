// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/complete_columns.h"

#include <algorithm>
#include <memory>

#include "boreholes/errors.h"
#include "boreholes/thickness_field.h"

namespace stratareeb {

namespace {

constexpr double kInForce = 1e-9;  // of a bound: a prediction that is so little above it stands on it

//! Some sites with a value each.
struct Sample {
    std::vector<Point2> at;
    std::vector<double> value;

    void add(const Point2& p, double v) {
        at.push_back(p);
        value.push_back(v);
    }
};

std::vector<double> predicted_elevations(const Sample& known, std::span<const Point2> where,
                                         InterpolatorKind kind) {
    const auto interpolator = make_interpolator(kind, std::make_shared<HoleTriangulation>(known.at));
    return interpolator->predict(where, std::vector<SiteField>{{known.value, {}}})[0];
}

std::vector<double> predicted_thicknesses(const Sample& known, std::span<const Point2> where,
                                          const CompletionOptions& options) {
    const auto holes = std::make_shared<HoleTriangulation>(known.at);
    const ThicknessField field(holes, {known.value}, options.pinch_out,
                               make_interpolator(options.interpolator, holes));
    return field.predict(where)[0];
}

//! At places with bounds, by a method that meets them: the thickness, which is the bound where it is in force. Near holes that
//! lack the layer it is the less, as beside any pinch-out.
std::vector<double> thicknesses_above(const Sample& known, const Sample& bounds,
                                      const CompletionOptions& options) {
    Sample all = known;
    std::vector<char> use, at_least(known.at.size(), 0);
    for (std::size_t b = 0; b < bounds.at.size(); ++b) all.add(bounds.at[b], bounds.value[b]);
    at_least.resize(all.at.size(), 1);
    for (const double t : all.value) use.push_back(static_cast<char>(t > 0));
    const auto interpolator =
        make_interpolator(options.interpolator, std::make_shared<HoleTriangulation>(all.at));
    auto result = interpolator->predict(bounds.at, std::vector<SiteField>{{all.value, use, at_least}})[0];
    const auto holes = std::make_shared<HoleTriangulation>(known.at);
    const ThicknessField without_bounds(holes, {known.value}, options.pinch_out, nullptr);
    const auto locations = holes->locate(bounds.at);
    for (std::size_t b = 0; b < result.size(); ++b) result[b] *= without_bounds.taper(0, locations[b]);
    return result;
}

class Completion {
 public:
    Completion(const Survey& survey, const CompletionOptions& options) : survey_(survey), options_(options) {
        for (const Borehole& hole : survey.holes) columns_.sites.push_back(hole.at);
    }

    CompleteColumns from_layers() {
        complete_ground();
        for (std::size_t i = 0; i < survey_.units.size(); ++i)
            columns_.thickness.push_back(complete_layer(i));
        for (std::size_t h = 0; h < survey_.holes.size(); ++h) fit_between_known_horizons(h);
        return std::move(columns_);
    }

    CompleteColumns from_contacts() {
        std::vector<std::vector<double>> z;
        for (std::size_t k = 0; k <= survey_.units.size(); ++k) z.push_back(complete_horizon(k));
        for (std::size_t h = 0; h < survey_.holes.size(); ++h) order_between_contacts(z, h);
        columns_.ground = z[0];
        for (std::size_t i = 0; i < survey_.units.size(); ++i) {
            auto& thickness = columns_.thickness.emplace_back();
            for (std::size_t h = 0; h < survey_.holes.size(); ++h) thickness.push_back(z[i][h] - z[i + 1][h]);
        }
        return std::move(columns_);
    }

 private:
    std::optional<double> known_horizon(std::size_t hole, std::size_t k) const {
        const auto& horizons = survey_.holes[hole].horizons;
        return k < horizons.size() ? horizons[k] : std::nullopt;
    }

    //! Elevation of horizon k at every hole: its contacts, else the terrain (ground only), else predicted
    //! from contacts.
    std::vector<double> complete_horizon(std::size_t k) {
        Sample known;
        std::vector<std::size_t> missing;
        std::vector<Point2> where;
        std::vector<double> z(survey_.holes.size());
        for (std::size_t h = 0; h < z.size(); ++h) {
            auto value = known_horizon(h, k);
            if (!value && k == 0 && options_.terrain) value = options_.terrain(columns_.sites[h]);
            if (value) {
                z[h] = *value;
                known.add(columns_.sites[h], *value);
            } else {
                missing.push_back(h);
                where.push_back(columns_.sites[h]);
            }
        }
        if (missing.empty()) return z;
        if (known.at.empty())
            throw InvalidInput(
                k == 0 ? "no hole gives a ground elevation (add a ground column or --ground RASTER)"
                       : "no contact of the base of '" + survey_.units[k - 1].code + "'");
        const auto predicted = predicted_elevations(known, where, options_.interpolator);
        for (std::size_t m = 0; m < missing.size(); ++m) z[missing[m]] = predicted[m];
        if (k == 0 && !survey_.contact_points)
            columns_.notes.push_back("ground predicted from the other holes at " +
                                     std::to_string(missing.size()) + " holes that give none");
        return z;
    }

    void complete_ground() { columns_.ground = complete_horizon(0); }

    std::vector<double> complete_layer(std::size_t i) {
        const auto fact = [&](std::size_t h) { return survey_.holes[h].layers[i]; };
        std::vector<double> thickness(survey_.holes.size(), 0.0);
        columns_.known.emplace_back(thickness.size(), static_cast<char>(1));
        Sample known;
        std::vector<std::size_t> at_least, unknown;
        for (std::size_t h = 0; h < thickness.size(); ++h) {
            thickness[h] = fact(h).thickness;
            switch (fact(h).knowledge) {
                case Knowledge::Measured:
                    known.add(columns_.sites[h], thickness[h]);
                    break;
                case Knowledge::AtLeast:
                    at_least.push_back(h);
                    break;
                case Knowledge::Unknown:
                    unknown.push_back(h);
                    columns_.known[i][h] = 0;
                    break;
            }
        }
        // Zeros alone say where the layer is not, nothing of how thick it is where a hole ends in it.
        const bool drilled_through = std::ranges::any_of(known.value, [](double t) { return t > 0; });
        if (!drilled_through && !at_least.empty()) {
            columns_.notes.push_back("layer '" + survey_.units[i].code +
                                     "': no hole drills through it; its base is where the holes end");
            for (const std::size_t h : at_least) known.add(columns_.sites[h], thickness[h]);
        } else {
            raise_to_prediction(i, at_least, known, thickness);
        }
        if (known.at.empty()) {
            columns_.notes.push_back("layer '" + survey_.units[i].code + "': no hole knows it; left out");
            return std::vector<double>(thickness.size(), 0.0);
        }
        fill_in(unknown, known, thickness);
        return thickness;
    }

    void raise_to_prediction(std::size_t i, const std::vector<std::size_t>& at_least, Sample& known,
                             std::vector<double>& thickness) {
        if (at_least.empty()) return;
        Sample bounds;
        for (const std::size_t h : at_least) bounds.add(columns_.sites[h], thickness[h]);
        const auto predicted = takes_bounds(options_.interpolator)
                                   ? thicknesses_above(known, bounds, options_)
                                   : predicted_thicknesses(known, bounds.at, options_);
        for (std::size_t m = 0; m < at_least.size(); ++m) {
            const std::size_t h = at_least[m];
            if (predicted[m] > thickness[h] * (1 + kInForce)) {
                thickness[h] = predicted[m];
                columns_.known[i][h] = 0;
            } else {
                known.add(columns_.sites[h], thickness[h]);
            }
        }
    }

    void fill_in(const std::vector<std::size_t>& unknown, const Sample& known,
                 std::vector<double>& thickness) {
        if (unknown.empty()) return;
        const auto predicted = predicted_thicknesses(known, places(unknown), options_);
        for (std::size_t m = 0; m < unknown.size(); ++m) thickness[unknown[m]] = predicted[m];
    }

    std::vector<Point2> places(const std::vector<std::size_t>& holes) const {
        std::vector<Point2> where;
        for (const std::size_t h : holes) where.push_back(columns_.sites[h]);
        return where;
    }

    //! Scale the layers that are not measured so that each known horizon is met. The ground first: a hole
    //! without one hangs from its highest known horizon.
    void fit_between_known_horizons(std::size_t h) {
        const Borehole& hole = survey_.holes[h];
        std::size_t above = 0;
        double z_above = columns_.ground[h];
        for (std::size_t k = 1; k < hole.horizons.size(); ++k) {
            if (!hole.horizons[k]) continue;
            fit(h, above, k, z_above - *hole.horizons[k]);
            above = k;
            z_above = *hole.horizons[k];
        }
    }

    void fit(std::size_t h, std::size_t first, std::size_t last, double gap) {
        const auto& facts = survey_.holes[h].layers;
        std::optional<std::size_t> first_free;
        double free_sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            if (facts[i].knowledge == Knowledge::Measured) {
                gap -= facts[i].thickness;
            } else {
                free_sum += columns_.thickness[i][h];
                if (!first_free) first_free = i;
            }
        }
        if (!first_free) return;
        gap = std::max(gap, 0.0);
        for (std::size_t i = first; i < last; ++i)
            if (facts[i].knowledge != Knowledge::Measured) {
                columns_.thickness[i][h] *= free_sum > 0 ? gap / free_sum : 0.0;
                columns_.known[i][h] = 1;
            }
        if (free_sum <= 0) columns_.thickness[*first_free][h] = gap;
    }

    //! Contacts stay; a horizon that is not known in this hole is kept between the contacts above and below
    //! it, and below the horizon over it.
    void order_between_contacts(std::vector<std::vector<double>>& z, std::size_t h) const {
        const std::size_t count = z.size();
        double floor = -std::numeric_limits<double>::infinity();
        std::vector<double> highest_contact_below(count, floor);
        for (std::size_t k = count; k-- > 0;) {
            highest_contact_below[k] = floor;
            if (known_horizon(h, k)) floor = std::max(floor, z[k][h]);
        }
        double ceiling = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < count; ++k) {
            if (!known_horizon(h, k)) z[k][h] = std::max(z[k][h], highest_contact_below[k]);
            z[k][h] = std::min(z[k][h], ceiling);
            ceiling = z[k][h];
        }
    }

    const Survey& survey_;
    const CompletionOptions& options_;
    CompleteColumns columns_;
};

}  // namespace

CompleteColumns complete_columns(const Survey& survey, const CompletionOptions& options) {
    if (survey.holes.empty()) throw InvalidInput("the table has no holes to build from");
    if (survey.units.empty()) throw InvalidInput("the table has no layers to build");
    Completion completion(survey, options);
    return survey.contact_points ? completion.from_contacts() : completion.from_layers();
}

}  // namespace stratareeb
