// SPDX-License-Identifier: MIT
// replay: one individual of a run as a page that plays its life.
#include "base/error.h"
#include "base/text.h"
#include "page/page.h"
#include "program/commands.h"
#include "program/individual.h"
#include "recording/recording.h"
#include "recording/recording_json.h"

#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    champion_option,
    generation_option,
    slot_option,
    threads_option,
    {"html", "FILE", "write the page to FILE"},
};

/// Simulates the individual and records its life. Throws InputError if it is not the one that the run has.
LifeRecording recorded_life(const AskedIndividual &individual, const RecordedRun &run) {
    const SettingForRun own = recorded_setting(run);
    const Caption caption{own.spec.title,        own.experiment,  run.setting,       run.seed,
                          individual.generation, individual.slot, individual.fitness};
    LifeRecording recording = record_life(individual.genome, own.spec, caption);
    if (recording.life.displacement() != individual.displacement || recording.life.cells != individual.cells)
        throw InputError(run.folder.string() + ": genome " + to_text(individual.genome.id) + " moved " +
                         to_text(individual.displacement) + " cells with " + to_text(individual.cells) +
                         " cells when it was recorded, and simulated again it moves " +
                         to_text(recording.life.displacement()) + " with " + to_text(recording.life.cells));
    return recording;
}

/// The name of a file for an individual, without an ending.
std::string stem_of(const AskedIndividual &individual, const RecordedRun &run) {
    return run.setting + "-seed-" + to_text(run.seed) + "-genome-" + to_text(individual.genome.id);
}

int replay_life(const Arguments &arguments, Console &console) {
    const RecordedRun run = read_run(arguments.operands.at(0));
    const AskedIndividual individual = asked_individual(arguments, run);
    const std::string file = arguments.text("html", stem_of(individual, run) + ".html");
    check_replaceable(file);
    const LifeRecording recording = recorded_life(individual, run);
    write_new_file(file, replay_page(title_of(individual, run), recording_json(recording)));
    console.out << file << '\n';
    return 0;
}

} // namespace

const Command &replay_command() {
    static const Command command{
        "replay",
        "RUN",
        "shows an individual as it grows and moves: a page for a browser",
        R"(RUN is the folder of a complete run. The individual is the last champion, unless --genome, or --generation and --slot name
another. Its life is simulated again.)",
        options,
        replay_life};
    return command;
}

} // namespace planula
