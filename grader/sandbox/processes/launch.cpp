// STAFF ONLY. Makes the system calls between fork and exec.
#include "grader/sandbox/processes/launch.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <linux/seccomp.h>

#include <cstring>

namespace grader::inline sandbox {
namespace {

constexpr int kNotReady = 126, kNotFound = 127;  // shells use these exit codes

// Lets the kernel end this process before ours when memory runs out. Any user may do this.
void volunteer() {
  const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file >= 0) (void)!write(file, "1000", 4);
}

}  // namespace

void Launch::exec() const {
  for (int group : joins)
    if (write(group, "0", 1) != 1) _exit(kNotReady);
  int sources[] = {output, output, requests, replies, info, filter_file};
  const int targets[] = {1, 2, kRequests, kReplies, kInfo, kFilter};
  for (int& source : sources)
    if (source >= 0 && (source = fcntl(source, F_DUPFD_CLOEXEC, 32)) < 0)
      _exit(kNotReady);  // moves it above the targets' numbers
  if (syscall(SYS_close_range, 3, ~0U, 4U /* CLOSE_RANGE_CLOEXEC */) != 0) _exit(kNotReady);
  for (int i = 0; i < 6; ++i)
    if (sources[i] >= 0 && dup2(sources[i], targets[i]) < 0) _exit(kNotReady);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (dup2(nothing, 0) < 0) _exit(kNotReady);
  if (output < 0 && (dup2(nothing, 1) < 0 || dup2(nothing, 2) < 0)) _exit(kNotReady);
  if (own_session) {
    setsid();
    volunteer();
  }
  if (root != nullptr && chroot(root) != 0) _exit(kNotReady);
  if (!become(identity)) _exit(kNotReady);
  if (folder != nullptr && chdir(folder) != 0) _exit(kNotReady);
  if (!filter.empty()) {
    const sock_fprog program{static_cast<unsigned short>(filter.size()),
                             const_cast<sock_filter*>(filter.data())};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0)
      _exit(kNotReady);
  }
  execve(argv[0], argv.data(), environment.data());
  for (const char* text : {static_cast<const char*>(argv[0]), " can't be started\n"})
    (void)!write(STDERR_FILENO, text, std::strlen(text));
  _exit(kNotFound);
}

}  // namespace grader::sandbox
