// SPDX-License-Identifier: MIT
#include "tables/archive_table.h"

#include "base/text.h"
#include "storage/journal.h"
#include "tables/csv.h"

#include <algorithm>
#include <cstddef>
#include <utility>

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

/// Whether this is the header of an archive with so many objectives.
bool is_header(const std::vector<std::string> &header, std::size_t objectives) {
    if (header.size() < first_behaviour + objectives) return false;
    const std::size_t length = header.size() - first_behaviour - objectives;
    const std::vector<std::string> standard = header_for(length);
    const auto end = header.end() - static_cast<std::ptrdiff_t>(objectives);
    if (std::equal(header.begin(), end, standard.begin(), standard.end())) return true;
    // A descriptor with names, which begin with letters.
    const auto named = header.begin() + first_behaviour;
    return std::equal(header.begin(), named, standard.begin()) &&
           std::all_of(named, end, [](const auto &title) {
               return title.starts_with(behaviour_prefix) && title.size() > behaviour_prefix.size() &&
                      !(title[behaviour_prefix.size()] >= '0' && title[behaviour_prefix.size()] <= '9');
           });
}

std::vector<ArchiveEntry> read_entries(const std::filesystem::path &path, std::size_t most) {
    CsvReader reader(path);
    const std::size_t columns = reader.header().size();
    const auto objectives = static_cast<std::size_t>(
        std::count_if(reader.header().begin(), reader.header().end(),
                      [](const std::string &title) { return title.starts_with(objective_prefix); }));
    if (!is_header(reader.header(), objectives))
        reader.refuse(
            "not the header of an archive: generation, genome, fitness, novelty_or_gain and a descriptor");

    std::vector<ArchiveEntry> archive;
    while (archive.size() < most && reader.next()) {
        ArchiveEntry &entry = archive.emplace_back();
        reader.parse(0, entry.generation);
        reader.parse(1, entry.genome);
        reader.parse(2, entry.fitness);
        reader.parse(3, entry.novelty);
        for (std::size_t i = first_behaviour; i < columns; ++i)
            reader.parse(i, i + objectives < columns ? entry.behaviour.emplace_back()
                                                     : entry.objectives.emplace_back());
    }
    return archive;
}

} // namespace

std::string archive_header(std::size_t length, const Aims &aims) {
    std::vector<std::string> header = header_for(length);
    if (!aims.descriptor.empty()) {
        header.resize(first_behaviour);
        for (const DescriptorNumber &number : aims.descriptor)
            header.push_back(std::string(behaviour_prefix) + number.name);
    }
    for (std::string &title : aims.stated_titles()) header.push_back(std::move(title));
    return to_line(header);
}

std::string archive_line(const ArchiveEntry &entry) {
    std::vector<std::string> fields{to_field(entry.generation), to_field(entry.genome),
                                    to_field(entry.fitness), to_field(entry.novelty)};
    for (const double value : entry.behaviour) fields.push_back(to_field(value));
    for (const double value : entry.objectives) fields.push_back(to_field(value));
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
