// For tests: the message with which a function refuses its input.
#pragma once

#include <string>

#include "hair/io/files/bad_input.h"

namespace hair {

// The message of the BadInput that the function throws; empty if it throws none.
std::string refusal(const auto& function) {
  try {
    function();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace hair
