// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "record/merge.h"
#include "record/run_reader.h"

#include <ostream>
#include <set>

namespace planula {

namespace {

constexpr Option options[] = {
    {"into", "DIR", "folder that receives the runs (required); it is made if it does not exist"}};

/// How many runs were copied, replaced by longer ones, there already and so on.
struct Gathered {
    int copied = 0, longer = 0, known = 0, unfinished = 0, refused = 0;
};

/// Throws InputError if a folder has no runs of its own, and says where there are some below it.
void check_runs_in(const std::string &from) {
    if (!std::filesystem::is_directory(from)) throw InputError(from + " is not a folder");
    if (!statuses(from).empty()) return;
    const std::vector<std::filesystem::path> below = folders_with_runs(from);
    throw InputError(from + " has no runs, <setting>/seed-NNN" +
                     (below.empty() ? "" : "; give the folder that was --out of " + below.front().string()));
}

/// Gathers every run below a folder, and reports each that is refused.
void gather(const std::filesystem::path &from, const std::filesystem::path &into, Gathered &all,
            std::ostream &err) {
    std::set<std::filesystem::path> ended;
    for (const RunStatus &run : statuses(from)) {
        const std::filesystem::path setting = run.folder.parent_path().filename();
        if (ended.insert(setting).second) end_merges(into / setting);
        const auto refuse = [&](const Error &error) {
            err << "refused: " << error.what() << '\n';
            ++all.refused;
        };
        try {
            const Merged merged = merge_run(run.folder, into / setting / run.folder.filename());
            switch (merged) {
            case Merged::copied:
                ++all.copied;
                break;
            case Merged::longer:
                ++all.longer;
                break;
            case Merged::known:
                ++all.known;
                break;
            case Merged::unfinished:
                err << "left out: " << run.folder.string()
                    << ": it is unfinished and longer than the complete run in --into; complete it first\n";
                ++all.unfinished;
                break;
            }
        } catch (const InputError &error) {
            refuse(error);
        } catch (const RefusedError &error) {
            refuse(error);
        }
    }
}

int merge(const Arguments &arguments, Console &console) {
    if (!arguments.has("into")) throw UsageError("planula merge needs --into DIR\nsee planula merge --help");
    const std::filesystem::path into = arguments.text("into");
    for (const std::string &from : arguments.operands) {
        std::error_code unknown;
        check_runs_in(from);
        if (std::filesystem::equivalent(from, into, unknown))
            throw UsageError("planula merge: " + from + " is the folder of --into itself");
    }
    make_folder(into);
    const FolderLock held(into);
    Gathered all;
    for (const std::string &from : arguments.operands) gather(from, into, all, console.err);
    console.out << into.string() << ": " << counted(all.copied, "run") << " copied, " << all.longer
                << " replaced by a longer one, " << all.known << " there already, "
                << (all.unfinished > 0 ? to_text(all.unfinished) + " left out as unfinished, " : "")
                << all.refused << " refused\n";
    if (all.refused > 0)
        throw InputError("merge: " + counted(all.refused, "run") +
                         " refused; both folders hold what they held");
    return 0;
}

} // namespace

const Command &merge_command() {
    static const Command command{
        "merge",
        "FROM...",
        "gathers the runs of several folders in one",
        R"(Each FROM is a folder that was given to planula run as --out, on this machine or another. A run that --into does not have
is copied. If it has the run with another length, the longer one stays, provided that the chain of hashes shows the shorter one to be
its beginning; otherwise the run is refused by name, and nothing of it is changed.

A run is copied completely or not at all: if the command was stopped, give it again.)",
        options,
        merge};
    return command;
}

} // namespace planula
