// SPDX-License-Identifier: MIT
// One hash over what runs produce: every generation whole (experiment/digest.h), to the bit. Equal signatures on
// two machines mean that everything between a seed and a result is the same there.
#pragma once

#include "base/hash.h"
#include "experiment/digest.h"

#include <string>
#include <string_view>

namespace planula {

class Signature {
  public:
    /// Begins a run of the setting of this name.
    void setting(std::string_view name) { hash_.text(name); }
    void observe(const Generation &generation) { digest(hash_, generation); }
    /// 64 hexadecimal digits over everything so far.
    std::string hex() const { return hash_.hex(); }

  private:
    Hash hash_;
};

} // namespace planula
