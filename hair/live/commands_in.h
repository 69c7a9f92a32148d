// Lines of input that arrive while the program does other work.
#pragma once

#include <optional>
#include <string>

namespace hair {

class CommandsIn {
 public:
  explicit CommandsIn(int descriptor) : descriptor_(descriptor) {}

  // The next line; nothing if none comes within the time, or if there are no more.
  std::optional<std::string> next(int milliseconds);
  bool open() const { return open_; }

 private:
  int descriptor_;
  bool open_ = true;
  std::string read_;
};

}  // namespace hair
