// SPDX-License-Identifier: MIT
#include "program/device_choice.h"

#include "base/error.h"

namespace planula {

DeviceChoice::DeviceChoice(const Arguments &arguments) {
    const std::string word = arguments.text("device", "cpu");
    if (word == "cpu") return;
    if (word != "gpu") throw UsageError("--device takes cpu or gpu, not '" + word + "'");
    try {
        device_ = std::make_unique<Device>(open_gpu());
    } catch (const InputError &error) {
        throw UsageError(std::string("--device gpu: ") + error.what());
    }
    choose_device(device_.get());
}

} // namespace planula
