// STAFF ONLY. People as JSON (grader/result/fields.h): owners of hand-ins, and people on a roster.
#pragma once

#include "grader/intake/names/owner.h"
#include "grader/result/fields.h"
#include "grader/roster/person.h"

namespace grader {

template <>
struct Fields<Owner> {
  static const Rows<Owner>& rows();
};
template <>
struct Fields<Person> {
  static const Rows<Person>& rows();
};

}  // namespace grader
