// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_soup.h"

namespace stratareeb {

//! A triangle mesh's discrete Laplacian, area(v) (Lf)(v) = sum of weight(v, w) (f(w) - f(v)) over the neighbours: half the sum of
//! the cotangents of both angles opposite to an edge, and a third of the triangles around a vertex (M. Meyer et al. 2003).
struct CotangentWeights {
    struct Edge {
        std::uint32_t a = 0, b = 0;
        double weight = 0;
    };
    std::vector<Edge> edges;   // one for each edge of a triangle, so that a mesh's inner edges come twice
    std::vector<double> area;  // by vertex
    std::vector<bool>
        is_regular;  // by vertex: no triangle around it is as thin as a line, or folded over another one in plan
};

enum class WeightSpace {
    Plan,   // of the triangles' projections: for functions over the plan
    Space,  // of the triangles
};

//! Of those triangles that have a vertex which is asked for.
CotangentWeights cotangent_weights(const TriangleSoup& soup, WeightSpace space,
                                   const std::vector<bool>& is_asked);

}  // namespace stratareeb
