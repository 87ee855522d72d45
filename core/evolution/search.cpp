// SPDX-License-Identifier: MIT
#include "evolution/search.h"

#include "base/error.h"
#include "base/text.h"
#include "evolution/fitness_search.h"
#include "evolution/novelty_search.h"

#include <array>

namespace planula {

std::span<const std::string_view> search_names() {
    static constexpr std::array<std::string_view, 2> names{"neat", "novelty"};
    return names;
}

std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters) {
    if (name == "neat") return std::make_unique<FitnessSearch>(parameters);
    if (name == "novelty") return std::make_unique<NoveltySearch>(parameters);
    std::string known;
    for (const auto &each : search_names()) known += (known.empty() ? "'" : ", '") + std::string(each) + "'";
    const std::string nearest = nearest_name(name, search_names());
    throw InputError("no search is called '" + std::string(name) + "'" +
                     (nearest.empty() ? "; there are " + known : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
