// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/readable_graph.h"

#include <array>

#include "reeb/collapse_plateaus.h"
#include "reeb/simplify.h"

namespace stratareeb {

ReadableGraph readable_graph(const TriMesh& mesh, const ScalarField& field, std::size_t most_nodes) {
    constexpr std::array<double, 6> kShares{0.005, 0.01, 0.02, 0.05, 0.1, 0.2};
    ReadableGraph readable{.fine = reeb_graph(mesh, field), .graph = {}, .share = 0};
    const ReebGraph collapsed = collapse_plateaus(readable.fine);
    readable.graph = collapsed;
    for (const double share : kShares) {
        if (readable.graph.nodes.size() <= most_nodes) break;
        readable.graph = simplify(collapsed, mesh, field, share).graph;
        readable.share = share;
    }
    return readable;
}

}  // namespace stratareeb
