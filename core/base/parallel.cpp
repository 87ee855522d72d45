// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace planula {

void Crew::work(int count, const std::function<void(int)> &job) {
    {
        const Lock lock(mutex_);
        jobs_ = count;
        begun_ = done_ = 0;
        failure_ = nullptr;
    }

    // The calling thread works too; the others are joined at the end of the block.
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < threads_; ++i) helpers.emplace_back([&] { serve(job); });
        serve(job);
    }
    if (failure_) std::rethrow_exception(failure_);
}

void Crew::share(int job, int count, const std::function<void(int)> &task) {
    Batch batch{.task = task, .count = count, .lowest_failed = count};
    Lock lock(mutex_);
    batches_.emplace(job, &batch);
    changed_.notify_all();

    // While others do the last of them, this thread does some of theirs.
    while (batch.done < count)
        if (Batch *next = oldest_with_tasks())
            do_task(*next, lock);
        else
            changed_.wait(lock);
    batches_.erase(job);
    if (batch.failure) std::rethrow_exception(batch.failure);
}

bool Crew::failed() {
    const Lock lock(mutex_);
    return failure_ != nullptr;
}

Crew::Batch *Crew::oldest_with_tasks() {
    for (const auto &[job, batch] : batches_)
        if (batch->begun < batch->count) return batch;
    return nullptr;
}

void Crew::do_task(Batch &batch, Lock &lock) {
    const int index = batch.begun++;
    std::exception_ptr failure;
    lock.unlock();
    try {
        batch.task(index);
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (failure && index < batch.lowest_failed) {
        batch.lowest_failed = index;
        batch.failure = failure;
    }
    if (++batch.done == batch.count) changed_.notify_all();
}

void Crew::do_job(const std::function<void(int)> &job, Lock &lock) {
    const int number = begun_++;
    std::exception_ptr failure;
    lock.unlock();
    try {
        job(number);
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (!failure_) failure_ = failure;
    ++done_;
    changed_.notify_all();
}

void Crew::serve(const std::function<void(int)> &job) {
    for (Lock lock(mutex_);;) {
        const bool more = begun_ < jobs_ && !failure_;
        if (Batch *batch = oldest_with_tasks())
            do_task(*batch, lock);
        else if (more)
            do_job(job, lock);
        else if (done_ == begun_)
            return;
        else
            changed_.wait(lock);
    }
}

void parallel_for(int count, int threads, const std::function<void(int)> &task) {
    Crew crew(std::min(threads, count));
    crew.work(1, [&](int job) { crew.share(job, count, task); });
}

void Workers::each(int count, const std::function<void(int)> &task) const {
    if (!crew_)
        parallel_for(count, threads_, task);
    else if (!around_)
        crew_->share(job_, count, task);
    else
        crew_->share(job_, count, [&](int index) { around_([&] { task(index); }); });
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

} // namespace planula
