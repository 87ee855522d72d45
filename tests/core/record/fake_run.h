// SPDX-License-Identifier: MIT
// Runs made by hand: generations with the lives that a test states, recorded as a real run would be.
#pragma once

#include "core/tables/fake_generations.h"
#include "record/run_reader.h"
#include "record/run_writer.h"

#include <cstdint>
#include <filesystem>

namespace planula {

inline RunSources fake_sources() {
    return {{{"experiment.lua", "fake.lua", "return {} -- a script\n"}}, {{"population", 5}}};
}

/// Writes a whole run into a folder.
inline void write_fake_run_into(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                                const Invent &invent) {
    RunWriter writer(folder, spec, seed, fake_sources());
    FakeRun run(spec, seed);
    for (int generation = 0; generation < spec.parameters.design.generations; ++generation)
        run.step(writer, invent);
    writer.finish();
}

/// Writes a whole run below `runs` and returns its folder.
inline std::filesystem::path write_fake_run(const std::filesystem::path &runs, const Spec &spec,
                                            std::uint64_t seed, const Invent &invent) {
    const std::filesystem::path folder = run_folder(runs, spec.name, seed);
    write_fake_run_into(folder, spec, seed, invent);
    return folder;
}

} // namespace planula
