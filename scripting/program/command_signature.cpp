// SPDX-License-Identifier: MIT
#include "experiment/revision.h"
#include "experiment/run.h"
#include "experiment/signature.h"
#include "program/commands.h"
#include "program/device_choice.h"
#include "program/interrupt.h"

#include <ostream>

namespace planula {

namespace {

constexpr std::uint64_t signed_seed = 1;

constexpr Option options[] = {
    threads_option,
    lanes_option,
    device_option,
    {"script", "FILE.lua", "experiment to run (default: experiments/signature.lua)"},
    {"compiled", "", "run nothing; print the signature that this program was built to have"},
};

std::string measured_signature(const Experiment &experiment, int threads) {
    const Interrupt interrupt;
    Signature signature;
    for (std::size_t i = 0; i < experiment.settings.size(); ++i) {
        const Spec &setting = experiment.settings[i];
        signature.setting(setting.name);
        experiment.functions[i]->begin_run();
        run(
            setting, signed_seed, threads,
            [&](const Generation &generation) { signature.observe(generation); },
            [&] { return interrupt.requested(); });
    }
    return signature.hex();
}

int print_signature(const Arguments &arguments, Console &console) {
    if (arguments.has("compiled")) return console.out << model_revision() << '\n', 0;
    const std::string standard = (console.library / "signature.lua").string();
    const DeviceChoice device(arguments);
    const int threads = threads_of(arguments);
    use_lanes_of(arguments);
    const Experiment experiment = load_experiment(arguments.text("script", standard), console.library, {});
    console.out << measured_signature(experiment, threads) << '\n';
    return 0;
}

} // namespace

const Command &signature_command() {
    static const Command command{
        "signature",
        "",
        "prints one hash over small runs of many settings, equal on every machine",
        R"(Runs each setting of experiments/signature.lua with seed 1 and hashes every generation completely: genomes,
lives, evaluations, scores, species and archive. A difference in any bit gives another hash. The expected
hash is the revision of the model, whose first digits planula --version prints.)",
        options,
        print_signature};
    return command;
}

} // namespace planula
