// STAFF ONLY. For the test of inheritance: `inheritor FILE` sets what it inherits, and writes its state into
// FILE, one line each; `inheritor FILE needs` writes whether hard limits leave enough for grading.
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/personality.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <exception>
#include <fstream>
#include <sstream>

#include "grader/sandbox/inherited.h"

namespace {

void write_state(std::ostream& out) {
  for (int resource = 0; resource < RLIM_NLIMITS; ++resource) {
    rlimit limit{};
    getrlimit(static_cast<__rlimit_resource>(resource), &limit);
    // These two only say what a process may ask for, and no process asks.
    if (resource != RLIMIT_NICE && resource != RLIMIT_RTPRIO)
      out << "limit " << resource << ": " << limit.rlim_cur << "\n";
  }
  pthread_attr_t attributes;
  std::size_t stack = 0;
  pthread_getattr_default_np(&attributes);
  pthread_attr_getstacksize(&attributes, &stack);
  out << "a thread's stack: " << stack << "\n";
  for (char** variable = environ; *variable != nullptr; ++variable) out << *variable << "\n";
  sigset_t blocked;
  sigprocmask(SIG_SETMASK, nullptr, &blocked);
  for (int number = 1; number < NSIG; ++number) {
    if (grader::is_ignored(number)) out << "ignored: " << number << "\n";
    if (sigismember(&blocked, number) == 1) out << "blocked: " << number << "\n";
  }
  out << "mask for the owner: " << (umask(0) & 0700) << "\n";
  for (int number = 0; number < 3; ++number)
    if (fcntl(number, F_GETFD) < 0) out << "closed: " << number << "\n";
  out << "personality: " << personality(0xffffffff) << "\n";
}

}  // namespace

int main(int argc, char* argv[]) {
  grader::set_what_is_inherited(argv);
  if (argc < 2) return 2;
  std::ostringstream state;
  write_state(state);  // comes before the file takes a closed descriptor's number
  std::ofstream out(argv[1]);
  if (argc == 2) {
    out << state.str();
    return 0;
  }
  try {
    grader::require_hard_limits({.jobs = 4, .cpu_seconds = 150});
    out << "enough";
  } catch (const std::exception& refusal) {
    out << refusal.what();
  }
}
