// SPDX-License-Identifier: MIT
#include "record/chain.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "experiment/digest.h"
#include "storage/lines.h"
#include "tables/csv.h"

#include <memory>
#include <optional>

namespace planula {

namespace {

std::string next_link(const std::string &before, const std::string &content, const RowTexts &rows) {
    Hash link;
    link.text(before).text(content);
    for (const std::string &lines : rows) link.text(sha256(lines));
    return link.hex();
}

/// The rows of a table, generation by generation.
class Rows {
  public:
    explicit Rows(const std::filesystem::path &path) : lines_(path) {
        lines_.next();
        more_ = lines_.next();
    }

    /// The lines of this generation, which follow those of the one before.
    std::string take(int generation) {
        std::string text;
        const std::string start = to_text(generation) + ",";
        for (; more_ && lines_.line().starts_with(start); more_ = lines_.next()) text += lines_.line() + '\n';
        return text;
    }
    bool is_at_end() const { return !more_; }

  private:
    Lines lines_;
    bool more_ = false;
};

/// The tables of a folder; nothing in place of one that is not there.
std::vector<std::unique_ptr<Rows>> open_tables(const std::filesystem::path &folder) {
    std::vector<std::unique_ptr<Rows>> tables;
    for (const std::string_view file : run_tables) {
        const bool is_there = file != ArchiveRow::file_name || std::filesystem::exists(folder / file);
        tables.push_back(is_there ? std::make_unique<Rows>(folder / file) : nullptr);
    }
    return tables;
}

} // namespace

std::string chain_start(const std::string &identity_sha256) {
    return Hash().text("planula chain").text(identity_sha256).hex();
}

std::string generation_sha256(const Generation &generation) {
    Hash content;
    digest(content, generation);
    return content.hex();
}

ChainRow chain_row(const std::string &before, const Generation &generation, const RowTexts &rows) {
    const std::string content = generation_sha256(generation);
    return {generation.number, content, next_link(before, content, rows)};
}

std::vector<ChainRow> read_chain(const std::filesystem::path &folder) {
    TableReader<ChainRow> reader(folder);
    std::vector<ChainRow> chain;
    for (ChainRow row; reader.next(row);) {
        if (row.generation != static_cast<int>(chain.size()))
            reader.refuse("generation " + to_text(row.generation) + " where " +
                          to_text(static_cast<std::int64_t>(chain.size())) + " must follow");
        chain.push_back(row);
    }
    return chain;
}

void check_chain(const std::filesystem::path &folder, const std::string &identity_sha256,
                 const std::vector<ChainRow> &chain) {
    const auto tables = open_tables(folder);
    std::string before = chain_start(identity_sha256);
    for (const ChainRow &row : chain) {
        RowTexts rows;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (tables[i]) rows[i] = tables[i]->take(row.generation);
        if (next_link(before, row.content, rows) != row.link)
            throw InputError(folder.string() + ": generation " + to_text(row.generation) +
                             " is not as the chain has it: a table or the chain was changed there");
        before = row.link;
    }
    for (std::size_t i = 0; i < tables.size(); ++i)
        if (tables[i] && !tables[i]->is_at_end())
            throw InputError((folder / run_tables[i]).string() +
                             ": there are rows after those of generation " +
                             to_text(static_cast<std::int64_t>(chain.size()) - 1));
}

} // namespace planula
