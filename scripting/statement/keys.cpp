// SPDX-License-Identifier: MIT
#include "statement/keys.h"

#include "base/check.h"
#include "base/text.h"
#include "parameters/parameters.h"

#include <algorithm>

namespace planula {

namespace {

#define TABLE(id, path, meaning) constexpr Key id##_keys[] = {
#define KEY(...) Key{__VA_ARGS__},
#define TABLE_END                                                                                            \
    }                                                                                                        \
    ;
#include "statement/keys.inl"

constexpr KeyTable tables[] = {
#define TABLE(id, path, meaning) {path, meaning, id##_keys},
#define KEY(...)
#define TABLE_END
#include "statement/keys.inl"
};

constexpr std::size_t most_places = 3; // that a message names

void add_rows(Keys &keys, std::string_view path) {
    const auto table = std::find_if(std::begin(tables), std::end(tables),
                                    [&](const KeyTable &each) { return each.path == path; });
    CHECK(table != std::end(tables), path);
    for (const Key &key : table->keys)
        if (!keys.find(key.name)) keys.rows.push_back(&key);
}

/// The value as a script states it, if that is short.
std::string text_of(const Value &value) {
    if (value.is(Value::Kind::number)) return to_text(value.number);
    if (value.is(Value::Kind::boolean)) return value.boolean ? "true" : "false";
    constexpr std::size_t longest = 40;
    const bool plain = value.is(Value::Kind::text) && value.text.size() <= longest &&
                       value.text.find_first_of("\"\\\r\n") == std::string::npos;
    return plain ? '"' + value.text + '"' : "…";
}

/// "environment = { drag = { normal = 2 } }" of the path "environment.drag" and the words "normal = 2".
std::string inside(std::string_view path, const std::string &words) {
    if (path.empty()) return words;
    const std::size_t dot = path.find('.');
    const bool is_list = path.substr(0, dot).ends_with("[]");
    const std::string rest = inside(dot == path.npos ? "" : path.substr(dot + 1), words);
    const std::string entry = is_list ? "{ " + rest + " }" : rest;
    return std::string(path.substr(0, dot - (is_list ? 2 : 0))) + " = { " + entry + " }";
}

/// Whether the experiment or a setting has a table of this path.
std::string_view owner_of(std::string_view path) {
    const std::string_view first = path.substr(0, path.find('.'));
    const Keys setting = keys_of("setting");
    if (first == "experiment" || first == "setting") return first;
    return setting.find(first) ? "setting" : "experiment";
}

bool is_parameter(std::string_view name) {
    const auto rows = parameter_rows();
    return std::any_of(rows.begin(), rows.end(), [&](const ParameterRow &row) { return row.name == name; });
}

/// " in the setting: environment = { drag = 2 }"; without the owner if the key's owner is this table itself.
std::string place_of(const KeyTable &table, const std::string &words, const Keys &here) {
    const std::string_view owner = owner_of(table.path);
    const bool both = table.path == "parameters" && here.path == "experiment";
    const bool is_here = here.path == owner || here.path == "single" || both;
    const std::string where = is_here ? "" : owner == "setting" ? " in the setting" : " in the experiment";
    return where + ": " + (table.path == owner ? words : inside(table.path, words));
}

} // namespace

std::span<const KeyTable> key_tables() { return tables; }

const Key *Keys::find(std::string_view name) const {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Key *key) { return key->name == name; });
    return row == rows.end() ? nullptr : *row;
}

std::vector<std::string_view> Keys::names() const {
    std::vector<std::string_view> all;
    for (const Key *key : rows) all.push_back(key->name);
    return all;
}

Keys keys_of(std::string_view path) {
    Keys keys{path};
    if (path != "single") return add_rows(keys, path), keys;
    add_rows(keys, "setting");
    add_rows(keys, "experiment");
    std::erase_if(keys.rows, [](const Key *key) { return key->name == "settings"; });
    return keys;
}

std::string where_it_belongs(std::string_view name, const Value &stated, const Keys &here) {
    const std::string words = std::string(name) + " = " + text_of(stated);
    std::vector<std::string> places;
    for (const KeyTable &table : tables)
        for (const Key &key : table.keys)
            if (key.name == name) places.push_back(place_of(table, words, here));
    if (is_parameter(name)) {
        if (here.path == "parameters") return "";
        places.push_back(place_of({"parameters", "", {}}, words, here));
    }
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i)
        text += (i == 0 ? "write" : ", or") + places[i];
    return text;
}

} // namespace planula
