// STAFF ONLY. Reports memory errors in the worker with sanitizers: their runtime calls these functions when
// it has found an error and before it prints anything. They send the error to the suite, and end the process.
//
// Nothing here allocates, for the heap may be in any state.
#include <pthread.h>
#include <unistd.h>

#include <span>

#include "grader/wire/channel.h"
#include "grader/wire/memory_error.h"
#include "grader/worker/request.h"

extern "C" {
const char* __asan_get_report_description();
void __ubsan_get_current_report_data(const char** kind, const char** message, const char** file,
                                     unsigned* line, unsigned* column, char** address);
}

namespace grader::inline worker {
namespace {

// The runtime's word for the error begins with its kind: "wild-addr-write", or "null-deref".
[[noreturn]] void tell(const char* what) {
  Channel channel(kIn, kOut);
  const std::optional<std::uint32_t> kind = memory_error_kind(what == nullptr ? "" : what);
  if (!kind) {  // memory or stack is used up
    channel.send(Kind::out_of_memory, current.nonce);
    _exit(0);
  }
  channel.send(Kind::memory_error, current.nonce, std::as_bytes(std::span(&*kind, 1)));
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

}  // namespace grader::worker

extern "C" {

// `symbolize`: no program can, and nobody reads the output. `malloc_context_size`: nobody asks where memory
// was allocated. `handle_abort`: an abort is no memory error. `malloc_fill_byte`: blocks have the content of
// those of solver/filled_blocks.cpp.
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
