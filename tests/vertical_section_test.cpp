// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertical_section.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "boreholes/errors.h"
#include "boreholes/random_survey.h"
#include "mesh/model_column.h"
#include "mesh/section_holes.h"
#include "reeb/level_set.h"

namespace stratareeb {
namespace {

LayerModel random_model(std::uint64_t seed, Point2 corner = {}) {
    LayerModelOptions options;
    if (seed % 3 == 0) options.spacing = 0;
    return build_layer_model(random_survey({.holes = 30,
                                            .layers = 5,
                                            .seed = seed,
                                            .corner = corner,
                                            .plan = seed % 2 ? HolePlan::Random : HolePlan::Clustered,
                                            .truth = seed % 2 ? TruthKind::Lens : TruthKind::Random,
                                            .pinch_outs = true,
                                            .zero_share = 0.3}),
                             options);
}

std::vector<Point2> random_line(std::mt19937_64& random, std::size_t points) {
    std::uniform_real_distribution<double> anywhere(-60, 360);
    std::vector<Point2> line;
    for (std::size_t i = 0; i < points; ++i) line.push_back({anywhere(random), anywhere(random)});
    return line;
}

double area_of(const std::vector<SectionPolygon>& polygons, std::size_t layer) {
    double sum = 0;
    for (const SectionPolygon& polygon : polygons)
        if (polygon.layer == layer) sum += area(polygon);
    return sum;
}

TEST(VerticalSection, polygons_tile_the_envelope) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const PlanLocator locator(model.plan.surface);
        std::mt19937_64 random(seed);
        for (int k = 0; k < 10; ++k) {
            auto line = random_line(random, 2 + static_cast<std::size_t>(k) % 4);
            line[0] = {150, 150};  // some of it lies inside
            const VerticalSection section = vertical_section(model, locator, line);
            const auto polygons = section_polygons(section);
            double sum = 0;
            for (const SectionPolygon& polygon : polygons) {
                EXPECT_GT(area(polygon), 0);
                EXPECT_GE(polygon.outline.size(), 3u);
                sum += area(polygon);
            }
            EXPECT_NEAR(sum, envelope_area(section), 1e-9 * envelope_area(section));
        }
    }
}

// The other way: the contour of each solid where the plane meets it.
TEST(VerticalSection, is_the_plane_s_intersection_with_the_solids) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const LayerModel model = random_model(seed);
        const PlanLocator locator(model.plan.surface);
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> turn(0.1, 3);
        const double angle = turn(random);
        const Point3 normal{-std::sin(angle), std::cos(angle), 0};
        const Point2 middle{149.37, 151.21}, way{1000 * std::cos(angle), 1000 * std::sin(angle)};
        const VerticalSection section = vertical_section(
            model, locator, {{middle.x - way.x, middle.y - way.y}, {middle.x + way.x, middle.y + way.y}});
        const auto polygons = section_polygons(section);
        for (std::size_t layer = 0; layer < model.units.size(); ++layer) {
            const TriMesh solid = build_layer_solid(model, layer).surface;
            if (solid.n_faces() == 0) continue;
            const std::array level{normal.x * middle.x + normal.y * middle.y};
            double expected = 0;
            for (const LevelSet& set : level_sets(solid, height_field(solid, normal), level))
                for (const Contour& contour : set.contours) expected += std::abs(contour.area(normal));
            EXPECT_NEAR(area_of(polygons, layer), expected, 1e-8 * envelope_area(section));
        }
    }
}

TEST(VerticalSection, stations_lie_on_the_line_and_on_the_horizons) {
    const LayerModel model = random_model(5, {5e6, 4.9e6});
    const PlanLocator locator(model.plan.surface);
    const ColumnQuery query(model);
    const std::vector<Point2> line{{5e6 + 20, 4.9e6 + 30}, {5e6 + 250, 4.9e6 + 90}, {5e6 + 100, 4.9e6 + 280}};
    const VerticalSection section = vertical_section(model, locator, line);
    ASSERT_EQ(section.runs.size(), 1u);
    EXPECT_EQ(section.runs[0].front().along, 0);
    EXPECT_NEAR(section.runs[0].back().along, section.length(), 1e-9);
    double last = -1;
    for (const SectionStation& station : section.runs[0]) {
        EXPECT_GT(station.along, last);
        last = station.along;
        const auto column = query.column(station.at);
        ASSERT_TRUE(column);
        for (std::size_t k = 0; k < station.horizons.size(); ++k)
            EXPECT_NEAR(station.horizons[k], column->horizons[k], 1e-6);
        const std::size_t piece = station.along <= section.corners[1] ? 0 : 1;
        EXPECT_NEAR(std::hypot(station.at.x - line[piece].x, station.at.y - line[piece].y),
                    station.along - section.corners[piece], 1e-6);
    }
}

