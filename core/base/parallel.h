// SPDX-License-Identifier: MIT
// The only threads of the core: independent tasks handed out one by one. A crew works at several jobs at once. Each job
// alternates between serial work and sharing out tasks; while one job is serial, or waits for its last task, the
// threads do tasks of the others.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <utility>

namespace planula {

class Crew {
  public:
    explicit Crew(int threads) : threads_(threads) {}

    /// Calls job(0) … job(count - 1) on the crew's threads, the calling one among them; returns when all are done. Jobs
    /// begin in order, and a further one only when a thread finds no task to do. After a job has thrown no other
    /// begins; when those that have begun are done, its exception is thrown again here.
    void work(int count, const std::function<void(int)> &job);
    /// Called by job number `job`, one call at a time: calls task(0) … task(count - 1), each once, on any of the
    /// threads; returns when all are done. Tasks of earlier jobs come first. If tasks throw, the exception of the
    /// lowest index is thrown again here.
    void share(int job, int count, const std::function<void(int)> &task);
    /// Whether a job has thrown, so that the others should end.
    bool failed();

  private:
    // The tasks of one call of share().
    struct Batch {
        const std::function<void(int)> &task;
        int count, begun = 0, done = 0;
        int lowest_failed;
        std::exception_ptr failure;
    };
    using Lock = std::unique_lock<std::mutex>;
    Batch *oldest_with_tasks();
    void do_task(Batch &batch, Lock &lock);
    void do_job(const std::function<void(int)> &job, Lock &lock);
    void serve(const std::function<void(int)> &job);

    const int threads_;
    std::mutex mutex_; // of all below
    std::condition_variable changed_;
    std::map<int, Batch *> batches_; // by job
    int jobs_ = 0, begun_ = 0, done_ = 0;
    std::exception_ptr failure_; // the first
};

/// Calls task(0) … task(count - 1), each once, on up to `threads` threads; returns when all are done. Tasks must not
/// depend on each other. If tasks throw, the exception of the lowest index is thrown again here.
void parallel_for(int count, int threads, const std::function<void(int)> &task);

/// The threads that compute the tasks of a job: its own, or a crew shared with others. No result depends on which.
class Workers {
  public:
    /// Is called in place of each task, on the task's thread, and calls it once.
    using Around = std::function<void(const std::function<void()> &task)>;

    Workers(int threads) : threads_(threads) {}
    Workers(Crew &crew, int job, Around around = {}) : crew_(&crew), job_(job), around_(std::move(around)) {}

    /// As parallel_for().
    void each(int count, const std::function<void(int)> &task) const;

  private:
    int threads_ = 1;
    Crew *crew_ = nullptr;
    int job_ = 0;
    Around around_;
};

/// The number of threads that this machine runs at once, at least 1.
int hardware_threads();

} // namespace planula
