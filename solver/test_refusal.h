// STAFF ONLY. For tests: what a function says as it refuses its input.
#pragma once

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

}  // namespace tests
