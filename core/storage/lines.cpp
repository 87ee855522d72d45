// SPDX-License-Identifier: MIT
#include "storage/lines.h"

#include <algorithm>

namespace planula {

bool Lines::fill() {
    filled_ = static_cast<std::size_t>(input_.read(buffer_.data(), static_cast<int>(buffer_.size())));
    at_ = 0;
    return filled_ > 0;
}

bool Lines::next() {
    line_.clear();
    if (at_ == filled_ && !fill()) return false;
    for (;;) {
        const auto begin = buffer_.begin() + static_cast<std::ptrdiff_t>(at_);
        const auto end = buffer_.begin() + static_cast<std::ptrdiff_t>(filled_);
        const auto stop = std::find(begin, end, '\n');
        line_.append(begin, stop);
        at_ = static_cast<std::size_t>(stop - buffer_.begin());
        if (stop != end) return ++at_, true;
        if (!fill()) return true;
    }
}

} // namespace planula
