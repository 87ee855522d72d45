// SPDX-License-Identifier: MIT
#include "experiment/deciding.h"

#include "experiment/world_numbers.h"

#include <algorithm>
#include <array>

namespace planula {

namespace {

// What the searches of core/evolution do not read; a search that is not named here counts as reading all.
bool has_search(const Spec &spec, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), spec.search) != names.end();
}
// Generation 0 may be evolved by novelty search (experiment/start.h).
bool has_no_species(const Spec &spec) {
    return !spec.start && has_search(spec, {"nsga2", "nslc", "map-elites"});
}
bool ignores_ages(const Spec &spec) {
    const bool is_equal = spec.parameters.novelty.novelty_species == NoveltySpecies::equal;
    return has_no_species(spec) || (is_equal && has_search(spec, {"novelty", "nsga2", "nslc", "map-elites"}));
}
bool shares_by_novelty(const Spec &spec) {
    return spec.start || !has_search(spec, {"neat", "nsga2", "nslc", "map-elites"});
}
bool measures_no_novelty(const Spec &spec) { return !spec.start && has_search(spec, {"neat", "map-elites"}); }
bool keeps_no_map(const Spec &spec) { return has_search(spec, {"neat", "novelty", "nsga2", "nslc"}); }

std::string of_search(const Spec &spec, const std::string &what) {
    return "its search is '" + spec.search + "', which " + what;
}

constexpr auto of_gaits_by_networks =
    std::to_array<std::string_view>({"update_interval", "gait_time", "gait_place"});
constexpr auto of_species =
    std::to_array<std::string_view>({"compatibility_floor", "compatibility_step", "species_low",
                                     "species_high", "fitness_floor", "survival_rate", "interspecies_rate"});
constexpr auto of_ages = std::to_array<std::string_view>(
    {"young_age", "young_boost", "old_age", "old_penalty", "stagnation_limit", "stagnation_penalty"});

template <std::size_t count>
bool is_one_of(std::string_view name, const std::array<std::string_view, count> &names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string why_search_does_not_read(const ParameterRow &row, const Spec &spec) {
    if (is_one_of(row.name, of_species) && has_no_species(spec)) return of_search(spec, "has no species");
    if (is_one_of(row.name, of_ages) && ignores_ages(spec))
        return of_search(spec, "does not use the age of species");
    if (row.name == "novelty_species" && !shares_by_novelty(spec))
        return of_search(spec, "does not share offspring by novelty");
    if (row.section == "Novelty search" && measures_no_novelty(spec))
        return of_search(spec, "measures no novelty");
    if (row.section == "MAP-Elites" && keeps_no_map(spec)) return of_search(spec, "keeps no map");
    if (row.name == "niche_width" && !spec.aims.descriptor.empty() && spec.aims.descriptor.front().cells > 0)
        return "its descriptor states the ranges of its map";
    return "";
}

} // namespace

bool decides_lives(const ParameterRow &row) {
    return row.section != "Statistics" && row.name != "seeds" && row.name != "generations";
}

std::string why_not_shown(std::string_view name) {
    for (const ParameterRow &row : parameter_rows()) {
        if (row.name != name || decides_lives(row)) continue;
        return row.section == "Statistics" ? "statistics alone read it"
                                           : "how much is run must not change how a life is judged";
    }
    return "";
}

std::string why_unread(const ParameterRow &row, const Spec &spec) {
    if (is_of_worlds(row.name) && !makes_world(row.name, spec))
        return "its environment takes no number from this parameter";
    if (row.section == "Judgement") return "its functions do not read it";
    const bool settles =
        spec.environment.gravity > 0 ||
        std::any_of(spec.phases.begin(), spec.phases.end(), [](const Phase &p) { return p.settles; });
    if (row.section == "Settling" && !settles)
        return "its environment has no gravity, without which no body settles";
    if (row.name == "period_shortest" && spec.actuation != Actuation::oscillator)
        return "its actuation has no oscillators";
    if (is_one_of(row.name, of_gaits_by_networks) && spec.actuation != Actuation::grn)
        return "its actuation asks no network while the body moves";
    return why_search_does_not_read(row, spec);
}

bool reads_behaviour(const Spec &spec) { return !has_search(spec, {"neat"}); }

} // namespace planula
