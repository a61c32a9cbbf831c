// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace stratareeb {

//! Trees that grow, are cut and are asked for the smallest key on a path, in logarithmic time a call, amortised (D. Sleator and
//! R. Tarjan 1985: paths are kept in splay trees). Items are numbered 0, 1, …; each has a key. To give keys to the links of a
//! tree, make each link an item of its own, between its two ends.
class LinkCutForest {
 public:
    //! As many trees of one item as there are keys.
    explicit LinkCutForest(std::vector<std::uint32_t> keys);

    //! \pre a and b are in different trees.
    void link(std::uint32_t a, std::uint32_t b);

    //! \pre a and b are linked.
    void cut(std::uint32_t a, std::uint32_t b);

    //! The item of smallest key between a and b, both included; of equal keys the item of smallest number.
    //! \pre a and b are in one tree.
    std::uint32_t smallest_between(std::uint32_t a, std::uint32_t b);

    //! Items from a to b, both included. Takes time in proportion to their number.
    //! \pre a and b are in one tree.
    std::vector<std::uint32_t> path(std::uint32_t a, std::uint32_t b);

 private:
    static constexpr std::uint32_t kNone = ~0u;

    struct Item {
        std::uint32_t parent = kNone;  // in the splay tree; of its root, where the path hangs
        std::array<std::uint32_t, 2> child{kNone, kNone};
        std::uint32_t smallest = 0;  // of its splay subtree
        bool reversed = false;       // children yet to be swapped, all the way down
    };

    bool is_splay_root(std::uint32_t i) const;
    bool is_smaller(std::uint32_t a, std::uint32_t b) const;
    void push(std::uint32_t i);
    void pull(std::uint32_t i);
    void rotate(std::uint32_t i);
    void splay(std::uint32_t i);
    void expose(std::uint32_t i);
    void make_root(std::uint32_t i);

    std::vector<std::uint32_t> keys_;
    std::vector<Item> items_;
    std::vector<std::uint32_t> stack_;
};

}  // namespace stratareeb
