// What a stub throws: a function that is not written yet names itself, rather than to return zeros that look
// plausible.
#pragma once

#include <stdexcept>
#include <string>

class NotImplemented : public std::logic_error {
 public:
  // `what` is the exercise's id and the function's name, as in "S1 ConjGrad".
  explicit NotImplemented(const std::string& what) : std::logic_error(what + " is not implemented yet") {}
};
