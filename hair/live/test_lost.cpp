// An exercise that crashes, and one that hangs: as libstudent_H6.so.
#include <unistd.h>

#include <csignal>

namespace hair {

void crashes() {
  const volatile int result = raise(SIGSEGV);  // kept, so that the call is not optimised to a jump
  static_cast<void>(result);
}

void does_not_come_back(int descriptor) {
  [[maybe_unused]] const ssize_t ready = write(descriptor, "ready", 5);
  for (volatile int i = 0;; i = i + 1) continue;
}

}  // namespace hair
