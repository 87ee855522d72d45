// SPDX-License-Identifier: MIT
#include "statement/schema_sensitivity.h"

#include "base/text.h"

#include <cmath>

namespace planula {

namespace {

/// Calls `take` for each entry of a list that may be absent, with its place.
template <class Take>
void each_entry(Reader &reader, const std::string &key, Problems &problems, const Take &take) {
    const Value *list = reader.field(key, Value::Kind::table, false);
    if (!list) return;
    const Place place = reader.at(key);
    const Reader of_list(*list, place, {}, problems, true);
    if (list->list.empty()) problems.add(place, place.words + " is empty");
    for (std::size_t i = 0; i < list->list.size(); ++i)
        take(list->list[i], place.at(static_cast<int>(i + 1), &list->list[i]));
}

} // namespace

SensitivityPlan read_sensitivity(const Value &table, const Place &place, Problems &problems) {
    Reader reader(table, place, keys_of("sensitivity"), problems);
    SensitivityPlan plan;
    if (table.find("sample")) {
        plan.sample = reader.whole("sample");
        if (plan.sample < 1) reader.report("sample", reader.at("sample").words + " must be at least 1");
    }
    if (table.find("factors")) plan.factors.clear();
    each_entry(reader, "factors", problems, [&](const Value &entry, const Place &here) {
        const bool fits = entry.is(Value::Kind::number) && entry.number > 0 && std::isfinite(entry.number);
        if (fits)
            plan.factors.push_back(entry.number);
        else
            problems.add(here, here.words + " must be a number above 0");
    });
    each_entry(reader, "parameters", problems, [&](const Value &entry, const Place &here) {
        if (!entry.is(Value::Kind::text))
            return problems.add(here, here.words + " must be a parameter's name");
        check_at(here, problems, [&] { parameter(Parameters{}, entry.text); });
        plan.parameters.push_back(entry.text);
    });
    return plan;
}

} // namespace planula
