// SPDX-License-Identifier: MIT
// replay: one individual of a run as a page that plays its life, a strip of pictures, or a film.
#include "analysis/life_picture.h"
#include "base/error.h"
#include "base/text.h"
#include "page/page.h"
#include "program/commands.h"
#include "program/individual.h"
#include "program/interrupt.h"
#include "program/tool.h"
#include "recording/recording.h"
#include "recording/recording_json.h"
#include "storage/input.h"
#include "storage/output.h"

#include <algorithm>
#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    champion_option,
    generation_option,
    slot_option,
    threads_option,
    {"html", "FILE", "write a page that plays the life (default: into the current folder)"},
    {"svg", "FILE", "write a strip of pictures: growth, gait and the whole path"},
    {"png", "FILE", "write that strip as PNG; needs rsvg-convert"},
    {"gif", "FILE", "write a film as GIF; needs ffmpeg"},
    {"mp4", "FILE", "write a film as MP4; needs ffmpeg"},
    {"module", "FILE",
     "let the page simulate the life again, by the module that `make wasm` builds: build/wasm/planula.js"},
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

/// The name of a page for an individual.
std::string page_name(const AskedIndividual &individual, const RecordedRun &run) {
    return run.setting + "-seed-" + to_text(run.seed) + "-genome-" + to_text(individual.genome.id) + ".html";
}

std::string frame_name(int number) {
    const std::string digits = to_text(number);
    return "frame-" + std::string(5 - std::min<std::size_t>(5, digits.size()), '0') + digits + ".svg";
}

void draw_film(const LifeRecording &recording, const std::string &title, const Workshop &workshop) {
    const Interrupt interrupt;
    int number = 0;
    for (const FilmFrame &frame : film_frames(recording)) {
        if (interrupt.requested()) throw Stopped("stopped; no film is written");
        write_file(workshop.file(frame_name(number++)), film_picture(recording, frame, title));
    }
}

/// Joins the frames to a film: `how` is what ffmpeg is told of its form.
void join_film(const std::vector<std::string> &how, const std::string &name,
               const std::filesystem::path &file, const Workshop &workshop) {
    std::vector<std::string> words{
        "-loglevel", "error", "-y", "-framerate", to_text(film_rate), "-i", workshop.file("frame-%05d.svg")};
    words.insert(words.end(), how.begin(), how.end());
    words.push_back(workshop.file(name));
    run_tool("ffmpeg", words);
    write_file(file, read_file(workshop.file(name)));
}

/// Every option that names a file.
constexpr const char *forms[] = {"html", "svg", "png", "gif", "mp4"};

/// Throws UsageError if a file is called as one of another form.
void check_ending(const std::string &form, const std::string &file) {
    for (const std::string other : forms)
        if (other != form && file.ends_with("." + other))
            throw UsageError("--" + form + " " + file +
                             " would be a file of another form than its name says; " + "write --" + other +
                             " " + file);
}

/// Throws before anything is simulated if one of the files cannot be made.
void check_outputs(const Arguments &arguments) {
    for (const char *form : forms)
        if (arguments.has(form)) {
            check_ending(form, arguments.text(form));
            check_replaceable(arguments.text(form));
        }
    if (arguments.has("png")) require_tool("rsvg-convert", "librsvg2-bin", "--png");
    for (const char *form : {"gif", "mp4"})
        if (arguments.has(form)) require_tool("ffmpeg", "ffmpeg", "--" + std::string(form));
}

/// GIF compresses little: every second frame, smaller, in few colours, of each frame the part that differs.
constexpr const char *gif_filter =
    "fps=10,scale=640:-1:flags=area,split[a][b];[a]palettegen=max_colors=64[p];"
    "[b][p]paletteuse=dither=none:diff_mode=rectangle";

void write_films(const Arguments &arguments, const LifeRecording &recording, const std::string &title) {
    if (!arguments.has("gif") && !arguments.has("mp4")) return;
    const Workshop workshop;
    draw_film(recording, title, workshop);
    if (arguments.has("gif")) join_film({"-vf", gif_filter}, "film.gif", arguments.text("gif"), workshop);
    if (arguments.has("mp4"))
        join_film({"-pix_fmt", "yuv420p", "-movflags", "+faststart"}, "film.mp4", arguments.text("mp4"),
                  workshop);
}

void write_pictures(const Arguments &arguments, const LifeRecording &recording, const std::string &title) {
    if (!arguments.has("svg") && !arguments.has("png")) return;
    const std::string strip = life_strip(recording, title);
    if (arguments.has("svg")) write_new_file(arguments.text("svg"), strip);
    if (!arguments.has("png")) return;
    const Workshop workshop;
    write_file(workshop.file("strip.svg"), strip);
    run_tool("rsvg-convert",
             {"--zoom", "2", "--output", workshop.file("strip.png"), workshop.file("strip.svg")});
    write_file(arguments.text("png"), read_file(workshop.file("strip.png")));
}

int replay_life(const Arguments &arguments, Console &console) {
    check_outputs(arguments);
    const RecordedRun run = asked_run(arguments);
    const AskedIndividual individual = asked_individual(arguments, run);
    const std::string title = title_of(individual, run);
    std::string page = arguments.text("html");
    bool others = false;
    for (const char *form : forms) others = others || arguments.has(form);
    if (!others) check_replaceable(page = page_name(individual, run));
    const std::string module = arguments.has("module") ? packed_module(arguments.text("module")) : "";
    if (!module.empty() && page.empty()) throw UsageError("--module is for a page: add --html FILE");
    const LifeRecording recording = recorded_life(individual, run);
    if (!page.empty()) write_new_file(page, replay_page(title, recording_json(recording), module));
    write_pictures(arguments, recording, title);
    write_films(arguments, recording, title);
    if (!others) console.out << page << '\n';
    for (const char *form : forms)
        if (arguments.has(form)) console.out << arguments.text(form) << '\n';
    return 0;
}

} // namespace

const Command &replay_command() {
    static const Command command{
        "replay",
        "RUN",
        "shows an individual as it grows and moves: a page, pictures or a film",
        R"(RUN is the folder of a complete run, or a folder with only one run below it. The individual is the last champion, unless --genome,
or --generation and --slot name another. Its life is simulated again; if it differs from the record, the command ends with an error.

Without an option for a file, a page is written into the current folder, named after the run. It plays the life in any browser and needs
nothing beside itself, no network either. The paths of the files written are printed.

A film shows two time units of the model in a second. ffmpeg must be able to read SVG, as Debian's is.)",
        options,
        replay_life};
    return command;
}

} // namespace planula
