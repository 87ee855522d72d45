// SPDX-License-Identifier: MIT
// What a benchmark of neuroevolution is: networks of one shape, and a judgement of what a genome's network does.
// The searches of core/evolution see it through solve.h as they see animats: as genomes and evaluations.
#pragma once

#include "evolution/population.h"
#include "network/network.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace planula::benchmark {

/// Turns inputs into outputs once per step of a task; may remember.
using Policy = std::function<void(std::span<const double> inputs, std::span<double> outputs)>;

struct Attempt {
    double fitness = 0; // at least 0
    std::vector<double> behaviour;
    bool solved = false;
};

struct Task {
    std::string_view name;
    NetworkShape shape; // inputs include the bias
    std::function<Attempt(const Genome &)> attempt;
    /// Where solving is shown by a costly test: taken by the fittest of each generation. Empty elsewhere.
    std::function<bool(const Genome &)> examine = {};
};

/// The network of a genome as a policy. A recurrent one takes one synchronous step per call and remembers its
/// activations; a feed-forward one is propagated to its depth.
class Controller {
  public:
    Controller(const Genome &genome, bool recurrent)
        : network_(express(genome, Parameters().network.propagation_limit)), activations_(network_.nodes, 1),
          recurrent_(recurrent) {}

    void operator()(std::span<const double> inputs, std::span<double> outputs) {
        for (std::size_t i = 0; i < inputs.size(); ++i) activations_.at(0, static_cast<int>(i)) = inputs[i];
        recurrent_ ? step(network_, activations_) : evaluate(network_, activations_);
        for (std::size_t i = 0; i < outputs.size(); ++i)
            outputs[i] = activations_.at(0, network_.inputs + static_cast<int>(i));
    }

  private:
    Network network_;
    Activations activations_;
    bool recurrent_;
};

} // namespace planula::benchmark
