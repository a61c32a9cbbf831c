// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/face_tree.h"

#include <algorithm>

namespace stratareeb {

FaceTree::FaceTree(const ControlTopology& topology, const PolygonMesh& control, SubdivisionScheme scheme)
    : scheme_(scheme), size_(scheme == SubdivisionScheme::Loop ? 3 : 4) {
    for (int level = 0; level <= topology.levels(); ++level) corners_.push_back(topology.corners(level));
    first_.reserve(control.face_count() + 1);
    first_.push_back(0);
    for_each_face(control, [&](std::size_t, std::span<const std::uint32_t> face) {
        first_.push_back(first_.back() + face.size());
    });
}

std::size_t FaceTree::face_count(int level) const {
    return level == 0 ? first_.size() - 1 : corners_[level].size() / size_;
}

std::span<const std::uint32_t> FaceTree::corners(int level, std::size_t face) const {
    const std::span<const std::uint32_t> all = corners_[level];
    if (level == 0) return all.subspan(first_[face], first_[face + 1] - first_[face]);
    return all.subspan(size_ * face, size_);
}

std::size_t FaceTree::child_count(int level, std::size_t face) const {
    if (scheme_ == SubdivisionScheme::Loop) return 4;
    return corners(level, face).size();
}

void FaceTree::open(int level, std::size_t face, TreeFace& opened) const {
    opened.corners = corners(level, face);
    // Catmull-Clark makes a quad at each corner of a polygon, Loop a triangle at each corner and one in the middle.
    opened.first_child = scheme_ == SubdivisionScheme::Loop ? 4 * face : level == 0 ? first_[face] : 4 * face;
    opened.middles.clear();
    for (std::size_t i = 0; i < opened.corners.size(); ++i) {
        const auto child = corners(level + 1, opened.first_child + i);
        const auto at = static_cast<std::size_t>(std::ranges::find(child, opened.corners[i]) - child.begin());
        opened.middles.push_back(child[(at + 1) % child.size()]);
        opened.centre = child[(at + 2) % child.size()];
    }
}

}  // namespace stratareeb
