// Distributes strands over threads. Nothing couples strands within a step, so any thread may step each.
#pragma once

#include <algorithm>
#include <atomic>
#include <barrier>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace hair {

// The number of threads: as asked for, or, for 0, one for each processor, up to 16.
inline int threads_for(int asked) {
  return asked > 0 ? asked : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 16);
}

class StrandThreads {
 public:
  // `threads` >= 1, including the caller's. They wait until the end of this object's life.
  explicit StrandThreads(int threads);
  ~StrandThreads();
  StrandThreads(const StrandThreads&) = delete;
  StrandThreads& operator=(const StrandThreads&) = delete;

  int count() const { return static_cast<int>(others_.size()) + 1; }

  // Calls task(thread, i) once for each i from 0 to `tasks` - 1, and returns when all have returned. `thread`
  // counts from 0; no two calls at a time have the same one. If a task throws, no further tasks begin, and
  // run() throws the exception of the smallest i that threw. Allocates nothing.
  using Task = std::function<void(int thread, int i)>;
  void run(int tasks, const Task& task);

 private:
  void take_tasks(int thread);

  std::barrier<> begin_, end_;
  bool stop_ = false;
  std::atomic<int> next_ = 0;
  int tasks_ = 0;
  const Task* task_ = nullptr;
  struct Failure {
    int i = 0;
    std::exception_ptr exception;
  };
  std::vector<Failure> failures_;  // one for each thread
  std::vector<std::thread> others_;
};

}  // namespace hair
