// STAFF ONLY. The progress of long work: on a terminal a line for each step, as it is done; nothing in a pipe.
#pragma once

#include <unistd.h>

#include <iostream>
#include <string>

namespace grader {

class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total), shown_(isatty(STDERR_FILENO) != 0) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void step(const std::string& what) {
    ++done_;
    if (shown_) std::cerr << "[" << done_ << "/" << total_ << "] " << what << std::endl;
  }

 private:
  std::size_t total_, done_ = 0;
  bool shown_;
};

}  // namespace grader
