// SPDX-License-Identifier: MIT
#include "physics/native/contact.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace planula::native {

namespace {

constexpr float skin = 0.8f;    // so much farther than the law reaches pairs are listed; any gives the same
constexpr float margin = 1e-3f; // far above what rounding does to distances

} // namespace

void Contact::load(const Layout &layout, const Kernel &kernel) {
    layout_ = &layout, kernel_ = &kernel;
    reach_ = static_cast<float>(layout.model.parameters.contact_radius);
    first_node_ = layout.first_outline_node / group_size * group_size;
    end_node_ = static_cast<int>(layout.cell_of.size());
    listed_at_.clear(), searched_at_.clear(), touches_.clear();
    const std::size_t links = layout.outline.size() * group_size;
    circle_x_.resize(links), circle_y_.resize(links), circle_squared_radius_.resize(links);
    inside_.resize(layout.outline.size());
}

std::span<const Touch<float>> Contact::touches(const Record *now) {
    // Without cells, or while no pair can have come into reach.
    if (layout_->model.contact_cells.empty()) return {};
    if (!searched_at_.empty() && motion(searched_at_, now) < clearance_) return {};
    float moved = listed_at_.empty() ? skin : motion(listed_at_, now);
    if (!(moved < skin)) make_list(now), moved = 0;

    squared_.resize(pairs_.size() * group_size);
    const float least =
        kernel_->measure_pairs(pairs_.data(), static_cast<int>(pairs_.size()), now, squared_.data());
    touches_.clear();
    if (least < reach_ * reach_)
        for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell)
            for (int i = first_[cell]; i < first_[cell + 1]; ++i)
                if (squared_[i] < reach_ * reach_)
                    touches_.push_back(touch_of<float>(layout_->model, cell, links_[i], {&now->x, 4}));

    // Pairs that are not listed were farther apart than reach and skin.
    clearance_ = std::min(std::sqrt(least) - reach_, skin - moved) - margin;
    searched_at_.clear();
    if (clearance_ > 0) searched_at_.assign(now, now + end_node_);
    return touches_;
}

void Contact::make_list(const Record *now) {
    listed_at_.assign(now, now + end_node_);
    const int groups = static_cast<int>(layout_->outline.size());
    kernel_->circle_links(layout_->outline.data(), groups, now, reach_ + skin + margin, circle_x_.data(),
                          circle_y_.data(), circle_squared_radius_.data());
    const Circles circles{circle_x_.data(), circle_y_.data(), circle_squared_radius_.data(), groups};

    first_.assign(1, 0), links_.clear(), pairs_.clear();
    const SoftBodyModel &model = layout_->model;
    const int links = static_cast<int>(model.outline.size());
    for (std::size_t cell = 0; cell < model.contact_cells.size(); ++cell) {
        const int node = model.contact_cells[cell];
        kernel_->find_circles(circles, now[node], inside_.data());
        for (int group = 0; group < groups; ++group)
            for (unsigned bits = inside_[group]; bits != 0; bits &= bits - 1) {
                const int link = group * group_size + std::countr_zero(bits);
                if (link < links && !model.is_masked(cell, static_cast<std::size_t>(link)))
                    list_pair(node, link);
            }
        first_.push_back(static_cast<int>(links_.size()));
    }
}

/// The rest of the last group is filled with its first pair.
void Contact::list_pair(int cell, int link) {
    const std::size_t place = links_.size() % group_size;
    links_.push_back(link);
    if (place == 0) pairs_.emplace_back();
    const OutlineLink &l = layout_->model.outline[link];
    PairGroup &group = pairs_.back();
    for (std::size_t i = place; i < (place == 0 ? group_size : place + 1); ++i)
        group.cell[i] = place_of(cell), group.a[i] = place_of(l.a), group.b[i] = place_of(l.b);
}

float Contact::motion(const std::vector<Record> &then, const Record *now) const {
    return std::sqrt(kernel_->squared_motion(then.data(), now, first_node_, end_node_));
}

} // namespace planula::native
