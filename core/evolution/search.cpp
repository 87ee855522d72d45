// SPDX-License-Identifier: MIT
#include "evolution/search.h"

#include "base/error.h"
#include "base/text.h"
#include "evolution/fitness_search.h"
#include "evolution/local_competition_search.h"
#include "evolution/map_elites_search.h"
#include "evolution/novelty_search.h"
#include "evolution/nsga2_search.h"

#include <array>

namespace planula {

std::span<const std::string_view> search_names() {
    static constexpr std::array<std::string_view, 5> names{"neat", "novelty", "nsga2", "nslc", "map-elites"};
    return names;
}

std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters) {
    if (name == "neat") return std::make_unique<FitnessSearch>(parameters);
    if (name == "novelty") return std::make_unique<NoveltySearch>(parameters);
    if (name == "nsga2") return std::make_unique<Nsga2Search>(parameters);
    if (name == "nslc") return std::make_unique<LocalCompetitionSearch>(parameters);
    if (name == "map-elites") return std::make_unique<MapElitesSearch>(parameters);
    std::string known;
    for (const auto &each : search_names()) known += (known.empty() ? "'" : ", '") + std::string(each) + "'";
    const std::string nearest = nearest_name(name, search_names());
    throw InputError("no search is called '" + std::string(name) + "'" +
                     (nearest.empty() ? "; there are " + known : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
