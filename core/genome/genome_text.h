// SPDX-License-Identifier: MIT
// What a life reads of a genome, nodes and links, as lines of text (base/named_lines.h), for programs without files.
#pragma once

#include "genome/genome.h"

#include <string>
#include <string_view>

namespace planula {

std::string write_genome(const Genome &genome);

/// The same network to the bit; its ids and origin are those of no run. Throws InputError with line and rule, also for
/// a genome that check_genome() refuses.
Genome read_genome(std::string_view text);

} // namespace planula
