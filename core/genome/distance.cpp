// SPDX-License-Identifier: MIT
#include "genome/distance.h"

#include "genome/align.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace planula {

namespace {

/// What two genomes have in common.
struct Common {
    int links = 0;
    double difference = 0; // Σ |Δw|
};

double delta(int excess_links, int disjoint_links, const Common &common, const NeatParameters &parameters) {
    const double mean_difference = common.links > 0 ? common.difference / common.links : 0;
    return parameters.excess_coefficient * excess_links + parameters.disjoint_coefficient * disjoint_links +
           parameters.weight_coefficient * mean_difference;
}

/// How many links of a genome are newer than all of another.
int newer_links(const Genome &genome, const Genome &other) {
    if (other.links.empty()) return static_cast<int>(genome.links.size());
    const auto is_newer = [&](const LinkGene &link) {
        return link.innovation > other.links.back().innovation;
    };
    return static_cast<int>(std::find_if_not(genome.links.rbegin(), genome.links.rend(), is_newer) -
                            genome.links.rbegin());
}

/// The links of genomes by innovation.
class CommonLinks {
  public:
    /// Compares the next genome with those before, and adds it to them.
    void add(const Genome &genome, std::vector<Common> &with_earlier) {
        with_earlier.assign(static_cast<std::size_t>(genomes_), {});
        for (const LinkGene &link : genome.links) {
            auto &bearers = bearers_[link.innovation];
            for (const auto &[earlier, weight] : bearers) {
                ++with_earlier[earlier].links;
                with_earlier[earlier].difference += std::abs(weight - link.weight);
            }
            bearers.push_back({genomes_, link.weight});
        }
        ++genomes_;
    }

  private:
    struct Bearer {
        int genome;
        double weight;
    };
    int genomes_ = 0;
    std::unordered_map<int, std::vector<Bearer>> bearers_; // never walked through
};

} // namespace

double distance(const Genome &a, const Genome &b, const NeatParameters &parameters) {
    int excess_links = 0, disjoint_links = 0;
    Common common;
    align(
        a, b,
        [&](const LinkGene &of_a, const LinkGene &of_b) {
            ++common.links;
            common.difference += std::abs(of_a.weight - of_b.weight);
        },
        [&](const LinkGene &, Side, bool excess) { ++(excess ? excess_links : disjoint_links); });
    return delta(excess_links, disjoint_links, common, parameters);
}

std::vector<double> distance_sums(std::span<const Genome *const> genomes, const NeatParameters &parameters) {
    std::vector<double> sums(genomes.size());
    CommonLinks links;
    std::vector<Common> common;
    for (std::size_t a = 0; a < genomes.size(); ++a) {
        links.add(*genomes[a], common);
        for (std::size_t b = 0; b < a; ++b) {
            const std::size_t both = genomes[a]->links.size() + genomes[b]->links.size();
            const int excess = newer_links(*genomes[a], *genomes[b]) + newer_links(*genomes[b], *genomes[a]);
            const int disjoint = static_cast<int>(both) - 2 * common[b].links - excess;
            const double apart = delta(excess, disjoint, common[b], parameters);
            sums[a] += apart;
            sums[b] += apart;
        }
    }
    return sums;
}

bool is_clone(const Genome &genome, std::span<const Genome> others, const NeatParameters &parameters) {
    return std::any_of(others.begin(), others.end(), [&](const Genome &other) {
        return other.links.size() == genome.links.size() &&
               distance(genome, other, parameters) < parameters.clone_distance;
    });
}

} // namespace planula
