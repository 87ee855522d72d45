// SPDX-License-Identifier: MIT
#include "physics/native/contact.h"

#include <bit>
#include <cmath>

namespace planula::native {

void Contact::load(const Layout &layout, const Kernel &kernel) {
    layout_ = &layout, kernel_ = &kernel;
    stiffness_ = static_cast<float>(layout.model.body.contact_stiffness);
    reach_ = static_cast<float>(layout.model.body.contact_radius);
    watch_ = {}, listed_at_.clear(), touches_.clear();
    cells_.clear();
    for (const int cell : layout.model.contact_cells) cells_.push_back(place_of(cell));
    const std::size_t links = layout.outline.size() * group_size;
    circle_x_.resize(links), circle_y_.resize(links), circle_squared_radius_.resize(links);
    find_unmasked();
}

std::span<const Touch> Contact::touches(const Record *now, float moved) {
    if (cells_.empty() || watch_.sees_none(moved)) return {};
    if (list_is_stale(now)) make_list(now);
    measure(now);
    return touches_;
}

void Contact::find_unmasked() {
    const SoftBodyModel &model = layout_->model;
    const std::size_t words = words_for(static_cast<int>(layout_->outline.size()));
    unmasked_.assign(cells_.size() * words, 0), inside_.resize(unmasked_.size());
    std::size_t unmasked = 0;
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        for (std::size_t link = 0; link < model.outline.size(); ++link)
            if (!model.is_masked(cell, link))
                unmasked_[cell * words + link / word_size] |= Word(1) << link % word_size, ++unmasked;
    pairs_.resize((unmasked + group_size - 1) / group_size), near_.resize(pairs_.size());
}

bool Contact::list_is_stale(const Record *now) {
    if (listed_at_.empty()) return true;
    if (watch_.keeps_list()) return false;
    const Record *outline = now + layout_->outline_group() * group_size;
    const auto count = static_cast<int>(listed_at_.size());
    watch_.moved = std::sqrt(kernel_->squared_motion(listed_at_.data(), outline, count));
    return !watch_.keeps_list();
}

void Contact::make_list(const Record *now) {
    listed_at_.assign(now + layout_->outline_group() * group_size, now + layout_->groups * group_size);
    watch_.moved = 0;
    const int groups = static_cast<int>(layout_->outline.size());
    kernel_->circle_links(layout_->outline.data(), groups, now, watch_.listed_within(reach_),
                          circle_x_.data(), circle_y_.data(), circle_squared_radius_.data());
    const Circles circles{circle_x_.data(), circle_y_.data(), circle_squared_radius_.data(), groups};
    kernel_->find_circles(circles, now, cells_.data(), static_cast<int>(cells_.size()), inside_.data());

    const unsigned words = words_for(groups);
    unsigned count = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i)
        for (unsigned word = 0; word < words; ++word)
            for (Word bits = inside_[i * words + word] & unmasked_[i * words + word]; bits != 0;
                 bits &= bits - 1) {
                const unsigned link = word * word_size + std::countr_zero(bits), lane = link % group_size;
                const OutlineGroup &outline = layout_->outline[link / group_size];
                set_pair(count++, cells_[i], outline.a[lane], outline.b[lane]);
            }
    listed_ = count;
    for (; count % group_size != 0; ++count)
        set_pair(count, pairs_[0].cell[0], pairs_[0].a[0], pairs_[0].b[0]);
}

void Contact::set_pair(unsigned pair, Place cell, Place a, Place b) {
    PairGroup &group = pairs_[pair / group_size];
    const unsigned lane = pair % group_size;
    group.cell[lane] = cell, group.a[lane] = a, group.b[lane] = b;
}

Touch Contact::touch(const Record *now, const PairGroup &group, unsigned lane) const {
    const int cell = node_at(group.cell[lane]), a = node_at(group.a[lane]), b = node_at(group.b[lane]);
    const auto at = [&](int node) { return Vec2f{now[node].x, now[node].y}; };
    return {cell, a, b, contact_forces(at(cell), at(a), at(b), stiffness_, reach_)};
}

void Contact::measure(const Record *now) {
    const auto groups = static_cast<int>((listed_ + group_size - 1) / group_size);
    const float least = kernel_->measure_pairs(pairs_.data(), groups, now, reach_ * reach_, near_.data());
    touches_.clear();
    if (least < reach_ * reach_)
        for (int group = 0; group < groups; ++group)
            for (unsigned bits = near_[group]; bits != 0; bits &= bits - 1) {
                const unsigned lane = std::countr_zero(bits), pair = group * group_size + lane;
                if (pair >= listed_) break;
                touches_.push_back(touch(now, pairs_[group], lane));
            }
    watch_.measured(std::sqrt(least), reach_);
}

} // namespace planula::native
