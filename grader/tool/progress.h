// STAFF ONLY. The progress of long work: one line on a terminal, nothing in a pipe.
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
  ~Progress() {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
  }
  void step(const std::string& name) {
    ++done_;
    if (shown_) std::cerr << "\r\033[K[" << done_ << "/" << total_ << "] " << name << std::flush;
  }

 private:
  std::size_t total_, done_ = 0;
  bool shown_;
};

}  // namespace grader
