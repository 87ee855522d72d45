// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace planula {

/// Keeps the elements with these numbers, ascending, and no other.
template <class T> void keep_only(std::span<const int> kept, std::vector<T> &list) {
    for (std::size_t i = 0; i < kept.size(); ++i) list[i] = list[kept[i]];
    list.resize(kept.size());
}

} // namespace planula
