// SPDX-License-Identifier: MIT
// What the page calls: a life from texts, as the text of its recording. Without files, threads and Lua.
#include "evaluation/conditions_text.h"
#include "genome/genome_text.h"
#include "recording/recording_json.h"

#include <exception>
#include <string>

#include <emscripten.h>

using namespace planula;

extern "C" {

/// The JSON of a recording (recording/recording_json.h), valid until the next call; `is_compact`: that of a gallery.
EMSCRIPTEN_KEEPALIVE const char *simulate(const char *genome, const char *conditions, int is_compact) {
    static std::string text;
    text = recording_json(record_life(read_genome(genome), read_conditions(conditions), {},
                                      is_compact ? gallery_detail : full_detail));
    return text.c_str();
}

/// The message of what simulate() threw. Nothing is caught on this side, which keeps the code small and fast: the page
/// catches the address of an exception, asks for its message, and ends the worker.
EMSCRIPTEN_KEEPALIVE const char *message_of(const std::exception *thrown) { return thrown->what(); }
}
