// STAFF ONLY. Products with an object of the calling side: y = A x, of operator number `which`.
#pragma once

#include <functional>
#include <vector>

namespace grader::inline wire {

// Sets the size of y. Returns false to stop the request. Throws MalformedMessage for an unknown operator, or
// for another length of x.
using Products = std::function<bool(int which, const std::vector<double>& x, std::vector<double>& y)>;

}  // namespace grader::wire
