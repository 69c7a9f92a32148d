#include "hair/io/fuzz/fuzz.h"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace fuzz {
namespace {

// Bytes that the present input uses. The sanitiser calls functions that can't take arguments from us.
std::ptrdiff_t in_use = 0, most_in_use = 0;

void on_allocation(const volatile void*, std::size_t size) {
  in_use += static_cast<std::ptrdiff_t>(size);
  most_in_use = std::max(most_in_use, in_use);
}

void on_release(const volatile void* memory) {
  if (memory) in_use -= static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(memory));
}

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : seeds())
    if (!(std::ofstream(folder / std::to_string(number++), std::ios::binary) << seed).flush()) {
      std::fprintf(stderr, "can't write seeds to %s\n", folder.c_str());
      std::exit(2);
    }
}

}  // namespace

void expect(bool kept, std::string_view promise) {
  if (kept) return;
  std::fprintf(stderr, "a broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

void expect_readable(std::string_view message) {
  expect(!message.empty() && std::all_of(message.begin(), message.end(),
                                         [](unsigned char c) { return c >= ' ' && c != 0x7f; }),
         "a message is one line without control characters");
}

}  // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** words) {
  if (*count == 3 && std::string_view((*words)[1]) == "--seeds") {
    fuzz::write_seeds((*words)[2]);
    std::exit(0);
  }
  __sanitizer_install_malloc_and_free_hooks(fuzz::on_allocation, fuzz::on_release);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::in_use = fuzz::most_in_use = 0;
  fuzz::try_input({reinterpret_cast<const char*>(data), size});
  if (fuzz::most_in_use > static_cast<std::ptrdiff_t>(fuzz::most_memory(size))) {
    std::fprintf(stderr, "%td bytes of memory for %zu bytes of input; at most %zu make sense\n",
                 fuzz::most_in_use, size, fuzz::most_memory(size));
    std::abort();
  }
  return 0;
}
