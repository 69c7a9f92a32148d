// STAFF ONLY. The progress of long work. On a terminal each step has a line; in a file or a pipe one line a
// minute gives the state. Both estimate the remaining time, once it is known.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

namespace grader::inline class_folder {

class Progress {
 public:
  explicit Progress(std::size_t total);  // writes to the standard error stream
  // `seconds` is a clock that never goes back.
  Progress(std::size_t total, std::ostream& out, bool terminal, std::function<double()> seconds);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `worked` is false for a step that was already done, which does not help to estimate the others.
  void step(const std::string& what, bool worked = true);

 private:
  std::string left() const;

  std::size_t total_, done_ = 0, worked_ = 0;
  std::ostream& out_;
  bool terminal_;
  std::function<double()> seconds_;
  double began_, said_;
};

}  // namespace grader::class_folder
