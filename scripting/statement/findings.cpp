// SPDX-License-Identifier: MIT
#include "statement/findings.h"

#include "base/text.h"

#include <algorithm>

namespace planula {

namespace {

constexpr std::size_t most_named = 6; // settings in a message

} // namespace

void Findings::add(const CheckFinding &finding) {
    const auto known = std::find_if(all_.begin(), all_.end(), [&](const CheckFinding &each) {
        return each.is_error == finding.is_error && each.place == finding.place && each.text == finding.text;
    });
    if (known == all_.end())
        all_.push_back(finding);
    else
        known->settings.insert(known->settings.end(), finding.settings.begin(), finding.settings.end());
}

bool Findings::has_errors() const {
    return std::any_of(all_.begin(), all_.end(), [](const CheckFinding &each) { return each.is_error; });
}

std::string line_of(const CheckFinding &finding, std::size_t count) {
    const std::string line = finding.place + ": " + finding.text;
    const std::size_t concerned = finding.settings.size();
    if (concerned == 0 || concerned == count) return line;
    const std::size_t named = std::min(concerned, most_named);
    const std::vector<std::string> names(finding.settings.begin(),
                                         finding.settings.begin() + static_cast<std::ptrdiff_t>(named));
    const std::string more =
        concerned > named ? " and " + to_text(static_cast<std::int64_t>(concerned - named)) + " more" : "";
    return line + (concerned == 1 ? " (setting " : " (settings ") + list_of(names) + more + ")";
}

} // namespace planula
