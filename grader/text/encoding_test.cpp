// STAFF ONLY. Tests that encodings that compilers do not read are reported by their names.
#include "grader/text/encoding.h"

#include <gtest/gtest.h>

#include <string>

#include "solver/test_refusal.h"

namespace grader::inline text {
namespace {

using std::string;
using tests::says;

// This is a file as people write it, with a comment in another script.
const std::u32string kSource =
    U"// Löst A x = b. 解く。\n#include \"solver/linearSolver.h\"\nint f() { return 1; }\n";

string as_bytes(const std::u32string& text, std::size_t unit, bool little_endian) {
  string bytes;
  for (const char32_t letter : text)  // all within 16 bits
    for (std::size_t i = 0; i < unit; ++i) {
      const std::size_t place = little_endian ? i : unit - 1 - i;
      bytes += static_cast<char>(place < 4 ? letter >> (8 * place) & 0xff : 0);
    }
  return bytes;
}

TEST(Encoding, NamesUtf16AndUtf32) {
  for (const std::size_t unit : {2, 4})
    for (const bool little : {true, false})
      for (const bool mark : {true, false}) {
        const string name = "UTF-" + std::to_string(8 * unit), order = little ? "little" : "big";
        SCOPED_TRACE(name + " " + order + (mark ? " with a mark" : ""));
        const string bytes = as_bytes((mark ? U"\ufeff" : U"") + kSource, unit, little);
        const string begins = "x.cpp is " + name + " (" + order + "-endian)",
                     told = told_if_wide(bytes, "x.cpp");
        EXPECT_TRUE(told.starts_with(begins)) << told;
        EXPECT_TRUE(says(told, "Save it as UTF-8"));
        // This file was truncated.
        EXPECT_TRUE(told_if_wide(bytes.substr(0, bytes.size() - 1), "x.cpp").starts_with(begins));
      }
}

TEST(Encoding, TextIsText) {
  for (const string text : {"", "x", "int x;\r\n\tint y;\f\v\n", "// a line end of old\rint x;\r",
                            "// \xe0\xa0\x80 \xed\x9f\xbf \xf0\x90\x80\x80 \xf4\x8f\xbf\xbf\n",
                            "\xef\xbb\xbfint x;  // a mark, and Lösung\n", "// 解く \xf0\x9f\x99\x82\n"}) {
    EXPECT_EQ(told_if_wide(text, "x.cpp"), "");
    EXPECT_EQ(told_of_stray_byte(text, "x.cpp"), "");
  }
}

TEST(Encoding, TellsTheFirstStrayByte) {
  struct Stray {
    string bytes;
    int line, byte;
  };
  const Stray strays[] = {
      {"int x;\n\n// L\xf6sung\n", 3, 0xf6},            // Latin-1
      {"int x;\n\xe8\xa7", 2, 0xe8},                    // a truncated letter
      {"int \xc0\x80;", 1, 0xc0},                       // a NUL in two bytes
      {"// \xe0\x9f\xbf\n", 1, 0xe0},                   // a letter in a byte more than it needs
      {"// \xf0\x8f\xbf\xbf\n", 1, 0xf0},               // likewise
      {"// \xed\xa0\x80\n", 1, 0xed},                   // half a letter of UTF-16
      {"// \xf4\x90\x80\x80\n", 1, 0xf4},               // beyond the last letter
      {"int x;\n" + as_bytes(kSource, 2, true), 2, 0},  // as Windows' shell adds to a file
      {string("int x;\0\0\0\0\n", 11), 1, 0},           // a disk that was full
      {"int x;\n\x1a", 2, 0x1a},                        // the end of a file for DOS
      {"\x7f"
       "ELF\x02\x01\x01",
       1, 2}};
  for (const Stray& stray : strays) {
    EXPECT_EQ(told_if_wide(stray.bytes, "x.cpp"), "");
    const string told = told_of_stray_byte(stray.bytes, "x.cpp");
    EXPECT_TRUE(told.starts_with("x.cpp holds a byte in line " + std::to_string(stray.line) +
                                 " that is no text in UTF-8: " + std::to_string(stray.byte) + "."))
        << told;
  }
}

TEST(Encoding, ACodePageIsReadWholeOrNotAtAll) {
  EXPECT_EQ(from_code_page("L\xf6sung \x80", "CP1252"), "Lösung €");
  EXPECT_EQ(from_code_page("L\x94sung", "CP437"), "Lösung");
  EXPECT_EQ(from_code_page("\x89\xf0\x82\xad", "SHIFT_JIS"), "解く");
  EXPECT_EQ(from_code_page("", "CP1252"), "");
  EXPECT_EQ(from_code_page("a\x81", "CP1252"), std::nullopt) << "no letter";
  EXPECT_EQ(from_code_page("a\x89", "SHIFT_JIS"), std::nullopt) << "half a letter";
  EXPECT_EQ(from_code_page("a", "no such page"), std::nullopt);
}

}  // namespace
}  // namespace grader::text
