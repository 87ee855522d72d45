// SPDX-License-Identifier: MIT
// A genome's network as a picture: inputs on the left, outputs on the right, hidden nodes between them by their
// depth; a link is the wider the stronger, blue if it excites and red if it inhibits, dashed if it is
// recurrent. The picture is SVG 1.1, and a function of the genome and the title alone.
#pragma once

#include "genome/genome.h"

#include <string>

namespace planula {

std::string svg_of(const Genome &genome, const std::string &title);

} // namespace planula
