// SPDX-License-Identifier: MIT
#include "evolution/novelty_search.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"
#include "evolution/reproduce.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

/// Behaviours in rows of equal length, one after the other.
struct Cloud {
    std::size_t length;
    std::vector<double> rows;

    std::size_t size() const { return rows.size() / length; }
    void add(const std::vector<double> &behaviour) {
        rows.insert(rows.end(), behaviour.begin(), behaviour.end());
    }
};

double squared_distance(const Cloud &cloud, std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t i = 0; i < cloud.length; ++i) {
        const double difference = cloud.rows[a * cloud.length + i] - cloud.rows[b * cloud.length + i];
        sum += difference * difference;
    }
    return sum;
}

/// The k smallest values offered, in ascending order.
class Nearest {
  public:
    explicit Nearest(int k) : k_(k) {}

    void offer(double value) {
        if (values_.size() == k_ && !(value < values_.back())) return;
        if (values_.size() == k_) values_.pop_back();
        values_.insert(std::upper_bound(values_.begin(), values_.end(), value), value);
    }
    const std::vector<double> &values() const { return values_; }

  private:
    std::size_t k_;
    std::vector<double> values_;
};

/// Eq. (7), over as many neighbours as there are; 0 without any. The distances are summed in ascending order,
/// so that the order of the cloud reaches no result.
double novelty_of(const Cloud &cloud, std::size_t self, int k) {
    Nearest nearest(k);
    for (std::size_t other = 0; other < cloud.size(); ++other)
        if (other != self) nearest.offer(squared_distance(cloud, self, other));
    if (nearest.values().empty()) return 0;
    double sum = 0;
    for (const double squared : nearest.values()) sum += std::sqrt(squared);
    return sum / static_cast<double>(nearest.values().size());
}

} // namespace

std::vector<double> NoveltySearch::score(const Population &population,
                                         std::span<const Evaluation> evaluations) {
    CHECK(evaluations.size() == population.genomes.size(), evaluations.size(), population.genomes.size());
    check_behaviours(evaluations);
    std::vector<double> scores = novelties(evaluations);
    extend_archive(population, evaluations, scores);
    for (std::size_t slot = 0; slot < scores.size(); ++slot) scores[slot] *= evaluations[slot].penalty;
    return scores;
}

Population NoveltySearch::next(const Population &population, std::span<const double> scores,
                               const NetworkShape &shape, std::uint64_t seed) const {
    return reproduce(population, scores, false, shape.recurrent, parameters_, seed);
}

void NoveltySearch::check_behaviours(std::span<const Evaluation> evaluations) {
    for (const auto &evaluation : evaluations) {
        if (!evaluation.valid()) continue;
        const auto &behaviour = evaluation.behaviour;
        if (behaviour.empty())
            throw InputError("novelty search needs a behaviour, and a valid individual has none");
        if (length_ == 0) length_ = behaviour.size();
        if (behaviour.size() != length_)
            throw InputError("all behaviours of a run have one length, but " +
                             to_text(std::int64_t(length_)) + " and " +
                             to_text(std::int64_t(behaviour.size())) + " numbers were given");
        for (const double value : behaviour)
            if (!std::isfinite(value))
                throw InputError("a behaviour must be finite, but " + to_text(value) + " was given");
    }
}

std::vector<double> NoveltySearch::novelties(std::span<const Evaluation> evaluations) const {
    // The valid individuals in slot order, then the archive as it is.
    Cloud cloud{length_, {}};
    for (const auto &evaluation : evaluations)
        if (evaluation.valid()) cloud.add(evaluation.behaviour);
    for (const auto &entry : archive_) cloud.add(entry.behaviour);

    std::vector<double> novelty;
    std::size_t self = 0;
    for (const auto &evaluation : evaluations)
        novelty.push_back(evaluation.valid() ? novelty_of(cloud, self++, parameters_.novelty_neighbours) : 0);
    return novelty;
}

void NoveltySearch::extend_archive(const Population &population, std::span<const Evaluation> evaluations,
                                   std::span<const double> novelty) {
    // A walk in slot order; the threshold moves on the way.
    bool added_any = false;
    for (std::size_t slot = 0; slot < evaluations.size(); ++slot) {
        if (!evaluations[slot].valid()) continue;
        const bool added = novelty[slot] > threshold_;
        run_ = added ? run_ + 1 : 0;
        if (!added) continue;
        added_any = true;
        archive_.push_back(
            {population.generation, population.genomes[slot].id, evaluations[slot].behaviour, novelty[slot]});
        if (run_ > parameters_.archive_run) threshold_ *= parameters_.archive_raise;
    }

    // After a long time without additions the threshold falls, and the count starts again.
    quiet_ = added_any ? 0 : quiet_ + 1;
    if (quiet_ < parameters_.archive_patience) return;
    threshold_ = std::max(parameters_.archive_floor, threshold_ * parameters_.archive_lower);
    quiet_ = 0;
}

void NoveltySearch::save(StateWriter &writer) const {
    writer.group("novelty search").real(threshold_).integer(run_).integer(quiet_);
    writer.integer(static_cast<std::int64_t>(length_)).integer(static_cast<std::int64_t>(archive_.size()));
    for (const ArchiveEntry &entry : archive_) {
        writer.integer(entry.generation).integer(entry.genome).real(entry.novelty);
        for (const double value : entry.behaviour) writer.real(value);
    }
}

void NoveltySearch::load(StateReader &reader) {
    constexpr int largest = std::numeric_limits<int>::max();
    reader.group("novelty search");
    threshold_ = reader.finite();
    if (threshold_ < 0) reader.refuse("a threshold is below 0");
    run_ = static_cast<int>(reader.integer(0, largest));
    quiet_ = static_cast<int>(reader.integer(0, largest));
    length_ = static_cast<std::size_t>(reader.integer(0, largest));
    archive_.resize(reader.count((3 + length_) * 8));
    for (ArchiveEntry &entry : archive_) {
        entry.generation = static_cast<int>(reader.integer(0, largest));
        entry.genome = reader.integer(0, std::numeric_limits<std::int64_t>::max());
        entry.novelty = reader.finite();
        entry.behaviour.resize(length_);
        for (double &value : entry.behaviour) value = reader.finite();
    }
    if (length_ == 0 && !archive_.empty()) reader.refuse("an archive has entries without behaviour");
}

} // namespace planula
