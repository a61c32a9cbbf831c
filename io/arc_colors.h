// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "io/mesh_part.h"
#include "reeb/reeb_graph.h"

namespace stratareeb {

//! Colours that people with any colour vision tell apart (P. Tol's muted scheme): nine, then the same ones lighter and darker, then
//! all again.
Rgb palette_color(std::size_t i);

//! A colour for each arc, the same in every run; arcs that share a node differ, up to 27 arcs at a node.
std::vector<Rgb> arc_colors(const ReebGraph& graph);

//! Minima blue, saddles yellow, maxima red (of M. Okabe and K. Ito's scheme).
Rgb node_color(CriticalType type);

}  // namespace stratareeb
