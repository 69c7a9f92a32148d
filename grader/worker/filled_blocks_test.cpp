// STAFF ONLY. Tests that the worker's new memory has the same content, whatever it held before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>

namespace {

bool is_filled(const void* memory, std::size_t from, std::size_t to) {
  const auto* bytes = static_cast<const unsigned char*>(memory);
  return std::all_of(bytes + from, bytes + to, [](unsigned char byte) { return byte == 0xfe; });
}

TEST(FilledBlocks, AreFilledHoweverMemoryIsTaken) {
  const std::function<void*(std::size_t)> ways[] = {
      [](std::size_t size) { return std::malloc(size); },
      [](std::size_t size) { return std::realloc(nullptr, size); },
      [](std::size_t size) { return std::aligned_alloc(64, size); },
      [](std::size_t size) {
        void* memory = nullptr;
        return posix_memalign(&memory, 64, size) == 0 ? memory : nullptr;
      }};
  for (const std::size_t size : {std::size_t{64}, std::size_t{4096}, std::size_t{1} << 19})
    for (const auto& take : ways)
      for (int again = 0; again < 3; ++again) {
        void* const memory = take(size);
        ASSERT_NE(memory, nullptr);
        EXPECT_TRUE(is_filled(memory, 0, size)) << size;
        std::memset(memory, 7, size);
        std::free(memory);
      }
}

// Large blocks come fresh from the kernel, also where one of that size was freed before.
TEST(FilledBlocks, HoldZerosWhereTheyAreLarge) {
  constexpr std::size_t kSize = std::size_t{4} << 20;
  for (int again = 0; again < 3; ++again) {
    auto* const memory = static_cast<unsigned char*>(std::malloc(kSize));
    ASSERT_NE(memory, nullptr);
    EXPECT_TRUE(std::all_of(memory, memory + kSize, [](unsigned char byte) { return byte == 0; }));
    std::memset(memory, 7, kSize);
    std::free(memory);
  }
}

TEST(FilledBlocks, GrowByWhatIsFilled) {
  for (int again = 0; again < 3; ++again) {
    for (const bool zero : {false, true}) {
      // For an odd size the C library gives more.
      void* memory = zero ? std::calloc(1, 101) : std::malloc(101);
      std::memset(memory, 7, 101);
      memory = std::realloc(memory, 103);
      memory = std::realloc(memory, 5000);
      EXPECT_TRUE(std::all_of(static_cast<char*>(memory), static_cast<char*>(memory) + 101,
                              [](char byte) { return byte == 7; }));
      EXPECT_TRUE(is_filled(memory, 101, 5000));
      std::memset(memory, 7, 5000);
      std::free(memory);
    }
  }
}

}  // namespace
