// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "mesh/triangle_soup.h"
#include "reeb/band_surface.h"
#include "reeb/enhanced_reeb_graph.h"
#include "reeb/surface_memory.h"

namespace stratareeb {

struct SurfaceOptions {
    std::size_t steps = 6;     // bands between two given contours, or a contour and a critical point
    std::size_t samples = 96;  // points on a contour that is no polygon
    double reach = 0.25;       // share of a contour that is drawn to a critical point with it (see Guide)
    BandTriangulation triangulation = BandTriangulation::Automatic;
    bool avoid_crossings = true;  // see below
    bool fairing = true;          // beside saddles and over terrain, see below
    bool terrain =
        false;  // gentle places as thin plates over the plan instead of the edges' homotopies, see below
};

inline constexpr std::uint32_t kNoPart = ~std::uint32_t{0};

//! A closed surface, outward, with what each triangle was made from.
struct ConstructedSurface {
    TriangleSoup soup;
    std::vector<std::uint32_t> triangle_edge;  // by triangle: edge of the graph
    std::vector<std::uint32_t>
        triangle_part;  // by triangle: the place on an edge, by a number of its own; kNoPart where it has none
    // Where the surface crosses itself all the same: pairs of places, each between two contours of an edge, in words. Not looked for unless
    // crossings are to be avoided.
    std::vector<std::string> crossings;
    std::size_t straightened = 0;  // places where contours were joined straight to avoid crossings
};

//! The surface that an enhanced Reeb graph describes (thesis 2.1.2.3 and 2.1.2.4). Along an edge, contours between the given
//! ones follow its homotopy, and lean along its curve if it has points of its own; a minimum or maximum closes the last contour by
//! a cap (see CapProfile), or flat if that contour lies at its height. A node at which an outer contour and a hole's begin, or end, becomes
//! a ridge all around between them.
//! At a saddle where no contour crosses another one in plan, what is between them is a sheet with one height for each place (see plan_sheet).
//! At any other one, contours of the side with more of them are drawn to the critical point by quadrant guiding curves, or pass through it
//! already; there they run together into those of the other side. With `fairing`, both then bend as little as they can without a change
//! of the Reeb graph, and without a kink at the given contours (see fair_surface).
//! With `terrain`, places no steeper than 63 degrees in the mean are such sheets too, along edges without a curve of their own.
//! The surface rises and falls nowhere but along edges: its Reeb graph over height is the given one (plateaus as one node). All given contours
//! are on the surface, point by point. Where contours between would cross something, those around are joined by a sheet, or else straight,
//! and saddles are left as made; what crosses still is named.
//! \throw InvalidInput if faults_of(graph) finds any, or where a node leaves open how its contours run together: it names the node and
//! the way out.
ConstructedSurface construct_surface(const EnhancedReebGraph& graph, const SurfaceOptions& options = {});

//! What is to be done with a surface before it is asked where it crosses itself, the graph that names places (it has the same edges), and what
//! is known of surfaces made before.
struct SurfaceFinish {
    std::function<void(ConstructedSurface&)> run = {};
    const EnhancedReebGraph* named = nullptr;
    SurfaceMemory* memory = nullptr;
};
ConstructedSurface construct_surface(const EnhancedReebGraph& graph, const SurfaceOptions& options,
                                     const SurfaceFinish& finish);

}  // namespace stratareeb
