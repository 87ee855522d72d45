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
    end_node_ = layout.groups * group_size;
    listed_at_.clear(), searched_at_.clear(), touches_.clear();
    const std::size_t links = layout.outline.size() * group_size;
    circle_x_.resize(links), circle_y_.resize(links), circle_squared_radius_.resize(links);
    inside_.resize(layout.outline.size());
    find_unmasked();
}

std::span<const Touch<float>> Contact::touches(const Record *now) {
    // Without cells, or while no pair can have come into reach.
    if (layout_->model.contact_cells.empty()) return {};
    if (!searched_at_.empty() && motion(searched_at_, now) < clearance_) return {};
    float moved = listed_at_.empty() ? skin : motion(listed_at_, now);
    if (!(moved < skin)) make_list(now), moved = 0;

    near_.resize(pairs_.size());
    const int groups = static_cast<int>(pairs_.size());
    const float least = kernel_->measure_pairs(pairs_.data(), groups, now, reach_ * reach_, near_.data());
    touches_.clear();
    if (least < reach_ * reach_)
        for (std::size_t group = 0; group < near_.size(); ++group)
            for (unsigned bits = near_[group]; bits != 0; bits &= bits - 1) {
                const std::size_t pair = group * group_size + std::countr_zero(bits);
                if (pair >= links_.size()) break;
                touches_.push_back(touch_of<float>(layout_->model, cells_[pair], links_[pair], {&now->x, 4}));
            }

    // Pairs that are not listed were farther apart than reach and skin.
    clearance_ = std::min(std::sqrt(least) - reach_, skin - moved) - margin;
    searched_at_.clear();
    if (clearance_ > 0) searched_at_.assign(now, now + end_node_);
    return touches_;
}

void Contact::find_unmasked() {
    const SoftBodyModel &model = layout_->model;
    unmasked_.assign(model.contact_cells.size() * layout_->outline.size(), 0);
    for (std::size_t cell = 0; cell < model.contact_cells.size(); ++cell)
        for (std::size_t link = 0; link < model.outline.size(); ++link) {
            const int bit = model.is_masked(cell, link) ? 0 : 1 << link % group_size;
            unmasked_[cell * layout_->outline.size() + link / group_size] |= static_cast<unsigned char>(bit);
        }
}

void Contact::make_list(const Record *now) {
    listed_at_.assign(now, now + end_node_);
    const int groups = static_cast<int>(layout_->outline.size());
    kernel_->circle_links(layout_->outline.data(), groups, now, reach_ + skin + margin, circle_x_.data(),
                          circle_y_.data(), circle_squared_radius_.data());
    const Circles circles{circle_x_.data(), circle_y_.data(), circle_squared_radius_.data(), groups};

    cells_.clear(), links_.clear();
    const SoftBodyModel &model = layout_->model;
    for (std::size_t cell = 0; cell < model.contact_cells.size(); ++cell) {
        const int node = model.contact_cells[cell];
        kernel_->find_circles(circles, now[node], inside_.data());
        const unsigned char *unmasked = &unmasked_[cell * inside_.size()];
        for (int group = 0; group < groups; ++group)
            for (unsigned bits = inside_[group] & unmasked[group]; bits != 0; bits &= bits - 1)
                cells_.push_back(node), links_.push_back(group * group_size + std::countr_zero(bits));
    }
    group_pairs();
}

void Contact::group_pairs() {
    pairs_.resize((links_.size() + group_size - 1) / group_size);
    for (std::size_t place = 0; place < pairs_.size() * group_size; ++place) {
        const std::size_t pair = place < links_.size() ? place : 0, lane = place % group_size;
        const OutlineLink &link = layout_->model.outline[links_[pair]];
        PairGroup &group = pairs_[place / group_size];
        group.cell[lane] = place_of(cells_[pair]);
        group.a[lane] = place_of(link.a), group.b[lane] = place_of(link.b);
    }
}

float Contact::motion(const std::vector<Record> &then, const Record *now) const {
    return std::sqrt(kernel_->squared_motion(then.data(), now, first_node_, end_node_));
}

} // namespace planula::native
