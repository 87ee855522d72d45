// SPDX-License-Identifier: MIT
// The block of threads of graphics processors, as threads of this machine: what its warps tell each other, and a trial
// as the native engine simulates it. `cmake --preset tsan` finds two threads of a phase that use the same memory.
#include "support/cuda_words.h"

#include "device/cuda/block.cuh"
#include "physics/native/native_engine.h"
#include "support/emulated_device.h"
#include "support/specimens.h"
#include "support/trials.h"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>

using namespace planula;
using namespace planula::test;

namespace {

/// Calls act(block) on each thread of a block.
template <class Act> void on_block(int threads, const Act &act) {
    CudaThreads block(threads);
    device::Block::Told told{};
    block.run([&] {
        device::Block mine(told);
        act(mine);
    });
}

Trial trial_of_block(int threads, const std::vector<std::byte> &input) {
    const device::Task task = device::task_of(input);
    DeviceMemory sent(task.input_bytes), fast(task.fast_bytes), scratch(task.scratch_bytes),
        made(task.result_bytes);
    std::copy(input.begin(), input.end(), sent.data());
    on_block(threads, [&](device::Block &block) {
        device::run_trial(block, {sent.data(), fast.data(), scratch.data(), made.data()});
    });
    return device::unpack(input, {made.data(), task.result_bytes});
}

/// What a crew finds out about the first `count` of some numbers: each as bits.
template <class Crew>
std::vector<unsigned> found_by(Crew &crew, const std::vector<float> &numbers, int count, unsigned *words) {
    const auto number = [&](int i) { return numbers[i]; };
    std::vector<unsigned> found;
    for (const float sign : {1.0f, -1.0f})
        found.push_back(std::bit_cast<unsigned>(crew.least(count, [&](int i) { return sign * numbers[i]; })));
    found.push_back(
        std::bit_cast<unsigned>(crew.most(count, [&](int i) { return numbers[i] * numbers[i]; })));
    found.push_back(static_cast<unsigned>(crew.total(count, [&](int i) { return i % 7; })));
    for (const float limit : {-100.0f, 0.0f})
        found.push_back(crew.all(count, [&](int i) { return number(i) >= limit; }));
    crew.mark(
        count, [&](int i) { return number(i) > 0; }, words);
    for (int word = 0; word < (count + 31) / 32; ++word) found.push_back(words[word]);
    return found;
}

} // namespace

BOOST_AUTO_TEST_CASE(all_threads_of_a_block_find_what_one_finds) {
    std::vector<float> numbers;
    for (int i = 0; i < 300; ++i) numbers.push_back(static_cast<float>(i * 7919 % 1009 - 504) / 8);
    numbers[20] = std::numeric_limits<float>::infinity(), numbers[40] = -numbers[20];
    for (const int threads : {32, 96})
        for (const int count : {0, 1, 31, 33, 96, 97, 300}) {
            std::vector<unsigned> words(10), words_of_one(10);
            EmulatedBlock one(Order::forward);
            const std::vector<unsigned> expected = found_by(one, numbers, count, words_of_one.data());
            std::mutex mutex;
            int equal = 0;
            on_block(threads, [&](device::Block &block) {
                const std::vector<unsigned> found = found_by(block, numbers, count, words.data());
                const std::lock_guard lock(mutex);
                equal += found == expected;
            });
            BOOST_TEST(equal == threads, threads << " threads, " << count << " numbers");
        }
}

BOOST_AUTO_TEST_CASE(a_speed_that_is_no_number_is_the_highest) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float odd : {nan, -nan}) {
        std::atomic<int> told = 0;
        on_block(64, [&](device::Block &block) {
            told += std::isnan(block.most(50, [&](int i) { return i == 40 ? odd : static_cast<float>(i); }));
        });
        BOOST_TEST(told == 64);
    }
}

BOOST_AUTO_TEST_CASE(a_block_of_threads_moves_a_body_that_touches_itself_as_the_native_engine) {
    Parameters p;
    p.settling.settle_window = 10, p.settling.settle_limit = 20, p.settling.settle_speed = 10;
    p.gait.locomotion_steps = 120, p.gait.ramp_steps = 20;
    Parameters without = p;
    without.body.contact_stiffness = 0;
    const Body body = specimens::u_body(2, 3);
    Environment world = specimens::land();
    world.drag_normal = 0.7, world.drag_tangential = 0.2;
    const Networks networks;
    for (const bool oscillates : {true, false}) {
        if (!oscillates) p.gait.locomotion_steps = 60;
        const auto gait = [&] { return oscillates ? oscillators(body, p) : networks.gait(body, p); };
        const auto trial = [&](const Parameters &q) {
            NativeEngine engine;
            return locomote(specimens::soft_body(body, world, q), world, 0.8, q, *gait(), engine);
        };
        const Trial here = trial(p);
        BOOST_TEST((here.outcome == Outcome::viable));
        if (oscillates) BOOST_TEST(!same(here, trial(without)));
        const auto input = device::pack(specimens::soft_body(body, world, p), world, 0.8, p, *gait());
        BOOST_TEST(same(trial_of_block(64, *input), here));
    }
}
