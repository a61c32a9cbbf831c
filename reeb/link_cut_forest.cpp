// SPDX-License-Identifier: GPL-3.0-or-later
#include "reeb/link_cut_forest.h"

#include <utility>

namespace stratareeb {

LinkCutForest::LinkCutForest(std::vector<std::uint32_t> keys) : keys_(std::move(keys)), items_(keys_.size()) {
    for (std::uint32_t i = 0; i < items_.size(); ++i) items_[i].smallest = i;
}

bool LinkCutForest::is_splay_root(std::uint32_t i) const {
    const std::uint32_t parent = items_[i].parent;
    return parent == kNone || (items_[parent].child[0] != i && items_[parent].child[1] != i);
}

bool LinkCutForest::is_smaller(std::uint32_t a, std::uint32_t b) const {
    return keys_[a] < keys_[b] || (keys_[a] == keys_[b] && a < b);
}

void LinkCutForest::push(std::uint32_t i) {
    Item& item = items_[i];
    if (!item.reversed) return;
    std::swap(item.child[0], item.child[1]);
    for (const std::uint32_t c : item.child)
        if (c != kNone) items_[c].reversed = !items_[c].reversed;
    item.reversed = false;
}

void LinkCutForest::pull(std::uint32_t i) {
    Item& item = items_[i];
    item.smallest = i;
    for (const std::uint32_t c : item.child)
        if (c != kNone && is_smaller(items_[c].smallest, item.smallest)) item.smallest = items_[c].smallest;
}

void LinkCutForest::rotate(std::uint32_t i) {
    const std::uint32_t p = items_[i].parent, g = items_[p].parent;
    const int side = items_[p].child[1] == i;
    if (!is_splay_root(p)) items_[g].child[items_[g].child[1] == p] = i;
    items_[i].parent = g;
    const std::uint32_t moved = items_[i].child[1 - side];
    items_[p].child[side] = moved;
    if (moved != kNone) items_[moved].parent = p;
    items_[i].child[1 - side] = p;
    items_[p].parent = i;
    pull(p);
    pull(i);
}

void LinkCutForest::splay(std::uint32_t i) {
    stack_.assign(1, i);
    for (std::uint32_t a = i; !is_splay_root(a);) stack_.push_back(a = items_[a].parent);
    for (; !stack_.empty(); stack_.pop_back()) push(stack_.back());
    while (!is_splay_root(i)) {
        const std::uint32_t p = items_[i].parent;
        if (!is_splay_root(p)) {
            const std::uint32_t g = items_[p].parent;
            rotate((items_[p].child[1] == i) == (items_[g].child[1] == p) ? p : i);
        }
        rotate(i);
    }
}

//! Make the path from the tree's root to i one splay tree with i at its top.
void LinkCutForest::expose(std::uint32_t i) {
    std::uint32_t below = kNone;
    for (std::uint32_t a = i; a != kNone; a = items_[a].parent) {
        splay(a);
        items_[a].child[1] = below;
        pull(a);
        below = a;
    }
    splay(i);
}

void LinkCutForest::make_root(std::uint32_t i) {
    expose(i);
    items_[i].reversed = !items_[i].reversed;
}

void LinkCutForest::link(std::uint32_t a, std::uint32_t b) {
    make_root(a);
    items_[a].parent = b;
}

void LinkCutForest::cut(std::uint32_t a, std::uint32_t b) {
    make_root(a);
    expose(b);
    push(b);
    items_[items_[b].child[0]].parent = kNone;
    items_[b].child[0] = kNone;
    pull(b);
}

std::uint32_t LinkCutForest::smallest_between(std::uint32_t a, std::uint32_t b) {
    make_root(a);
    expose(b);
    return items_[b].smallest;
}

std::vector<std::uint32_t> LinkCutForest::path(std::uint32_t a, std::uint32_t b) {
    make_root(a);
    expose(b);
    std::vector<std::uint32_t> result, open;
    for (std::uint32_t i = b; i != kNone || !open.empty();) {
        for (; i != kNone; i = items_[i].child[0]) {
            push(i);
            open.push_back(i);
        }
        result.push_back(open.back());
        i = items_[open.back()].child[1];
        open.pop_back();
    }
    return result;
}

}  // namespace stratareeb
