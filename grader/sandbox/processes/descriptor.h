// STAFF ONLY. File descriptors that close themselves; all have close-on-exec.
#pragma once

#include <string>
#include <utility>

namespace grader::inline sandbox {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor read_end, write_end;
};

Pipe make_pipe();  // throws std::system_error

// Reads until the other side closes or the time is up, at most `limit` bytes.
std::string read_all(const Descriptor& from, std::size_t limit, double seconds);

// Reads until then, too, but takes all bytes. If there are more than `most`, it leaves out whole lines in the
// middle, and a line says so.
std::string read_both_ends(const Descriptor& from, std::size_t most, double seconds);

}  // namespace grader::sandbox
