#include "hair/live/whereabouts.h"

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace hair {

namespace {

constexpr const char* kLibrary = "libstudent_";
int lines_go_to = -1;

void write_text(const char* text, std::size_t size) {
  [[maybe_unused]] const ssize_t written = ::write(lines_go_to, text, size);
}

// The process crashes anyway, so it may call these two functions, which are unsafe in signal handlers.
void say() {
  std::array<void*, 64> calls;
  const int count = backtrace(calls.data(), static_cast<int>(calls.size()));
  for (int i = 0; i < count; ++i) {
    Dl_info info{};
    if (dladdr(calls[static_cast<std::size_t>(i)], &info) == 0 || !info.dli_fname) continue;
    const char* const library = std::strstr(info.dli_fname, kLibrary);
    if (!library) continue;
    const char* const exercise = library + std::strlen(kLibrary);
    write_text("\n@ ", 3);
    write_text(exercise, std::strcspn(exercise, "."));
    write_text(" ", 1);
    if (info.dli_sname) write_text(info.dli_sname, std::strlen(info.dli_sname));
    write_text("\n", 1);
    return;
  }
}

void on_crash(int signal) {
  say();
  raise(signal);  // ends like the original signal
}

void on_question(int) {
  say();
}

}  // namespace

void say_whereabouts(int descriptor) {
  lines_go_to = descriptor;
  std::array<void*, 1> first;
  backtrace(first.data(), 1);  // its first call loads a library
  // After endless recursion the stack is full.
  static std::array<char, 1 << 16> stack;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  sigaltstack(&other, nullptr);
  struct sigaction crash = {};
  crash.sa_handler = on_crash;
  crash.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(number, &crash, nullptr);
  struct sigaction question = {};
  question.sa_handler = on_question;
  question.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &question, nullptr);
}

}  // namespace hair
