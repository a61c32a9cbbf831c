// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/rule_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "boreholes/errors.h"
#include "boreholes/known_elevations.h"

namespace stratareeb {

namespace {

constexpr double kCutBy = 1e-9;         // of the layers' thickness: a cut that is less is none
constexpr double kLeastFraction = 0.1;  // of the way to a hole without it, that a unit ends before
constexpr double kKept = 0.1;           // of its thickness, by a predicted unit for which there is no room

class RuleCompletion {
 public:
    RuleCompletion(const Survey& survey, const CompletionOptions& options)
        : survey_(survey), options_(options), units_(survey.units.size()), holes_(survey.holes.size()) {
        options_.rules = {};
    }

    RuleColumns run(const LayerRules& rules) {
        rules_ = &rules;
        result_.columns = complete_columns(survey_, options_);
        result_.sequences = layer_sequences(rules, units_);
        result_.anchor.resize(result_.sequences.size());
        known_ = known_elevations(survey_, result_.columns.ground);
        cut_at_.assign(units_, std::vector<char>(holes_, 0));
        if (survey_.contact_points) {
            uncut_contacts();
        } else {
            mark_what_can_be_cut();
            predict_uncut();
            if (unmark_what_is_not_cut()) predict_uncut();
        }
        complete_the_rest();
        return std::move(result_);
    }

 private:
    const LayerFact& fact(std::size_t h, std::size_t i) const { return survey_.holes[h].layers[i]; }

    //! The first unit of a sequence that a hole has below units that it is known to lack; nothing if it may have one above.
    std::optional<std::size_t> uppermost(std::size_t h, const LayerSequence& s) const {
        for (std::size_t i = s.first; i <= s.last; ++i) {
            if (fact(h, i).is_present()) return i;
            if (!fact(h, i).is_absent()) return std::nullopt;
        }
        return std::nullopt;
    }

    //! All of a sequence is known to be lacking.
    bool lacks_all(std::size_t h, const LayerSequence& s) const {
        for (std::size_t i = s.first; i <= s.last; ++i)
            if (!fact(h, i).is_absent()) return false;
        return true;
    }

    void mark_what_can_be_cut() {
        for (const LayerSequence& s : result_.sequences) {
            if (!s.stands || s.onlaps) continue;
            for (std::size_t h = 0; h < holes_; ++h)
                if (const std::size_t end = lacks_all(h, s) ? s.last + 1 : uppermost(h, s).value_or(s.first);
                    end > s.first)
                    for (std::size_t i = s.first; i < end; ++i) cut_at_[i][h] = 1;
        }
        for (const LayerSequence& s : result_.sequences) {
            for (std::size_t h = 0; h < holes_; ++h) {
                const bool slack_below = s.anchored && !s.stands;
                if (slack_below && !s.on_onlap && fact(h, s.last).is_absent()) cut_at_[s.last][h] = 1;
                if (s.on_onlap && fact(h, s.last + 1).is_absent()) cut_at_[s.last + 1][h] = 1;
            }
        }
    }

    //! What the holes would say had nothing been cut: the uppermost unit was thicker, units cut away are not known.
    Survey uncut_survey() const {
        Survey uncut = survey_;
        for (std::size_t h = 0; h < holes_; ++h) {
            Borehole& hole = uncut.holes[h];
            hole.horizons.assign(units_ + 1, std::nullopt);
            hole.horizons[0] = result_.columns.ground[h];
            for (std::size_t i = 0; i < units_; ++i)
                if (cut_at_[i][h]) hole.layers[i] = {};
            for (const LayerSequence& s : result_.sequences) {
                if (!s.stands || s.onlaps) continue;
                const auto top = uppermost(h, s);
                if (top && *top > s.first && cut_at_[*top - 1][h] &&
                    fact(h, *top).knowledge == Knowledge::Measured)
                    hole.layers[*top].knowledge = Knowledge::AtLeast;
            }
        }
        return uncut;
    }

    void predict_uncut() {
        result_.thickness = complete_columns(uncut_survey(), options_).thickness;
        for (std::size_t n = result_.sequences.size(); n-- > 0;)
            if (result_.sequences[n].anchored) complete_anchor(n);
    }

    //! Elevation of the surface under a sequence where a hole knows it, or as its lowest contact and the thicknesses below imply.
    std::optional<double> implied_anchor(std::size_t h, std::size_t n) const {
        const LayerSequence& s = result_.sequences[n];
        if (s.on_onlap) return fact(h, s.last + 1).is_present() ? known_[h][s.last + 1] : std::nullopt;
        if (!s.stands) return fact(h, s.last).is_present() ? known_[h][s.last + 1] : std::nullopt;
        double below = 0;
        for (std::size_t i = s.last + 1; i-- > s.first;) {
            const bool is_contact = fact(h, i).is_present() && fact(h, i).knowledge == Knowledge::Measured;
            if (is_contact && known_[h][i + 1]) return *known_[h][i + 1] - below;
            below += result_.thickness[i][h];
        }
        return std::nullopt;
    }

