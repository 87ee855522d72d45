// SPDX-License-Identifier: MIT
#include "tables/archive_table.h"

#include "base/text.h"
#include "storage/journal.h"
#include "tables/csv.h"

namespace planula {

namespace {

constexpr std::size_t first_behaviour = 4;

/// The columns for descriptors of this length.
std::vector<std::string> header_for(std::size_t length) {
    const auto standard = header_of<ArchiveRow>();
    if (standard.size() == first_behaviour + length) return {standard.begin(), standard.end()};
    std::vector<std::string> header(standard.begin(), standard.begin() + first_behaviour);
    std::string first(header_of<ArchiveDescriptorRow>().front());
    first.pop_back();
    for (std::size_t i = 1; i <= length; ++i) header.push_back(first + to_text(static_cast<std::int64_t>(i)));
    return header;
}

std::vector<ArchiveEntry> read_entries(const std::filesystem::path &path, std::size_t most) {
    CsvReader reader(path);
    const std::size_t columns = reader.header().size();
    if (columns < first_behaviour || reader.header() != header_for(columns - first_behaviour))
        reader.refuse(
            "not the header of an archive: generation, genome, fitness, novelty_or_gain and a descriptor");

    std::vector<ArchiveEntry> archive;
    while (archive.size() < most && reader.next()) {
        ArchiveEntry &entry = archive.emplace_back();
        reader.parse(0, entry.generation);
        reader.parse(1, entry.genome);
        reader.parse(2, entry.fitness);
        reader.parse(3, entry.novelty);
        entry.behaviour.resize(columns - first_behaviour);
        for (std::size_t i = first_behaviour; i < columns; ++i)
            reader.parse(i, entry.behaviour[i - first_behaviour]);
    }
    return archive;
}

} // namespace

std::string archive_header(std::size_t length) { return to_line(header_for(length)); }

std::string archive_line(const ArchiveEntry &entry) {
    std::vector<std::string> fields{to_field(entry.generation), to_field(entry.genome),
                                    to_field(entry.fitness), to_field(entry.novelty)};
    for (const double value : entry.behaviour) fields.push_back(to_field(value));
    return to_line(fields);
}

std::vector<ArchiveEntry> read_archive(const std::filesystem::path &folder, std::size_t most) {
    if (most == 0) return {};
    return read_entries(folder / ArchiveRow::file_name, most);
}

std::vector<ArchiveEntry> read_archive_journal(const std::filesystem::path &folder, std::size_t most) {
    if (most == 0) return {};
    return read_entries(journal_path(folder / ArchiveRow::file_name), most);
}

} // namespace planula
