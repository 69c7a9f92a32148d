// STAFF ONLY. Starts other threads of the user that runs student code, as a desktop has them: the kernel
// counts them all together.
#pragma once

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "grader/sandbox/processes/identity.h"

namespace grader {

class BusyUser {
 public:
  explicit BusyUser(int threads) {
    int ready[2];
    if (pipe(ready) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
      if (!become(sandbox_identity()) || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) _exit(1);
      std::vector<std::thread> all;
      for (int i = 0; i < threads; ++i) all.emplace_back([] { pause(); });
      if (write(ready[1], "1", 1) != 1) _exit(1);
      for (;;) pause();
    }
    close(ready[1]);
    char letter;
    const bool started = read(ready[0], &letter, 1) == 1;
    close(ready[0]);
    if (!started) throw std::runtime_error("no process with so many threads");
  }
  ~BusyUser() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  BusyUser(const BusyUser&) = delete;
  BusyUser& operator=(const BusyUser&) = delete;

 private:
  pid_t process_;
};

}  // namespace grader
