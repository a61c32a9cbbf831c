// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/faulted_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boreholes/block_survey.h"
#include "boreholes/block_ties.h"
#include "boreholes/errors.h"
#include "mesh/join_blocks.h"
#include "mesh/tie_blocks.h"

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

Point2 relative(const Point2& p, const Point3& origin) {
    return {p.x - origin.x, p.y - origin.y};
}

Footprint relative(Footprint footprint, const Point3& origin) {
    for (auto& ring : footprint)
        for (Point2& p : ring) p = relative(p, origin);
    return footprint;
}

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

    const auto ties = tie_columns(survey, parts.block_of, parts.ties,
                                  {options.interpolator, options.pinch_out, options.terrain, options.rules},
                                  *options.spacing == 0);
    std::vector<LayerModel> blocks;
    std::vector<Footprint> outlines;
    for (std::size_t b = 0; b < parts.outline.size(); ++b) {
        options.footprint = with_short_sides(parts.outline[b], *options.spacing);
        outlines.push_back(relative(*options.footprint, *options.origin));
        try {
            std::vector<std::string> notes;
            Survey part = survey_of_block(survey, holes[b], notes);
            if (b < ties.size()) part.holes.insert(part.holes.end(), ties[b].begin(), ties[b].end());
            LayerModel block = build_layer_model(part, options);
            block.notes.insert(block.notes.begin(), notes.begin(), notes.end());
            blocks.push_back(finish ? finish(std::move(block)) : std::move(block));
        } catch (const InvalidInput& error) {
            const Point2& at = parts.outline[b][0][0];
            throw InvalidInput(fmt::format("block {} ({} holes, a corner at x {:.10g}, y {:.10g}): {}", b + 1,
                                           holes[b].size(), at.x, at.y, error.what()));
        }
    }
    std::vector<WayOn> ways_on;
    for (const WayOn& way : parts.ways_on)
        ways_on.push_back({relative(way.tip, *options.origin), relative(way.end, *options.origin)});
    LayerModel model = join_blocks(std::move(blocks), outlines, holes, {ways_on, way_on_tolerance(parts)});
    model.notes.insert(model.notes.begin(), parts.notes.begin(), parts.notes.end());
    return model;
}

}  // namespace stratareeb
