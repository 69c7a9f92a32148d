// Wrong input from a user: one line with what is wrong, where, and what would be right. Programs print it and
// exit with code 2.
#pragma once

#include <stdexcept>

namespace hair {

class BadInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace hair