    //! A hole that ends in the lowest unit that it knows of a sequence says that the surface lies no higher.
    std::optional<double> highest_anchor(std::size_t h, std::size_t n) const {
        const LayerSequence& s = result_.sequences[n];
        if (s.on_onlap) return std::nullopt;
        double below = 0;
        for (std::size_t i = s.last + 1; i-- > (s.stands ? s.first : s.last);) {
            if (fact(h, i).knowledge == Knowledge::AtLeast && known_[h][i])
                return *known_[h][i] - fact(h, i).thickness - below;
            if (fact(h, i).is_present()) return std::nullopt;
            below += result_.thickness[i][h];
        }
        return std::nullopt;
    }

    //! A hole that lacks an eroding unit says that its base, led on, passes above: at half-way pinch-outs by as much as the unit is
    //! thick nearby, so that the two cross half way between a hole with it and one without.
    std::vector<std::optional<double>> lowest_anchors(std::size_t n) const {
        const LayerSequence& s = result_.sequences[n];
        std::vector<std::optional<double>> lowest(holes_);
        if (s.stands || s.on_onlap) return lowest;
        const double fraction = std::max(options_.pinch_out.fraction, kLeastFraction);
        for (std::size_t h = 0; h < holes_; ++h)
            if (fact(h, s.last).is_absent() && known_[h][s.last])
                lowest[h] = *known_[h][s.last] + fraction / (1 - fraction) * result_.thickness[s.last][h];
        return lowest;
    }

    void complete_anchor(std::size_t n) {
        std::vector<std::optional<double>> z(holes_);
        for (std::size_t h = 0; h < holes_; ++h) z[h] = implied_anchor(h, n);
        if (std::ranges::none_of(z, [](const auto& v) { return v.has_value(); })) {
            const LayerSequence& s = result_.sequences[n];
            const std::size_t unit = s.on_onlap ? s.last + 1 : s.last;
            for (std::size_t h = 0; h < holes_; ++h) z[h] = highest_anchor(h, n);
            if (std::ranges::none_of(z, [](const auto& v) { return v.has_value(); }))
                throw InvalidInput(
                    fmt::format("no hole knows the {} of '{}', which its rule predicts as a surface (make it "
                                "conformable)",
                                s.on_onlap ? "top" : "base", survey_.units[unit].code));
        }
        const auto lowest = lowest_anchors(n);
        std::vector<double> values =
            completed_elevations(result_.columns.sites, z, options_.interpolator, lowest);
        bool lowered = false;
        for (std::size_t h = 0; h < holes_; ++h) {
            const auto highest = z[h] ? std::nullopt : highest_anchor(h, n);
            if (highest && *highest < values[h]) z[h] = *highest, lowered = true;
        }
        if (lowered) values = completed_elevations(result_.columns.sites, z, options_.interpolator, lowest);
        result_.anchor[n] = std::move(values);
    }

    //! A hole's lack of a unit is the cut's doing only if what lies below reaches up to the cut.
    bool unmark_what_is_not_cut() {
        bool any = false;
        const auto unmark = [&](std::size_t i, std::size_t h) {
            any |= cut_at_[i][h] != 0, cut_at_[i][h] = 0;
        };
        for (std::size_t n = 0; n < result_.sequences.size(); ++n) {
            const LayerSequence& s = result_.sequences[n];
            for (std::size_t h = 0; h < holes_; ++h) {
                const double least = kCutBy * total(h);
                if (s.stands && !s.onlaps && lacks_all(h, s) &&
                    !(known_[h][s.first] && result_.anchor[n][h] > *known_[h][s.first] + least))
                    for (std::size_t i = s.first; i <= s.last; ++i) unmark(i, h);
                if (s.stands && !s.onlaps)
                    if (const auto top = uppermost(h, s))
                        if (!(result_.thickness[*top][h] > fact(h, *top).thickness + least))
                            for (std::size_t i = s.first; i < *top; ++i) unmark(i, h);
                if (s.on_onlap) {
                    unmark_onlap(n, h, least, unmark);
                } else if (s.anchored && !s.stands && cut_at_[s.last][h] &&
                           !(known_[h][s.last] && result_.anchor[n][h] > *known_[h][s.last] + least)) {
                    unmark(s.last, h);
                }
            }
        }
        return any;
    }

    template <class Unmark>
    void unmark_onlap(std::size_t n, std::size_t h, double least, Unmark&& unmark) const {
        const std::size_t i = result_.sequences[n].last + 1;
        if (cut_at_[i][h] && !(known_[h][i] && result_.anchor[n][h] < *known_[h][i] - least)) unmark(i, h);
    }

    double total(std::size_t h) const {
        double sum = 0;
        for (const auto& layer : result_.columns.thickness) sum += layer[h];
        return sum;
    }

