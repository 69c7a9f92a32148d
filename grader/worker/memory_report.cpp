// STAFF ONLY. What the worker with sanitizers adds to the other one: the sanitizers' runtime calls these
// functions when it has found an error and before it prints anything. They tell the suite, and end the process.
//
// Nothing here allocates, for the heap may be in any state.
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>
#include <unwind.h>

#include <array>
#include <cstring>

#include "grader/wire/channel.h"
#include "grader/wire/memory_error.h"
#include "grader/worker/request.h"

extern "C" {
const char* __asan_get_report_description();
void __ubsan_get_current_report_data(const char** kind, const char** message, const char** file,
                                     unsigned* line, unsigned* column, char** address);
}

namespace grader {
namespace {

struct Report {
  std::uint32_t kind = 0, frames = 0;
  std::array<std::uint64_t, kMostFrames> offsets{};
};

_Unwind_Reason_Code add_frame(_Unwind_Context* context, void* data) {
  auto& report = *static_cast<Report*>(data);
  int before = 0;  // the address is that of the instruction itself, and not of the one behind a call
  const std::uintptr_t address = _Unwind_GetIPInfo(context, &before);
  Dl_info found{};
  void* const pointer =
      reinterpret_cast<void*>(address);  // NOLINT(performance-no-int-to-ptr): it comes as a number
  if (dladdr(pointer, &found) != 0 && std::strcmp(found.dli_fname, current.object) == 0)
    report.offsets[report.frames++] =
        address - reinterpret_cast<std::uintptr_t>(found.dli_fbase) - (before == 0 ? 1 : 0);
  return report.frames < kMostFrames ? _URC_NO_REASON : _URC_END_OF_STACK;
}

// The runtime's word for the error begins with its kind: "wild-addr-write", or "null-deref".
[[noreturn]] void tell(const char* what) {
  Channel channel(kIn, kOut);
  const std::optional<std::uint32_t> kind = memory_error_kind(what == nullptr ? "" : what);
  if (!kind) {  // memory or stack is used up
    channel.send(Kind::out_of_memory, current.nonce);
    _exit(0);
  }
  Report report{*kind, 0, {}};
  _Unwind_Backtrace(add_frame, &report);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(&report, 1));
  channel.send(Kind::memory_error, current.nonce,
               bytes.first(offsetof(Report, offsets) + report.frames * sizeof(std::uint64_t)));
  _exit(0);
}

}  // namespace

void run_on_known_stack(void (*run)()) {
  // Frames are larger with sanitizers.
  constexpr std::size_t kStack = std::size_t{64} << 20;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_t thread{};
  const auto start = [](void* function) -> void* {
    reinterpret_cast<void (*)()>(function)();
    return nullptr;
  };
  if (pthread_create(&thread, &attributes, start, reinterpret_cast<void*>(run)) != 0) _exit(120);
  pthread_join(thread, nullptr);
  _exit(0);
}

}  // namespace grader

extern "C" {

// `symbolize`: there is nobody who could, and what is printed is not read. `malloc_context_size`: nor is it asked who
// allocated. `handle_abort`: an abort is no memory error. `malloc_fill_byte`: blocks hold
// what those of allocations.cpp do.
__attribute__((visibility("default"))) const char* __asan_default_options() {
  return "detect_leaks=0:symbolize=0:malloc_context_size=0:quarantine_size_mb=16:allocator_may_return_null=1:"
         "detect_odr_violation=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0:"
         "malloc_fill_byte=254:max_malloc_fill_size=2147483647";
}
__attribute__((visibility("default"))) const char* __ubsan_default_options() {
  return "symbolize=0:halt_on_error=1";
}

__attribute__((visibility("default"))) void __asan_on_error() {
  grader::tell(__asan_get_report_description());
}

__attribute__((visibility("default"))) void __ubsan_on_report() {
  const char *kind = nullptr, *message = nullptr, *file = nullptr;
  unsigned line = 0, column = 0;
  char* address = nullptr;
  __ubsan_get_current_report_data(&kind, &message, &file, &line, &column, &address);
  grader::tell(kind);
}
}
