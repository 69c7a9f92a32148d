// STAFF ONLY. Handles SIGSYS.
#include "grader/sandbox/system_calls/stopped_calls.h"

#include <signal.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace grader::inline sandbox {
namespace {

void (*tell_denied)(int) = nullptr;
void (*tell_leaves)(int) = nullptr;

using Mask = std::uint64_t;  // has the kernel's size

#if defined(__x86_64__)
long argument(const mcontext_t& registers, int i) {
  constexpr int kPlaces[] = {REG_RDI, REG_RSI, REG_RDX};
  return static_cast<long>(registers.gregs[kPlaces[i]]);
}
void set_result(mcontext_t& registers, long result) {
  registers.gregs[REG_RAX] = result;
}
#elif defined(__aarch64__)
long argument(const mcontext_t& registers, int i) {
  return static_cast<long>(registers.regs[i]);
}
void set_result(mcontext_t& registers, long result) {
  registers.regs[0] = static_cast<unsigned long long>(result);
}
#else
#error "the registers that hold a system call's arguments and its result are not known here"
#endif

// Does rt_sigprocmask(how, set, old): the mask after the handler's return is the requested one, without
// SIGSYS.
long change_mask(ucontext_t& context) {
  Mask mask = 0, set = 0;
  std::memcpy(&mask, &context.uc_sigmask, sizeof mask);
  const Mask before = mask;
  const auto address = [&](int i) {
    return reinterpret_cast<void*>(argument(context.uc_mcontext, i));  // NOLINT(performance-no-int-to-ptr)
  };
  if (address(1) != nullptr) {
    std::memcpy(&set, address(1), sizeof set);
    switch (argument(context.uc_mcontext, 0)) {
      case SIG_BLOCK:
        mask |= set;
        break;
      case SIG_UNBLOCK:
        mask &= ~set;
        break;
      case SIG_SETMASK:
        mask = set;
        break;
      default:
        return -EINVAL;
    }
    mask &= ~(Mask{1} << (SIGSYS - 1));
    std::memcpy(&context.uc_sigmask, &mask, sizeof mask);
  }
  if (address(2) != nullptr) std::memcpy(address(2), &before, sizeof before);
  return 0;
}

void on_stopped(int /*signal*/, siginfo_t* info, void* data) {
  auto& context = *static_cast<ucontext_t*>(data);
  long result = -EPERM;
  switch (info->si_syscall) {
    case SYS_rt_sigprocmask:
      result = change_mask(context);
      break;
    case SYS_exit:
    case SYS_exit_group:
      tell_leaves(static_cast<int>(argument(context.uc_mcontext, 0) & 0xff));
      _exit(1);
    default:
      tell_denied(info->si_syscall);
  }
  set_result(context.uc_mcontext, result);
}

}  // namespace

void hear_of_stopped_calls(void (*denied)(int number), void (*leaves)(int code)) {
  tell_denied = denied;
  tell_leaves = leaves;
  struct sigaction action = {};
  action.sa_sigaction = on_stopped;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  sigaction(SIGSYS, &action, nullptr);
}

}  // namespace grader::sandbox
