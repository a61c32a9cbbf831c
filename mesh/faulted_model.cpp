// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/faulted_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"
#include "mesh/join_blocks.h"

namespace stratareeb {

namespace {

constexpr double kBorderEdge = 0.75;  // of the spacing

//! Borders in pieces of the spacing, which two neighbours then have in common.
Footprint with_short_sides(const Footprint& outline, double spacing) {
    if (spacing <= 0) return outline;
    Footprint result;
    for (const auto& ring : outline) {
        auto& pieces = result.emplace_back();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            // From the lower end, so that both neighbours compute the same points.
            Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
            const bool turned = std::pair(b.x, b.y) < std::pair(a.x, a.y);
            if (turned) std::swap(a, b);
            const int count = std::max(
                1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / (kBorderEdge * spacing))));
            for (int k = 0; k < count; ++k) {
                const double t = static_cast<double>(turned ? count - k : k) / count;
                pieces.push_back(t == 0   ? a
                                 : t == 1 ? b
                                          : Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
            }
        }
    }
    return result;
}

Footprint relative(Footprint footprint, const Point3& origin) {
    for (auto& ring : footprint)
        for (Point2& p : ring) p = {p.x - origin.x, p.y - origin.y};
    return footprint;
}

//! The part of a survey that stands in one block; holes of other blocks say what no hole of this one says.
class BlockSurvey {
 public:
    BlockSurvey(const Survey& survey, const std::vector<std::uint32_t>& holes) : survey_(survey) {
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

LayerModel build_faulted_model(const Survey& survey, const FaultTraces& traces, LayerModelOptions options,
                               const std::function<LayerModel(LayerModel)>& finish) {
    const CompleteColumns columns =
        complete_columns(survey, {options.interpolator, options.pinch_out, options.terrain});
    const auto& sites = columns.sites;
    const Footprint footprint =
        checked_footprint(options.footprint ? *options.footprint : hull_footprint(HoleTriangulation(sites)));
    const FaultBlocks parts = fault_blocks(footprint, traces, sites);
    options.origin = suitable_origin(sites, columns.ground);
    options.spacing =
        options.spacing.value_or(options.spacing_factor * suitable_spacing(footprint, survey.holes.size()));
    if (parts.outline.size() == 1) {
        LayerModel model = build_layer_model(survey, options);
        model.notes.insert(model.notes.end(), parts.notes.begin(), parts.notes.end());
        model.notes.push_back("no fault trace parts the footprint; the model has no faults");
        return finish ? finish(std::move(model)) : model;
    }
    std::vector<std::vector<std::uint32_t>> holes(parts.outline.size());
    for (std::uint32_t h = 0; h < parts.block_of.size(); ++h) holes[parts.block_of[h]].push_back(h);

    std::vector<LayerModel> blocks;
    std::vector<Footprint> outlines;
    for (std::size_t b = 0; b < parts.outline.size(); ++b) {
        options.footprint = with_short_sides(parts.outline[b], *options.spacing);
        outlines.push_back(relative(*options.footprint, *options.origin));
        try {
            std::vector<std::string> notes;
            const Survey part = BlockSurvey(survey, holes[b]).run(notes);
            LayerModel block = build_layer_model(part, options);
            block.notes.insert(block.notes.begin(), notes.begin(), notes.end());
            blocks.push_back(finish ? finish(std::move(block)) : std::move(block));
        } catch (const InvalidInput& error) {
            const Point2& at = parts.outline[b][0][0];
            throw InvalidInput(fmt::format("block {} ({} holes, a corner at x {:.10g}, y {:.10g}): {}", b + 1,
                                           holes[b].size(), at.x, at.y, error.what()));
        }
    }
    LayerModel model = join_blocks(std::move(blocks), outlines, holes);
    model.notes.insert(model.notes.begin(), parts.notes.begin(), parts.notes.end());
    return model;
}

}  // namespace stratareeb
