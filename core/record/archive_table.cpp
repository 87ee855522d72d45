// SPDX-License-Identifier: MIT
#include "record/archive_table.h"

#include "base/check.h"
#include "base/text.h"
#include "record/csv.h"

namespace planula {

namespace {

constexpr std::size_t first_behaviour = 3;

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

} // namespace

ArchiveWriter::ArchiveWriter(const std::filesystem::path &folder) : output_(folder / ArchiveRow::file_name) {}

void ArchiveWriter::begin(std::size_t length) {
    length_ = length;
    output_.write(to_line(header_for(length)));
}

void ArchiveWriter::write(const ArchiveEntry &entry) {
    if (!length_) begin(entry.behaviour.size());
    CHECK(entry.behaviour.size() == *length_, entry.genome);
    std::vector<std::string> fields{to_field(entry.generation), to_field(entry.genome),
                                    to_field(entry.novelty)};
    for (const double value : entry.behaviour) fields.push_back(to_field(value));
    output_.write(to_line(fields));
}

std::string ArchiveWriter::commit() {
    if (!length_) begin(header_of<ArchiveRow>().size() - first_behaviour);
    return output_.commit();
}

std::vector<ArchiveEntry> read_archive(const std::filesystem::path &folder) {
    CsvReader reader(folder / ArchiveRow::file_name);
    const std::size_t columns = reader.header().size();
    if (columns < first_behaviour || reader.header() != header_for(columns - first_behaviour))
        reader.refuse("not the header of an archive: generation, genome, novelty and a descriptor");

    std::vector<ArchiveEntry> archive;
    while (reader.next()) {
        ArchiveEntry &entry = archive.emplace_back();
        reader.parse(0, entry.generation);
        reader.parse(1, entry.genome);
        reader.parse(2, entry.novelty);
        entry.behaviour.resize(columns - first_behaviour);
        for (std::size_t i = first_behaviour; i < columns; ++i)
            reader.parse(i, entry.behaviour[i - first_behaviour]);
    }
    return archive;
}

} // namespace planula
