// STAFF ONLY. The progress of long work. On a terminal each step has a line, as it is done; in a file or a
// pipe one line a minute says how far it is. Both say how long it will still take, once that is known.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

namespace grader::inline tool {

class Progress {
 public:
  explicit Progress(std::size_t total);  // on the standard error stream
  // `seconds`: a clock that never goes back.
  Progress(std::size_t total, std::ostream& out, bool terminal, std::function<double()> seconds);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `worked`: false for a step that was found done, which says nothing about how long the others take.
  void step(const std::string& what, bool worked = true);

 private:
  std::string left() const;

  std::size_t total_, done_ = 0, worked_ = 0;
  std::ostream& out_;
  bool terminal_;
  std::function<double()> seconds_;
  double began_, said_;
};

}  // namespace grader::tool
