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

std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters) {
    std::string known;
    for (const SearchRow &row : search_rows()) {
        if (row.name == name) return row.make(parameters);
        known += (known.empty() ? "'" : ", '") + std::string(row.name) + "'";
    }
    const std::string nearest = nearest_name(name, search_names());
    throw InputError("no search is called '" + std::string(name) + "'" +
                     (nearest.empty() ? "; there are " + known : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
