// SPDX-License-Identifier: MIT
// --device: whether bodies move on this processor or on a graphics processor. No result depends on it.
#pragma once

#include "device/device.h"
#include "program/arguments.h"

#include <memory>

namespace planula {

inline constexpr Option device_option{
    "device", "cpu|gpu",
    "what moves the bodies: processors, or a graphics processor (default: cpu); no result depends on it"};

/// Uses the device that --device asks for, as long as this is there. Throws UsageError that says what is missing.
class DeviceChoice {
  public:
    explicit DeviceChoice(const Arguments &arguments);
    ~DeviceChoice() { choose_device(nullptr); }
    DeviceChoice(const DeviceChoice &) = delete;
    DeviceChoice &operator=(const DeviceChoice &) = delete;

  private:
    std::unique_ptr<Device> device_;
};

} // namespace planula
