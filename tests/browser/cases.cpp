// SPDX-License-Identifier: MIT
// module_cases EXPERIMENTS RUNS COUNT: lives that module_test.mjs simulates again, a line of JSON each: name, genome and
// conditions as texts, and the hashes of the life and of its recording. They are the champions of all runs in RUNS,
// specimens in the worlds of all variants, and COUNT random genomes with short lives, hostile ones of
// tests/support/hostile.h whose weights are finite.
#include "base/hash.h"
#include "base/json.h"
#include "base/text.h"
#include "browser/random_lives.h"
#include "evaluation/conditions_text.h"
#include "evaluation/life_digest.h"
#include "genome/genome_text.h"
#include "record/run_reader.h"
#include "recording/recording.h"
#include "recording/recording_json.h"
#include "statement/schema.h"
#include "statement/specimens.h"

#include <algorithm>
#include <cstdio>

using namespace planula;

namespace {

constexpr std::size_t specimens_of_variants = 2;

void print(const std::string &name, const Genome &genome, const Conditions &conditions) {
    // What the module cannot know has no part in the recording.
    Genome anonymous = genome;
    anonymous.id = 0;
    const LifeRecording recording = record_life(anonymous, conditions, {});
    std::puts(JsonObject()
                  .add("name", json_text(name))
                  .add("genome", json_text(write_genome(genome)))
                  .add("conditions", json_text(write_conditions(conditions)))
                  .add("life", json_text(life_sha256(recording.life)))
                  .add("recording", json_text(sha256(recording_json(recording))))
                  .text()
                  .c_str());
}

void print_champions(const std::filesystem::path &runs) {
    for (const std::filesystem::path &folder : folders_with_runs(runs)) {
        const RecordedRun run = read_run(folder);
        const SettingForRun own = recorded_setting(run);
        if (own.spec.engine != "bullet")
            print(run.setting + " seed " + to_text(run.seed), read_champion_genome(run, run.generations),
                  own.spec);
    }
}

void print_variants(const std::filesystem::path &library) {
    std::vector<std::filesystem::path> scripts;
    for (const auto &entry : std::filesystem::directory_iterator(library / "variants"))
        if (entry.path().extension() == ".lua") scripts.push_back(entry.path());
    std::sort(scripts.begin(), scripts.end());
    for (const auto &script : scripts)
        for (const Spec &setting : load_experiment(script, library, {}, Part::settings).settings) {
            std::vector<Genome> genomes = specimens(library, setting.actuation);
            genomes.resize(std::min(genomes.size(), specimens_of_variants));
            for (std::size_t i = 0; i < genomes.size(); ++i)
                print(script.stem().string() + " " + setting.name + " specimen " +
                          to_text(static_cast<std::int64_t>(i)),
                      genomes[i], setting);
        }
}

void print_random(int count) {
    for (int number = 0, printed = 0; printed < count; ++number) {
        const auto life = test::random_life(number);
        if (!life) continue;
        print("random " + to_text(number), life->genome, life->conditions);
        ++printed;
    }
}

} // namespace

int main(int argc, char **argv) {
    const auto count = parse_int(argc == 4 ? argv[3] : "");
    if (!count || *count < 0 || *count > 1'000'000) {
        std::fputs("usage: module_cases EXPERIMENTS RUNS COUNT\n", stderr);
        return 2;
    }
    try {
        print_champions(argv[2]);
        print_variants(argv[1]);
        print_random(static_cast<int>(*count));
    } catch (const std::exception &error) {
        std::fprintf(stderr, "module_cases: %s\n", error.what());
        return 1;
    }
    return 0;
}
