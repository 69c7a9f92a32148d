#include "hair/io/files/printable.h"

#include <gtest/gtest.h>

#include <string>

namespace hair {
namespace {

TEST(Printable, PlainNamesStay) {
  EXPECT_EQ(printable("alice/conj_grad.cpp"), "alice/conj_grad.cpp");
}

TEST(Printable, EveryByteBecomesPlainAscii) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  for (const char c : printable(all, 256)) {
    EXPECT_TRUE(c >= 0x20 && c < 0x7f) << static_cast<int>(c);
  }
  EXPECT_EQ(printable(std::string("\x1b[2J\0\n", 6)), "\\x1b[2J\\x00\\x0a");
}

TEST(Printable, DifferentNamesNeverLookTheSame) {
  EXPECT_NE(printable("\x1b"), printable("\\x1b"));
}

TEST(Printable, LongTextIsCut) {
  EXPECT_EQ(printable("abcdef", 3), "abc...");
}

}  // namespace
}  // namespace hair
