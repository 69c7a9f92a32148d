// STAFF ONLY. The way of proxies to the student's worker of the present run. See play.h.
#pragma once

#include "grader/wire/message.h"
#include "grader/wire/products.h"

namespace grader::inline judge {

MessageReader ask_student(const MessageWriter& request, const Products& products);
MessageReader ask_student(const MessageWriter& request);  // for functions that call nothing back

}  // namespace grader::judge
