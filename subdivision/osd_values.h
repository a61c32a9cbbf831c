// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "boreholes/point.h"

namespace stratareeb {

//! OpenSubdiv builds values by Clear and AddWithWeight on dst[i] from src[i]. These views make plain arrays do.
struct Numbers {
    double* data;
    struct Number {
        double& value;
        operator double() const { return value; }
        void Clear() { value = 0; }
        void AddWithWeight(double other, double weight) { value += weight * other; }
    };
    Number operator[](int i) const { return {data[i]}; }
};

struct Points {
    Point3* data;
    struct Point {
        Point3& value;
        operator const Point3&() const { return value; }
        void Clear() { value = {}; }
        void AddWithWeight(const Point3& other, double weight) {
            value.x += weight * other.x;
            value.y += weight * other.y;
            value.z += weight * other.z;
        }
    };
    Point operator[](int i) const { return {data[i]}; }
};

inline Numbers destination(std::vector<double>& values) {
    return {values.data()};
}
inline Points destination(std::vector<Point3>& values) {
    return {values.data()};
}

using WeightedVertices = std::vector<std::pair<std::uint32_t, double>>;  // vertices and their weights

// Collects the weights that OpenSubdiv gives to control vertices, instead of adding values up.
struct VertexNumbers {
    int operator[](int i) const { return i; }
};
struct WeightRows {
    std::vector<WeightedVertices>* rows;
    struct Row {
        WeightedVertices& terms;
        void Clear() { terms.clear(); }
        void AddWithWeight(int vertex, double weight) {
            terms.emplace_back(static_cast<std::uint32_t>(vertex), weight);
        }
    };
    Row operator[](int i) const { return {(*rows)[i]}; }
};

}  // namespace stratareeb
