// SPDX-License-Identifier: MIT
#include "locomotion/gait.h"

#include "base/keep_only.h"
#include "locomotion/grn.h"
#include "locomotion/oscillator.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace planula {

std::unique_ptr<Gait> make_gait(Actuation actuation, const Network &network, const Body &body,
                                const Tissue &tissue, const Parameters &parameters) {
    if (actuation == Actuation::oscillator)
        return std::make_unique<Oscillators>(read_oscillators(network, tissue, parameters.gait),
                                             parameters.gait);
    return std::make_unique<GrnMuscles>(network, body, tissue, parameters);
}

namespace {

class HeldGait : public Gait {
  public:
    HeldGait(std::unique_ptr<Gait> gait, int from) : gait_(std::move(gait)), from_(from) {}

    bool senses() const override { return held_.empty() && gait_->senses(); }
    void sense(std::span<const Vec2d> places) override { gait_->sense(places); }
    void signals(int t, std::span<double> signal) override {
        if (held_.empty()) gait_->signals(t, signal);
        if (held_.empty() && t >= from_) held_.assign(signal.begin(), signal.end());
        if (!held_.empty()) std::copy(held_.begin(), held_.end(), signal.begin());
    }
    void keep(std::span<const int> cells, std::span<const Link> links) override {
        gait_->keep(cells, links);
        if (!held_.empty()) keep_only(cells, held_);
    }
    const Activations *activations() const override { return gait_->activations(); }
    double activity() const override { return gait_->activity(); }
    bool is_sound() const override { return gait_->is_sound(); }

  private:
    std::unique_ptr<Gait> gait_;
    int from_;
    std::vector<double> held_; // once they are
};

} // namespace

std::unique_ptr<Gait> hold(std::unique_ptr<Gait> gait, int from) {
    return std::make_unique<HeldGait>(std::move(gait), from);
}

} // namespace planula
