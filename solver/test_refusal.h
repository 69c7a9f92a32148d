// STAFF ONLY. For tests: what a function or a program says, as when it refuses its input.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace tests {

// The message of the Error that the call throws; empty if it throws nothing. Other errors are the test's.
template <typename Error>
std::string refusal(const auto& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// True if the text has these words. A failing test shows both.
inline testing::AssertionResult says(const std::string& text, const std::string& words) {
  return testing::AssertionResult(text.find(words) != std::string::npos)
         << "\"" << words << "\" is looked for in: " << text;
}

}  // namespace tests
