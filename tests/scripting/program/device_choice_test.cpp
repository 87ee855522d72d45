// SPDX-License-Identifier: MIT
#include "program/device_choice.h"

#include "base/error.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using planula::test::contains;

namespace {

/// The message of the UsageError that --device with this word ends with; "" if it does not.
std::string message(const std::string &word) {
    Arguments arguments;
    if (!word.empty()) arguments.add("device", word);
    try {
        const DeviceChoice choice(arguments);
    } catch (const UsageError &error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(without_a_choice_bodies_move_on_this_processor) {
    BOOST_TEST(message("") == "");
    BOOST_TEST(message("cpu") == "");
    BOOST_TEST(chosen_device() == nullptr);
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_said_with_what_to_do) {
    BOOST_TEST(message("tpu") == "--device takes cpu or gpu, not 'tpu'");
    // Of this build support is missing, of others the device; where nothing is, it is chosen and left again.
    const std::string gpu = message("gpu");
    BOOST_TEST((gpu.empty() || contains(gpu, "make program GPU=1") || contains(gpu, "needs one of NVIDIA's")),
               gpu);
    BOOST_TEST(chosen_device() == nullptr);
}
