// SPDX-License-Identifier: MIT
// Computes the observations of a life while its body moves (evaluation/observations.inl, decision 0026), outside of the
// engine and in double precision: from positions, signals and what the muscles are told, which all engines have alike.
#pragma once

#include "evaluation/observations.h"
#include "locomotion/trial.h"
#include "parameters/parameters.h"
#include "physics/reference/rest_lengths.h"

#include <vector>

namespace planula {

class LifeObserver final : public TrialObserver {
  public:
    /// Of the parameters it reads those of the gait.
    LifeObserver(ObservationSet observed, const Parameters &parameters)
        : observed_(observed), gait_(parameters.gait) {}

    void begin(const SoftBodyModel &model, const Environment &environment, const Engine &engine,
               std::span<const double> signal) override;
    void change(const SoftBodyModel &model, const Environment &environment, const Engine &engine) override;
    void actuate(std::span<const double> extensions, int steps) override;
    void step(int t, const Engine &engine, std::span<const double> signal) override;

    /// Of a trial that ended viable: fills in what is known after locomotion.
    void finish(Observations &observations) const;

  private:
    bool reads(std::initializer_list<Observation> any) const;
    void add_energy(std::span<const Vec2d> positions);
    void add_contact(std::span<const Vec2d> positions);
    void add_signal(int t, std::span<const double> signal);

    const ObservationSet observed_;
    const GaitParameters gait_;
    const SoftBodyModel *model_ = nullptr;
    const Environment *environment_ = nullptr;
    reference::RestLengths rest_lengths_;
    std::vector<double> before_; // rest lengths of the step before
    std::vector<Vec2d> positions_;
    int steps_ = 0;
    double work_ = 0, net_work_ = 0, energy_ = 0, touching_steps_ = 0, touching_cells_ = 0;
    Samples signals_, late_signals_; // every path_interval steps; at the knots of the second half
};

} // namespace planula
