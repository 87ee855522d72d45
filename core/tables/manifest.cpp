// SPDX-License-Identifier: MIT
#include "tables/manifest.h"

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "tables/csv.h"

#include <limits>

namespace planula {

namespace {

constexpr const char *seal_key = "manifest_sha256";

} // namespace

std::string_view version() { return PLANULA_VERSION; }

std::string compiler() {
#if defined(__clang__)
    return "clang " + to_text(__clang_major__) + "." + to_text(__clang_minor__) + "." +
           to_text(__clang_patchlevel__);
#elif defined(__GNUC__)
    return "gcc " + to_text(__GNUC__) + "." + to_text(__GNUC_MINOR__) + "." + to_text(__GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

Manifest::Manifest(const std::filesystem::path &folder) : folder_(folder) {
    TableReader<ManifestRow> reader(folder);
    for (ManifestRow row; reader.next(row);) {
        if (has(row.key)) reader.refuse("the key '" + row.key + "' is there twice");
        rows_.push_back(row);
    }
}

void Manifest::add(std::string key, std::string value) {
    CHECK(!has(key), key);
    rows_.push_back({std::move(key), std::move(value)});
}

void Manifest::add(std::string key, std::int64_t value) { add(std::move(key), to_text(value)); }

void Manifest::write(const std::filesystem::path &folder) const { write_table<ManifestRow>(folder, rows_); }

const std::string *Manifest::find(std::string_view key) const {
    for (const ManifestRow &row : rows_)
        if (row.key == key) return &row.value;
    return nullptr;
}

const std::string &Manifest::text(std::string_view key) const {
    const std::string *value = find(key);
    if (value == nullptr) refuse("no row '" + std::string(key) + "'");
    return *value;
}

std::int64_t Manifest::number(std::string_view key) const {
    const auto value = parse_int(text(key));
    if (!value) refuse("'" + std::string(key) + "' = '" + text(key) + "' is not a whole number");
    return *value;
}

int Manifest::count(std::string_view key) const {
    const std::int64_t value = number(key);
    if (value < 1 || value > std::numeric_limits<int>::max())
        refuse("'" + std::string(key) + "' = " + to_text(value) + " is not a count");
    return static_cast<int>(value);
}

void Manifest::seal() { add(seal_key, hash_of_rows(rows_.size())); }

void Manifest::check_seal() const {
    if (rows_.empty() || rows_.back().key != seal_key || rows_.back().value != hash_of_rows(rows_.size() - 1))
        refuse("it is not as it was written: its last row is not the hash of the others");
}

std::string Manifest::hash_of_rows(std::size_t count) const {
    Hash hash;
    for (std::size_t i = 0; i < count; ++i) hash.text(rows_[i].key).text(rows_[i].value);
    return hash.hex();
}

void Manifest::refuse(const std::string &what) const {
    throw InputError((folder_ / ManifestRow::file_name).string() + ": " + what);
}

} // namespace planula
