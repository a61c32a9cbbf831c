// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boreholes/borehole.h"

namespace stratareeb {

//! How a unit lies on what is older, in the words of stratigraphy.
enum class LayerRule {
    Conformable,  // its thickness is predicted and carried from the horizon over it
    Erode,        // its base is a surface of its own that cuts away older units
    Onlap,        // its top is a surface of its own, up to which it fills the relief of older units
    Base,         // its base is a surface of its own, on which younger units stand with their thickness
};

//! "conformable", "erode", "onlap" or "base".
//! \throw InvalidInput for any other name.
LayerRule layer_rule(std::string_view name);
std::string_view name_of(LayerRule rule);

//! Rules by unit, top first; empty vectors mean conformable and no minimum everywhere.
struct LayerRules {
    std::vector<LayerRule> rule;
    std::vector<double> min_thickness;  // where the unit is present between holes; 0 = none

    LayerRule of(std::size_t unit) const { return unit < rule.size() ? rule[unit] : LayerRule::Conformable; }
    double minimum(std::size_t unit) const { return unit < min_thickness.size() ? min_thickness[unit] : 0; }
    bool cut() const;  // any unit that is not conformable
    bool any() const;  // that, or any minimum
};

//! What somebody said of one unit, or of all that are not named otherwise.
struct NamedRule {
    std::string code;  // of the unit; empty = all
    std::optional<LayerRule> rule;
    std::optional<double> min_thickness;  // >= 0
};

//! Rules for a survey's units. A later word on the same unit replaces an earlier one; a word on a unit goes before one on all.
//! \throw InvalidInput that lists the units, for a code that is none of them, or for a minimum below 0.
LayerRules layer_rules(const std::vector<Unit>& units, const std::vector<NamedRule>& named);

//! Units that were laid down without a break: those between two surfaces that are predicted as elevations.
struct LayerSequence {
    std::size_t first = 0, last = 0;  // units, top first
    //! Stands on its base, cut or filled up at its top; otherwise it hangs from its top, and the last unit takes up what is
    //! left above `anchored` bases.
    bool stands = false;
    bool anchored = false;  // the horizon below `last` is predicted as an elevation
    bool on_onlap = false;  // that horizon is the top of an onlapping unit, `last + 1`
    bool onlaps = false;    // `first` fills up to its own top

    //! The unit whose thickness is not carried but what is left; units if there is none.
    std::size_t slack(std::size_t units) const { return stands ? first : anchored ? last : units; }
};

//! The column cut into sequences, top first. Without rules that cut: one that hangs from the ground.
std::vector<LayerSequence> layer_sequences(const LayerRules& rules, std::size_t units);

}  // namespace stratareeb
