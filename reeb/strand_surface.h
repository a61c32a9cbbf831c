// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "reeb/band_surface.h"
#include "reeb/curve.h"
#include "reeb/homotopy_weights.h"
#include "reeb/surface_memory.h"

namespace stratareeb {

//! What else there is for a place where contours of the homotopy cross something.
enum class Join {
    ByShape,   // contours between, but of contours matched by shape (see matched_contour)
    Straight,  // without contours between
    Sheet,     // see plan_sheet; straight where there is none
};

//! How a strand ends.
struct StrandEnd {
    enum class Kind {
        Tip,       // at a minimum or maximum
        Flat,      // the last contour is closed by its inside
        Ridge,     // a minimum or maximum all along a ring, where an outer contour and a hole's meet
        Approach,  // rows lead from the last contour to a ring at a saddle
        Ring,      // a ring at a saddle comes after the last contour, and is one of the homotopy's
        Through,   // the last contour is a ring at a saddle itself
        Sheet,     // the last contour is a ring that a sheet goes on from
    };
    Kind kind = Kind::Tip;
    Point3 node{};
    std::uint32_t group = 0;  // with which what is next to a saddle moves
    std::vector<SampledContour>
        approach{};  // from the last contour to the node, the ring's own shape left out
    std::optional<Ring> ring{};
    bool is_outline =
        false;  // the last contour is a polygon, as of something measured: its cap keeps within it
};

//! A family of contours from one node up to another.
struct Strand {
    std::vector<SampledContour> contours;  // given, bottom to top
    std::vector<double> heights;
    HomotopyOptions homotopy;
    std::optional<Curve> lean;  // the edge's curve, if contours between are to lean along it
    bool is_hole = false;
    bool is_terrain = false;  // gentle places are sheets where they can be
    StrandEnd bottom{}, top{};
    //! How places are joined other than by the homotopy: 0 at the bottom end, k between the k-th ring and the next, and so on
    //! to the top end. Rings are the contours, and those of ends that are rings.
    std::map<std::size_t, Join> joins{};
};

//! Add a strand's bands, `steps` between two contours; three at least beside a ring at a saddle, which may visit the critical point
//! more than once. Tells of each place before its triangles come, and is told with which group those of a sheet there move.
//! \return how many places were joined straight
std::size_t add_strand(BandSurface& surface, const Strand& strand, std::size_t steps, SheetMemory& sheets,
                       const std::function<std::uint32_t(std::size_t place)>& begin_place);

}  // namespace stratareeb