    //! Contact points: every horizon is an elevation of its own; thicknesses are what lies between them.
    void uncut_contacts() {
        std::vector<std::vector<double>> z;
        for (std::size_t k = 0; k <= units_; ++k) {
            std::vector<std::optional<double>> contacts(holes_);
            for (std::size_t h = 0; h < holes_; ++h)
                contacts[h] = k == 0 ? result_.columns.ground[h] : known_[h][k];
            z.push_back(completed_elevations(result_.columns.sites, contacts, options_.interpolator));
        }
        for (std::size_t i = 0; i < units_; ++i) {
            auto& layer = result_.thickness.emplace_back(holes_);
            for (std::size_t h = 0; h < holes_; ++h) layer[h] = std::max(0.0, z[i][h] - z[i + 1][h]);
        }
        for (std::size_t n = 0; n < result_.sequences.size(); ++n)
            if (result_.sequences[n].anchored) result_.anchor[n] = z[result_.sequences[n].last + 1];
        for (std::size_t n = 0; n < result_.sequences.size(); ++n) keep_slack_present(n);
    }

    //! Of contact points nobody lacks a unit; where its two horizons cross it is cut away.
    void keep_slack_present(std::size_t n) {
        const LayerSequence& s = result_.sequences[n];
        const std::size_t slack = s.slack(units_);
        for (const std::size_t i : {slack, s.on_onlap ? s.last + 1 : units_}) {
            if (i >= units_) continue;
            double mean = 0;
            for (const double t : result_.thickness[i]) mean += t / static_cast<double>(holes_);
            for (double& t : result_.thickness[i])
                if (t == 0) t = mean;
        }
    }

    //! What a hole does not know follows from the uncut columns under the rules.
    void complete_the_rest() {
        for (std::size_t h = 0; h < holes_; ++h) {
            UncutColumn column{
                .ground = result_.columns.ground[h], .anchor = {}, .thickness = {}, .taper = {}};
            for (const auto& anchor : result_.anchor) column.anchor.push_back(anchor.empty() ? 0 : anchor[h]);
            for (std::size_t i = 0; i < units_; ++i) {
                column.thickness.push_back(result_.thickness[i][h]);
                column.taper.push_back(result_.thickness[i][h] > 0 ? 1 : 0);
            }
            if (survey_.contact_points)
                order_between_contacts(h, stacked_thicknesses(column, result_.sequences));
            else
                replace_unknown(h, stacked_thicknesses(column, result_.sequences));
        }
    }

    void replace_unknown(std::size_t h, const std::vector<double>& stacked) {
        std::size_t deepest = 0;
        for (std::size_t k = 0; k <= units_; ++k)
            if (known_[h][k]) deepest = k;
        double z = result_.columns.ground[h], wanted = z;
        for (std::size_t i = 0; i < deepest; ++i) z -= result_.columns.thickness[i][h], wanted -= stacked[i];
        for (std::size_t i = deepest; i < units_; ++i) {
            wanted -= stacked[i];
            double& t = result_.columns.thickness[i][h];
            const LayerFact& known = fact(h, i);
            if (known.knowledge != Knowledge::Measured) {
                t = std::max(z - wanted,
                             known.knowledge == Knowledge::AtLeast ? known.thickness : kKept * stacked[i]);
                if (stacked[i] <= 0 && known.knowledge == Knowledge::Unknown) t = 0;
                if (t > 0) t = std::max(t, rules_->minimum(i));
            }
            z -= t;
        }
    }

    //! Contacts stay, and what is not known here is put in order between them.
    void order_between_contacts(std::size_t h, const std::vector<double>& stacked) {
        std::vector<double> z{result_.columns.ground[h]};
        for (const double t : stacked) z.push_back(z.back() - t);
        std::vector<double> floor(units_ + 1, -std::numeric_limits<double>::infinity());
        double highest = floor[0];
        for (std::size_t k = units_ + 1; k-- > 0;) {
            floor[k] = highest;
            const auto contact = k == 0 ? survey_.holes[h].horizons[0] : known_[h][k];
            if (contact) z[k] = *contact, highest = std::max(highest, *contact);
        }
        double ceiling = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k <= units_; ++k) {
            const bool is_contact =
                k == 0 ? survey_.holes[h].horizons[0].has_value() : known_[h][k].has_value();
            if (!is_contact) z[k] = std::max(z[k], floor[k]);
            z[k] = std::min(z[k], ceiling);
            ceiling = z[k];
        }
        result_.columns.ground[h] = z[0];
        for (std::size_t i = 0; i < units_; ++i) result_.columns.thickness[i][h] = z[i] - z[i + 1];
    }

    const Survey& survey_;
    CompletionOptions options_;
    const LayerRules* rules_ = nullptr;
    std::size_t units_, holes_;
    RuleColumns result_;
    std::vector<std::vector<std::optional<double>>> known_;  // [hole][horizon]
    std::vector<std::vector<char>> cut_at_;  // [unit][hole]: lacking there because it was cut away
};

}  // namespace

RuleColumns rule_columns(const Survey& survey, const CompletionOptions& options) {
    return RuleCompletion(survey, options).run(options.rules);
}

}  // namespace stratareeb
