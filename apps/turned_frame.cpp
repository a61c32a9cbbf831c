// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/turned_frame.h"

#include <algorithm>
#include <cmath>

#include "boreholes/errors.h"

namespace stratareeb {

PlaneFrame upward_frame(const Point3& direction) {
    // By the largest coordinate first: a direction may be too long or too short to be squared.
    const double most = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (!(most > 0)) throw InvalidInput("--field 0,0,0: the direction has no length");
    const Point3 d{direction.x / most, direction.y / most, direction.z / most};
    const double length = std::hypot(d.x, d.y, d.z), side = d.z < 0 ? -1 : 1;
    const Point3 u{d.x / length, side * d.y / length, side * d.z / length};
    const double k = 1 / (1 + u.z);
    return {.u = {1 - k * u.x * u.x, -side * k * u.x * u.y, -side * u.x},
            .v = {-k * u.x * u.y, side * (1 - k * u.y * u.y), -side * u.y},
            .w = {u.x, side * u.y, side * u.z}};
}

void turn_into(TriMesh& mesh, const PlaneFrame& frame) {
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        const Point3 turned = frame.turned({p[0], p[1], p[2]});
        mesh.set_point(v, {turned.x, turned.y, turned.z});
    }
}

void turn_back(TriangleSoup& soup, const PlaneFrame& frame) {
    const PlaneFrame back{.u = {frame.u.x, frame.v.x, frame.w.x},
                          .v = {frame.u.y, frame.v.y, frame.w.y},
                          .w = {frame.u.z, frame.v.z, frame.w.z}};
    for (Point3& p : soup.points) p = back.turned(p);
}

}  // namespace stratareeb
