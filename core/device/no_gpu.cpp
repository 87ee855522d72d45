// SPDX-License-Identifier: MIT
// A build for processors alone; with PLANULA_GPU, cuda/cuda_runner.cu takes its place (core/CMakeLists.txt).
#if !defined(PLANULA_GPU)

#include "base/error.h"
#include "device/device.h"

namespace planula {

std::unique_ptr<device::Runner> open_gpu() {
    throw InputError("this planula is built without support for graphics processors; where NVIDIA's CUDA is "
                     "installed, `make program GPU=1` builds it with that");
}

} // namespace planula

#endif
