// SPDX-License-Identifier: GPL-3.0-or-later
#include "boreholes/block_survey.h"

#include <fmt/format.h>

#include <algorithm>

namespace stratareeb {

namespace {

//! The part of a survey that stands in one block; holes of other blocks say what no hole of this one says.
class BlockSurvey {
 public:
    BlockSurvey(const Survey& survey, std::span<const std::uint32_t> holes) : survey_(survey) {
        part_ = {.units = survey.units,
                 .holes = {},
                 .contact_points = survey.contact_points,
                 .length_unit = survey.length_unit};
        std::vector<char> own(survey.holes.size(), 0);
        for (const std::uint32_t h : holes) {
            part_.holes.push_back(survey.holes[h]);
            own[h] = 1;
        }
        for (std::size_t h = 0; h < own.size(); ++h)
            if (!own[h]) others_.push_back(&survey.holes[h]);
    }

    Survey run(std::vector<std::string>& notes) {
        const std::size_t count = survey_.contact_points ? survey_.units.size() + 1 : survey_.units.size();
        std::vector<char> missing(count);
        for (std::size_t i = 0; i < count; ++i)
            missing[i] =
                std::ranges::none_of(part_.holes, [&](const Borehole& hole) { return says(hole, i); });
        for (std::size_t i = 0; i < count; ++i)
            if (missing[i] &&
                std::ranges::any_of(others_, [&](const Borehole* hole) { return says(*hole, i); }))
                notes.push_back(
                    fmt::format("no hole of this block knows {} of '{}'; those of the other blocks count",
                                survey_.contact_points ? "the contact" : "the thickness",
                                survey_.units[survey_.contact_points && i > 0 ? i - 1 : i].code));
        for (const Borehole* hole : others_) borrow(*hole, missing);
        return std::move(part_);
    }

 private:
    //! Something of a layer, or of a horizon where there are contact points.
    bool says(const Borehole& hole, std::size_t i) const {
        return survey_.contact_points ? hole.horizons[i].has_value()
                                      : hole.layers[i].knowledge != Knowledge::Unknown;
    }

    void borrow(const Borehole& hole, const std::vector<char>& missing) {
        Borehole reduced = hole;
        bool any = false;
        reduced.horizons.assign(survey_.units.size() + 1, std::nullopt);
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const bool taken = missing[i] && says(hole, i);
            any |= taken;
            if (survey_.contact_points && taken) reduced.horizons[i] = hole.horizons[i];
            if (!survey_.contact_points && !taken) reduced.layers[i] = {};
        }
        if (any) part_.holes.push_back(std::move(reduced));
    }

    const Survey& survey_;
    Survey part_;
    std::vector<const Borehole*> others_;
};

}  // namespace

Survey survey_of_block(const Survey& survey, std::span<const std::uint32_t> holes,
                       std::vector<std::string>& notes) {
    return BlockSurvey(survey, holes).run(notes);
}

}  // namespace stratareeb
