// SPDX-License-Identifier: MIT
#include "evolution/search.h"

#include "base/error.h"
#include "base/text.h"

namespace planula {

#define SEARCH(name, function, score) std::unique_ptr<Search> function(const Parameters &parameters);
#include "evolution/searches.inl"

std::span<const SearchRow> search_rows() {
#define SEARCH(name, function, score) {name, score, function},
    static constexpr SearchRow rows[] = {
#include "evolution/searches.inl"
    };
    return rows;
}

std::vector<std::string_view> search_names() {
    std::vector<std::string_view> names;
    for (const SearchRow &row : search_rows()) names.push_back(row.name);
    return names;
}

std::string search_scores() {
    std::string text;
    for (const SearchRow &row : search_rows())
        text += (text.empty() ? "" : "; ") + std::string(row.name) + ": " + std::string(row.score);
    return text;
}

namespace {

/// "nsga2 and nslc": the searches that can have these aims.
std::string searches_for(const Aims &aims, const Parameters &parameters) {
    std::string names;
    for (const SearchRow &row : search_rows()) {
        Aims alone;
        alone.objectives.assign(aims.objectives.begin(), aims.objectives.begin() + 1);
        alone.objectives.front().value = Objective::Value::stated;
        if (row.make(parameters)->take(alone))
            names += (names.empty() ? "" : " and ") + std::string(row.name);
    }
    return names;
}

} // namespace

std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters, const Aims &aims) {
    std::string known;
    for (const SearchRow &row : search_rows()) {
        if (row.name == name) {
            auto search = row.make(parameters);
            if (!search->take(aims))
                throw InputError("search '" + std::string(name) + "' reads no objectives, but fitness; " +
                                 searches_for(aims, parameters) + " read them");
            return search;
        }
        known += (known.empty() ? "'" : ", '") + std::string(row.name) + "'";
    }
    const std::string nearest = nearest_name(name, search_names());
    throw InputError("no search is called '" + std::string(name) + "'" +
                     (nearest.empty() ? "; there are " + known : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
