#include "hair/io/files/strict_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

std::string complaint(const std::string& text) {
  return tests::refusal<BadInput>([&] { parse_document(text, "a.json"); });
}

TEST(StrictJson, WhatAMessageQuotesIsPrintable) {
  EXPECT_EQ(complaint("[\"a\x7f\x1b"),
            "a.json: line 1, column 5: not JSON: syntax error while parsing value - invalid string: control "
            "character U+001B (ESC) must be escaped to \\u001B; last read: '\"a\\x7f<U+001B>'");
  EXPECT_EQ(complaint("\x7f{"),
            "a.json: line 1, column 1: not JSON: syntax error while parsing value - invalid literal; last "
            "read: '\\x7f'");
}

TEST(StrictJson, WhatAMessageQuotesIsCut) {
  EXPECT_LT(complaint("[\"" + std::string(100'000, 'a')).size(), 500U);
  EXPECT_LT(complaint("[" + std::string(100'000, '1') + "]").size(), 500U);
}

// The library takes a byte 0 for the end of the text.
TEST(StrictJson, AByte0IsNotTheEnd) {
  EXPECT_EQ(complaint(std::string("{}\n\0{", 5)), "a.json: line 2, column 1: not JSON: a byte 0; remove it");
  EXPECT_EQ(complaint(std::string("{}\0", 3)), "a.json: line 1, column 3: not JSON: a byte 0; remove it");
  const JsonDocument text = parse_document(R"(["a\u0000b", "ab"])", "a.json");
  const std::vector<JsonValue> items = JsonValue(*text, "a.json").items();
  EXPECT_THROW(items[0].text(), BadInput);
  EXPECT_EQ(items[0].any_text(), std::string("a\0b", 3)) << "what a stranger's program printed";
  EXPECT_EQ(items[1].text(), "ab");
}

TEST(StrictJson, WholeNumbersAreTakenAsTheyAreOrRefused) {
  const auto whole = [](const std::string& text, long highest) -> std::optional<long> {
    const JsonDocument document = parse_document(text, "a.json");
    try {
      return JsonValue(*document, "a.json").whole_number(-10, highest);
    } catch (const BadInput&) {
      return {};
    }
  };
  constexpr long k53 = 1L << 53, kMost = std::numeric_limits<long>::max();
  EXPECT_EQ(whole("9007199254740992", k53), k53);
  EXPECT_EQ(whole("9007199254740993", k53), std::nullopt);
  EXPECT_EQ(whole("9007199254740993", kMost), k53 + 1);
  EXPECT_EQ(whole("9007199254740993.0", kMost), std::nullopt);
  EXPECT_EQ(whole("9223372036854775807", kMost), kMost);
  EXPECT_EQ(whole("9223372036854775808", kMost), std::nullopt);
  EXPECT_EQ(whole("-10", 300), -10);
  EXPECT_EQ(whole("-11", 300), std::nullopt);
  EXPECT_EQ(whole("3e2", 300), 300);
  EXPECT_EQ(whole("3.5", 300), std::nullopt);
  EXPECT_EQ(whole("\"3\"", 300), std::nullopt);
}

}  // namespace
}  // namespace hair
