// SPDX-License-Identifier: MIT
#include "experiment/revision.h"
#include "experiment/run.h"
#include "experiment/signature.h"
#include "scripting/commands.h"
#include "scripting/interrupt.h"

#include <ostream>

namespace planula {

namespace {

// The size of the runs that are signed: a part of the signature's definition.
const Overrides signed_size{{"population", 24}, {"generations", 4}};
constexpr std::uint64_t signed_seed = 1;

constexpr Option options[] = {
    threads_option,
    lanes_option,
    {"script", "FILE", "the experiment whose settings are signed (default: the paper's replication)"},
    {"compiled", "", "the signature that this program was built to have, without any run"},
};

int print_signature(const Arguments &arguments, Console &console) {
    if (arguments.has("compiled")) return console.out << model_revision() << '\n', 0;
    const std::string standard = (console.library / "paper" / "replication.lua").string();
    const int threads = threads_of(arguments);
    use_lanes_of(arguments);
    const Experiment experiment =
        load_experiment(arguments.text("script", standard), console.library, signed_size);
    const Interrupt interrupt;
    Signature signature;
    for (std::size_t i = 0; i < experiment.settings.size(); ++i) {
        const Spec &setting = experiment.settings[i];
        signature.setting(setting.name);
        experiment.hooks[i]->begin_run();
        run(
            setting, signed_seed, threads,
            [&](const Generation &generation) { signature.observe(generation); },
            [&] { return interrupt.requested(); });
    }
    console.out << signature.hex() << '\n';
    return 0;
}

} // namespace

const Command &signature_command() {
    static const Command command{"signature",
                                 "",
                                 "prints one hash over small runs of all settings: equal on every machine",
                                 "Runs each setting with 24 individuals for 4 generations of seed 1 and "
                                 "hashes every genome, life and\n"
                                 "evaluation. Any difference in any bit gives another line.",
                                 options,
                                 print_signature};
    return command;
}

} // namespace planula