TEST(VerticalSection, leaves_out_what_lies_outside) {
    // A footprint with a bay: the line crosses land, bay, land.
    const Survey survey = random_survey({.holes = 40, .layers = 2, .seed = 3});
    LayerModelOptions options;
    options.footprint =
        Footprint{{{0, 0}, {300, 0}, {300, 300}, {200, 300}, {200, 100}, {100, 100}, {100, 300}, {0, 300}}};
    const LayerModel model = build_layer_model(survey, options);
    const VerticalSection section =
        vertical_section(model, PlanLocator(model.plan.surface), {{-50, 200}, {350, 200}});
    ASSERT_EQ(section.runs.size(), 2u);
    EXPECT_NEAR(section.runs[0].front().along, 50, 1e-9);
    EXPECT_NEAR(section.runs[0].back().along, 150, 1e-9);
    EXPECT_NEAR(section.runs[1].front().along, 250, 1e-9);
    EXPECT_NEAR(section.runs[1].back().along, 350, 1e-9);
}

TEST(VerticalSection, follows_the_outline_and_mesh_edges) {
    const Survey survey = random_survey({.holes = 20, .layers = 3, .seed = 9});
    const LayerModel model = build_layer_model(survey);
    const PlanLocator locator(model.plan.surface);
    const VerticalSection rim = vertical_section(model, locator, {{0, 0}, {300, 0}});
    ASSERT_EQ(rim.runs.size(), 1u);
    EXPECT_EQ(rim.runs[0].front().along, 0);
    EXPECT_EQ(rim.runs[0].back().along, 300);
    for (const auto e : model.plan.surface.edges()) {
        const auto h = model.plan.surface.halfedge_handle(e, 0);
        const auto u = model.plan.surface.from_vertex_handle(h), v = model.plan.surface.to_vertex_handle(h);
        const auto &p = model.plan.surface.point(u), &q = model.plan.surface.point(v);
        const VerticalSection edge = vertical_section(model, locator, {{p[0], p[1]}, {q[0], q[1]}});
        ASSERT_EQ(edge.runs.size(), 1u);
        for (std::size_t k = 0; k < model.horizons.size(); ++k) {
            EXPECT_EQ(edge.runs[0].front().horizons[k], model.horizons[k][static_cast<std::size_t>(u.idx())]);
            EXPECT_EQ(edge.runs[0].back().horizons[k], model.horizons[k][static_cast<std::size_t>(v.idx())]);
        }
    }
}

TEST(VerticalSection, refuses_lines_that_show_nothing) {
    const LayerModel model = random_model(1);
    const PlanLocator locator(model.plan.surface);
    EXPECT_THROW(vertical_section(model, locator, {}), InvalidInput);
    EXPECT_THROW(vertical_section(model, locator, {{1, 1}}), InvalidInput);
    EXPECT_THROW(vertical_section(model, locator, {{1, 1}, {1, 1}}), InvalidInput);
    EXPECT_THROW(vertical_section(model, locator, {{1, std::nan("")}, {1, 1}}), InvalidInput);
    EXPECT_THROW(vertical_section(model, locator, {{1000, 1000}, {2000, 1000}}), InvalidInput);
}

TEST(SectionHoles, a_fence_through_holes_shows_each_hole_s_own_log) {
    const Survey survey = random_survey({.holes = 25, .layers = 4, .seed = 6, .zero_share = 0.2});
    const LayerModel model = build_layer_model(survey);
    const std::vector<std::string> ids{survey.holes[3].id, survey.holes[17].id, survey.holes[8].id};
    const VerticalSection section =
        vertical_section(model, PlanLocator(model.plan.surface), line_through(survey, ids));
    std::size_t seen = 0;
    for (const SectionHole& hole : holes_along(section, survey, 1e-9)) {
        if (std::ranges::find(ids, hole.id) == ids.end()) continue;
        ++seen;
        const auto& run = section.runs.at(0);
        const auto station = std::ranges::min_element(
            run, {}, [&](const SectionStation& s) { return std::abs(s.along - hole.along); });
        EXPECT_NEAR(station->along, hole.along, 1e-9);
        for (const LogInterval& interval : hole.log) {
            EXPECT_NEAR(station->horizons[interval.layer], interval.top, 1e-9);
            EXPECT_NEAR(station->horizons[interval.layer + 1], interval.base, 1e-9);
        }
    }
    EXPECT_EQ(seen, 3u);
    EXPECT_THROW(line_through(survey, {"nobody"}), InvalidInput);
}

TEST(SectionHoles, a_log_has_what_the_hole_knows_and_no_more) {
    Borehole hole{
        .id = "A", .at = {}, .layers = {}, .horizons = {10.0, 8.0, std::nullopt, 3.0, std::nullopt}};
    hole.layers = {{Knowledge::Measured, 2},
                   {Knowledge::Unknown, 0},
                   {Knowledge::Measured, 1},
                   {Knowledge::AtLeast, 0.5}};
    const auto log = log_of(hole);
    ASSERT_EQ(log.size(), 2u);  // the third layer's top is not known
    EXPECT_EQ(log[0].layer, 0u);
    EXPECT_EQ(log[0].base, 8);
    EXPECT_EQ(log[1].layer, 3u);
    EXPECT_EQ(log[1].top, 3);
    EXPECT_EQ(log[1].base, 2.5);
    EXPECT_TRUE(log[1].goes_on);
}

}  // namespace
}  // namespace stratareeb
