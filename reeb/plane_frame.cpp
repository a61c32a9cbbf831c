// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/plane_frame.h"

#include "reeb/point_math.h"

namespace stratareeb {

PlaneFrame plane_frame(const Point3& normal) {
    const double size = magnitude(normal);
    if (size == 0) return {};
    const Point3 w = (1 / size) * normal;
    const double tilt = w.x * w.x + w.y * w.y;
    if (tilt == 0) return w.z > 0 ? PlaneFrame{} : PlaneFrame{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    // Rodrigues' rotation by the angle between z and w; (1 - cos) / sin^2 written so that nothing cancels.
    const double k = w.z > 0 ? 1 / (1 + w.z) : (1 - w.z) / tilt;
    return {{1 - k * w.x * w.x, -k * w.x * w.y, -w.x}, {-k * w.x * w.y, 1 - k * w.y * w.y, -w.y}, w};
}

}  // namespace stratareeb
