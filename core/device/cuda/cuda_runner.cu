// SPDX-License-Identifier: MIT
// Batches of trials on an NVIDIA graphics processor, the first of the machine. Each batch has a stream, so that copies
// and kernels of several overlap, and buffers that grow.
#include "base/error.h"
#include "base/text.h"
#include "device/cuda/kernel.cuh"
#include "device/device.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace planula::device {

namespace {

/// Throws unless a call succeeded.
void require(cudaError_t code, const char *action) {
    if (code == cudaSuccess) return;
    throw IoError(std::string("the graphics processor failed to ") + action + " (" +
                  cudaGetErrorString(code) + "); the same command resumes, or goes on with --device cpu");
}

/// Memory that keeps nothing when it grows.
class Buffer {
  public:
    explicit Buffer(bool on_host) : on_host_(on_host) {}
    Buffer(const Buffer &) = delete;
    Buffer &operator=(const Buffer &) = delete;
    ~Buffer() { free(); }

    std::byte *of(std::size_t bytes) {
        if (bytes > size_) {
            free();
            const std::size_t size = bytes + bytes / 2;
            require(on_host_ ? cudaMallocHost(&data_, size) : cudaMalloc(&data_, size), "find memory");
            size_ = size;
        }
        return static_cast<std::byte *>(data_);
    }

  private:
    void free() {
        if (data_) on_host_ ? cudaFreeHost(data_) : cudaFree(data_);
        data_ = nullptr, size_ = 0;
    }
    bool on_host_;
    void *data_ = nullptr;
    std::size_t size_ = 0;
};

/// A batch: first the places of its trials, then their inputs.
class Batch {
  public:
    Batch() { require(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "make a stream"); }
    Batch(const Batch &) = delete;
    Batch &operator=(const Batch &) = delete;
    ~Batch() { cudaStreamDestroy(stream_); }

    void run(std::span<Job *const> jobs) {
        Place size{jobs.size() * sizeof(Place), 0, 0};
        size.input = (size.input + alignment - 1) / alignment * alignment;
        std::vector<Place> places;
        unsigned fast = 0;
        int threads = 0;
        for (const Job *job : jobs) {
            const auto &task = *reinterpret_cast<const Task *>(job->input.data());
            places.push_back(size);
            size.input += task.input_bytes, size.scratch += task.scratch_bytes,
                size.result += task.result_bytes;
            fast = std::max(fast, task.fast_bytes);
            threads = std::max(threads, (task.nodes + 31) / 32 * 32);
        }
        std::byte *sent = sent_.of(size.input), *results = results_.of(size.result);
        std::memcpy(sent, places.data(), places.size() * sizeof(Place));
        for (std::size_t i = 0; i < jobs.size(); ++i)
            std::memcpy(sent + places[i].input, jobs[i]->input.data(), jobs[i]->input.size());

        std::byte *inputs = inputs_.of(size.input), *made = made_.of(size.result),
                  *scratch = scratch_.of(size.scratch);
        require(cudaMemcpyAsync(inputs, sent, size.input, cudaMemcpyHostToDevice, stream_), "take trials");
        run_trials<<<static_cast<unsigned>(jobs.size()), threads, fast, stream_>>>(
            reinterpret_cast<const Place *>(inputs), inputs, scratch, made);
        require(cudaGetLastError(), "begin");
        // Copies of all batches wait in line: one that is asked for before its kernel has ended holds up the others.
        require(cudaStreamSynchronize(stream_), "end");
        require(cudaMemcpyAsync(results, made, size.result, cudaMemcpyDeviceToHost, stream_), "give results");
        require(cudaStreamSynchronize(stream_), "give results");
        for (std::size_t i = 0; i < jobs.size(); ++i)
            std::copy_n(results + places[i].result, jobs[i]->result.size(), jobs[i]->result.begin());
    }

  private:
    cudaStream_t stream_;
    Buffer sent_{true}, results_{true}, inputs_{false}, made_{false}, scratch_{false};
};

class CudaRunner final : public Runner {
  public:
    CudaRunner() {
        // Threads that wait for the device leave the processor to others.
        require(cudaSetDeviceFlags(cudaDeviceScheduleBlockingSync), "be set up");
        int most = 0;
        require(cudaDeviceGetAttribute(&most, cudaDevAttrMaxSharedMemoryPerBlockOptin, 0), "tell its memory");
        cudaFuncAttributes kernel;
        require(cudaFuncGetAttributes(&kernel, run_trials),
                "find its program: it is built for another generation");
        fast_bytes_ = static_cast<unsigned>(most) - static_cast<unsigned>(kernel.sharedSizeBytes);
        threads_ = kernel.maxThreadsPerBlock;
        require(cudaFuncSetAttribute(run_trials, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                     static_cast<int>(fast_bytes_)),
                "give its memory");
        require(cudaFuncSetAttribute(run_trials, cudaFuncAttributePreferredSharedMemoryCarveout,
                                     cudaSharedmemCarveoutMaxShared),
                "share its memory");
        for (int i = 0; i < batches(); ++i) batches_.push_back(std::make_unique<Batch>());
    }

    int batches() const override { return 16; }
    int largest_batch() const override { return 64; }
    unsigned fast_bytes() const override { return fast_bytes_; }
    int threads() const override { return threads_; }
    void run(int batch, std::span<Job *const> jobs) override { batches_[batch]->run(jobs); }

  private:
    unsigned fast_bytes_ = 0;
    int threads_ = 0;
    std::vector<std::unique_ptr<Batch>> batches_;
};

} // namespace

} // namespace planula::device

namespace planula {

std::unique_ptr<device::Runner> open_gpu() {
    constexpr int built_for =
        CUDART_VERSION / 1000; // CUDA's version, of which drivers know all up to their own
    int count = 0, driver = 0;
    cudaDriverGetVersion(&driver);
    const cudaError_t code = cudaGetDeviceCount(&count);
    if (code == cudaSuccess && count > 0) return std::make_unique<device::CudaRunner>();
    const int known = driver / 1000;
    const std::string reason = known == 0          ? "there is no driver"
                               : known < built_for ? "the driver is for CUDA " + to_text(known)
                                                   : cudaGetErrorString(code);
    throw InputError("no graphics processor can be used (" + reason +
                     "); needed is one of NVIDIA's, with a driver for CUDA " + to_text(built_for) +
                     " or newer. Without it all runs on processors, with equal results");
}

} // namespace planula
