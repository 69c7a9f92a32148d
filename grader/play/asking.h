// STAFF ONLY. What proxies ask through: the student's worker of the present play. See play.h.
#pragma once

#include <limits>

#include "grader/wire/message.h"
#include "grader/wire/products.h"

namespace grader {

MessageReader ask_student(const MessageWriter& request, const Products& products);
MessageReader ask_student(const MessageWriter& request);  // for functions that call nothing back

// The last of a reply: how many outputs overlapped an input, which no contract allows. A real object goes wrong at such a
// call, and one that is asked through a pipe does not. So where this is true, the results have to become NaN.
inline bool overlapped(MessageReader& reply) {
  const bool any = reply.get<int>() != 0;
  reply.expect_end();
  return any;
}
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace grader
