#include "hair/simulation/strand_threads.h"

namespace hair {

StrandThreads::StrandThreads(int threads) : begin_(threads), end_(threads), failures_(threads) {
  for (int thread = 1; thread < threads; ++thread)
    others_.emplace_back([this, thread] {
      for (;;) {
        begin_.arrive_and_wait();
        if (stop_) return;
        take_tasks(thread);
        end_.arrive_and_wait();
      }
    });
}

StrandThreads::~StrandThreads() {
  stop_ = true;
  begin_.arrive_and_wait();
  for (std::thread& other : others_) other.join();
}

void StrandThreads::run(int tasks, const Task& task) {
  if (others_.empty()) {
    for (int i = 0; i < tasks; ++i) task(0, i);
    return;
  }
  next_ = 0;
  tasks_ = tasks;
  task_ = &task;
  for (Failure& failure : failures_) failure = {};
  begin_.arrive_and_wait();
  take_tasks(0);
  end_.arrive_and_wait();
  const Failure* first = nullptr;
  for (const Failure& failure : failures_)
    if (failure.exception && (!first || failure.i < first->i)) first = &failure;
  if (first) std::rethrow_exception(first->exception);
}

void StrandThreads::take_tasks(int thread) {
  for (int i = next_++; i < tasks_; i = next_++) try {
      (*task_)(thread, i);
    } catch (...) {
      failures_[thread] = {i, std::current_exception()};
      next_ = tasks_;
      return;
    }
}

}  // namespace hair
