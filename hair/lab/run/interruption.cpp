#include "hair/lab/run/interruption.h"

#include <signal.h>
#include <unistd.h>

#include <cstring>

namespace hair {

namespace {

// A signal handler may touch nothing else.
std::atomic<bool> caught = false;
std::atomic<const char*> first_message = "";

void on_interrupt(int) {
  caught = true;
  const char* message = first_message;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message, std::strlen(message));
}

}  // namespace

const std::atomic<bool>& catch_interruption(const char* message) {
  first_message = message;
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  return caught;
}

}  // namespace hair
