// SPDX-License-Identifier: MIT
// Pictures of a recorded life, as SVG 1.1: a strip of its frames, and the frames of a film. They are functions of the
// recording and the title alone.
#pragma once

#include "recording/recording.h"

#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// Growth in six frames, the last period of the gait in six, and the whole path with the body at five times. Of a life
/// without locomotion its growth alone.
std::string life_strip(const LifeRecording &recording, std::string_view title);

/// A frame of growth or of locomotion.
struct FilmFrame {
    bool grows = true;
    std::size_t frame = 0; // of the recording
};
/// Those of a film: growth, and locomotion every film_interval steps. Shown at film_rate frames a second, a second is
/// two time units of the model.
inline constexpr int film_interval = 10, film_rate = 20;
std::vector<FilmFrame> film_frames(const LifeRecording &recording);
/// One of them, with the body in the middle, or with the body and a loose object.
std::string film_picture(const LifeRecording &recording, const FilmFrame &frame, std::string_view title);

} // namespace planula
