// SPDX-License-Identifier: MIT
#include "record/kept_state.h"

#include "base/error.h"
#include "base/state.h"
#include "base/text.h"
#include "storage/input.h"
#include "storage/output.h"
#include "storage/packed.h"
#include "storage/sealed.h"
#include "storage/system.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <limits>

namespace planula {

namespace {

constexpr const char *newest = "checkpoint", *previous = "checkpoint.previous", *states = "states";
constexpr std::string_view ending = ".state";
constexpr std::size_t digits = 6;

std::string encoded(const KeptState &kept) {
    StateWriter writer;
    writer.group("run").text(kept.identity).integer(kept.generation);
    writer.text(kept.link).integer(kept.archive).real(kept.best_fitness);
    writer.group("tables").integer(static_cast<std::int64_t>(kept.tables.size()));
    for (const auto &[table, mark] : kept.tables) writer.text(table).integer(mark.length).text(mark.sha256);
    writer.group("parts").text(kept.state).text(kept.memory);
    return writer.bytes();
}

KeptState decoded(std::string_view bytes) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    StateReader reader(bytes);
    KeptState kept;
    reader.group("run");
    kept.identity = reader.text();
    kept.generation = static_cast<int>(reader.integer(0, std::numeric_limits<int>::max()));
    kept.link = reader.text();
    kept.archive = reader.integer(0, most);
    kept.best_fitness = reader.finite();
    reader.group("tables");
    constexpr std::size_t least_bytes = 24;
    for (std::size_t left = reader.count(least_bytes); left > 0; --left) {
        auto &[table, mark] = kept.tables.emplace_back();
        table = reader.text();
        mark.length = reader.integer(0, most);
        mark.sha256 = reader.text();
    }
    reader.group("parts");
    for (std::string *part : {&kept.state, &kept.memory}) *part = reader.text();
    reader.done();
    return kept;
}

/// The content of a sealed file; nothing if it is damaged.
std::optional<std::string> whole_content(const std::filesystem::path &path) {
    std::string bytes;
    try {
        bytes = read_file(path);
    } catch (const InputError &) {
        // Bytes that no reader accepts are as damaged as others.
        if (!std::filesystem::exists(path)) throw;
        return std::nullopt;
    }
    if (const auto content = unseal(bytes)) return std::string(*content);
    return std::nullopt;
}

std::string sealed(const KeptState &kept) { return seal(pack(encoded(kept))); }

} // namespace

const JournalMark &KeptState::mark_of(std::string_view table) const {
    for (const auto &[name, mark] : tables)
        if (name == table) return mark;
    throw InputError("it has no mark of " + std::string(table));
}

std::filesystem::path state_path(const std::filesystem::path &folder, int generation) {
    std::string number = to_text(generation);
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return folder / states / number.append(ending);
}

std::optional<KeptState> read_state(const std::filesystem::path &path) {
    const auto content = whole_content(path);
    if (!content) return std::nullopt;
    try {
        return decoded(unpack(*content));
    } catch (const InputError &error) {
        throw InputError(path.string() + ": " + error.what());
    }
}

std::vector<int> kept_generations(const std::filesystem::path &folder) {
    std::vector<int> generations;
    if (!std::filesystem::is_directory(folder / states)) return generations;
    for (const std::filesystem::path &entry : entries_of(folder / states)) {
        const auto number = parse_int(entry.stem().string());
        if (number && *number >= 0 && *number <= std::numeric_limits<int>::max() &&
            entry == state_path(folder, static_cast<int>(*number)))
            generations.push_back(static_cast<int>(*number));
    }
    std::sort(generations.begin(), generations.end());
    return generations;
}

std::string keep_state(const std::filesystem::path &folder, const KeptState &kept) {
    make_folder(folder / states);
    return write_file(state_path(folder, kept.generation), sealed(kept));
}

void remove_unfinished_states(const std::filesystem::path &folder) {
    if (!std::filesystem::is_directory(folder / states)) return;
    for (const std::filesystem::path &entry : entries_of(folder / states))
        if (entry.extension() == ".tmp") remove_file(entry);
}

void write_checkpoint(const std::filesystem::path &folder, const KeptState &kept) {
    Output output(folder / newest);
    output.write(sealed(kept));

    // From here until the end, the one before stands under its other name.
    if (std::rename((folder / newest).c_str(), (folder / previous).c_str()) != 0 && errno != ENOENT)
        fail<IoError>("keep", folder / newest, errno);
    output.commit();
}

std::vector<std::filesystem::path> checkpoints(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> found;
    for (const char *name : {newest, previous})
        if (std::filesystem::exists(folder / name)) found.push_back(folder / name);
    return found;
}

void remove_checkpoints(const std::filesystem::path &folder) {
    for (const char *name : {newest, previous, "checkpoint.tmp"}) remove_file(folder / name);
}

} // namespace planula
