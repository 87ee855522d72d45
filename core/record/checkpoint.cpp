// SPDX-License-Identifier: MIT
#include "record/checkpoint.h"

#include "base/error.h"
#include "base/state.h"
#include "record/input.h"
#include "record/output.h"
#include "record/sealed.h"
#include "record/system.h"

#include <cerrno>
#include <cstdio>
#include <limits>

namespace planula {

namespace {

constexpr const char *newest = "checkpoint", *previous = "checkpoint.previous";

std::string encoded(const Checkpoint &checkpoint) {
    StateWriter writer;
    writer.group("run").text(checkpoint.identity);
    writer.integer(checkpoint.generation).integer(checkpoint.generations);
    writer.group("tables").integer(static_cast<std::int64_t>(checkpoint.tables.size()));
    for (const auto &[table, mark] : checkpoint.tables)
        writer.text(table).integer(mark.length).text(mark.sha256);
    writer.group("parts").text(checkpoint.state).text(checkpoint.crown).text(checkpoint.memory);
    return writer.bytes();
}

Checkpoint decoded(std::string_view bytes) {
    constexpr int most = std::numeric_limits<int>::max();
    StateReader reader(bytes);
    Checkpoint checkpoint;
    reader.group("run");
    checkpoint.identity = reader.text();
    checkpoint.generation = static_cast<int>(reader.integer(0, most));
    checkpoint.generations = static_cast<int>(reader.integer(1, most));
    reader.group("tables");
    constexpr std::size_t least_bytes = 24;
    for (std::size_t left = reader.count(least_bytes); left > 0; --left) {
        auto &[table, mark] = checkpoint.tables.emplace_back();
        table = reader.text();
        mark.length = reader.integer(0, std::numeric_limits<std::int64_t>::max());
        mark.sha256 = reader.text();
    }
    reader.group("parts");
    for (std::string *part : {&checkpoint.state, &checkpoint.crown, &checkpoint.memory})
        *part = reader.text();
    reader.done();
    return checkpoint;
}

/// The content of a sealed file; nothing if it is damaged.
std::optional<std::string> whole_content(const std::filesystem::path &path) {
    try {
        const std::string bytes = read_file(path);
        if (const auto content = unseal(bytes)) return std::string(*content);
    } catch (const InputError &) {
        // Bytes that no reader accepts are as damaged as others.
    }
    return std::nullopt;
}

} // namespace

const JournalMark &Checkpoint::mark_of(std::string_view table) const {
    for (const auto &[name, mark] : tables)
        if (name == table) return mark;
    throw InputError("it knows nothing of " + std::string(table));
}

FoundCheckpoint find_checkpoint(const std::filesystem::path &folder) {
    FoundCheckpoint found;
    for (const char *name : {newest, previous}) {
        const std::filesystem::path path = folder / name;
        if (!std::filesystem::exists(path)) continue;
        const auto content = whole_content(path);
        if (!content) {
            found.damaged.push_back(path);
            continue;
        }
        try {
            found.checkpoint = decoded(*content);
        } catch (const InputError &error) {
            throw InputError(path.string() + ": " + error.what());
        }
        found.path = path;
        break;
    }
    return found;
}

void write_checkpoint(const std::filesystem::path &folder, const Checkpoint &checkpoint) {
    Output output(folder / newest);
    output.write(seal(encoded(checkpoint)));

    // From here until the end, the one before stands under its other name.
    if (std::rename((folder / newest).c_str(), (folder / previous).c_str()) != 0 && errno != ENOENT)
        fail<IoError>("keep", folder / newest, errno);
    output.commit();
}

void remove_checkpoints(const std::filesystem::path &folder) {
    for (const char *name : {newest, previous, "checkpoint.tmp"}) remove_file(folder / name);
}

} // namespace planula
