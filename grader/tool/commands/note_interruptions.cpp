// STAFF ONLY. Ctrl-C sets a flag, so that a command ends in order.
#include <signal.h>

#include "grader/sandbox/inherited.h"
#include "grader/tool/commands/command.h"

namespace grader::inline tool {
namespace {

std::atomic<bool> interrupted = false;  // a signal handler may change nothing else

}  // namespace

const std::atomic<bool>& note_interruptions() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);  // nohup ignores it
  return interrupted;
}

}  // namespace grader::tool
