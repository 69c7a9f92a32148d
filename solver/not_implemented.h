// The exception that a stub throws: an unwritten function names itself instead of returning zeros that look
// plausible.
#pragma once

#include <stdexcept>
#include <string>

class NotImplemented : public std::logic_error {
 public:
  // `what` is the exercise's id and the function's name, as in "S1 ConjGrad".
  explicit NotImplemented(const std::string& what) : std::logic_error(what + " is not implemented yet") {}
};
