#include "hair/io/files/strict_json.h"

#include <gtest/gtest.h>

#include <string>

#include "hair/io/files/bad_input.h"

namespace hair {
namespace {

std::string complaint(const std::string& text) {
  try {
    parse_document(text, "a.json");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
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

}  // namespace
}  // namespace hair
