// STAFF ONLY. A hand-in of one student can look like a class: it holds folders with the names of others. What it holds decides nothing
// then: the caller's word does, or a download's names, which a student can't give to a hand-in.
#pragma once

#include <string>
#include <string_view>

#include "grader/intake/layout.h"

namespace grader {

// Every member of the class is named as learning systems do.
bool has_names_of_a_learning_system(const Layout& layout);

struct Arguments {
  bool several = false;  // then each is a hand-in of one student
  bool classes = false;  // somebody says that each may be a class
  bool may_be_class() const { return classes || !several; }
};

// Why an argument of this name is no class, as a part of a sentence for staff. Empty: its layout stands.
std::string why_no_class(const Layout& layout, std::string_view name, const Arguments& arguments);

}  // namespace grader
