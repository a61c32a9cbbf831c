// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "boreholes/point.h"

//! Points as vectors. For .cpp files only, so that no header brings these operators along.
namespace stratareeb {

inline Point3 operator+(const Point3& a, const Point3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 operator-(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point3 operator*(double k, const Point3& a) {
    return {k * a.x, k * a.y, k * a.z};
}
inline Point3& operator+=(Point3& a, const Point3& b) {
    return a = a + b;
}

inline double dot_product(const Point3& a, const Point3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point3 cross_product(const Point3& a, const Point3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double magnitude(const Point3& a) {
    return std::hypot(a.x, a.y, a.z);
}

inline bool is_finite(const Point3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

//! The point at u in [0, 1] from a to b; a and b themselves at 0 and 1.
inline Point3 between(const Point3& a, const Point3& b, double u) {
    return u == 1 ? b : a + u * (b - a);
}

}  // namespace stratareeb
