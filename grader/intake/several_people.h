// STAFF ONLY. A hand-in of one student can look like a class: it holds folders with the names of others. What it holds decides nothing
// then: the caller's word does, or a download's names, which a student can't give to a hand-in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

struct Arguments {
  bool several = false;  // then each is a hand-in of one student
  bool classes = false;  // somebody says that each may be a class
  bool may_be_class() const { return classes || !several; }
};

// Inputs that look like a class.
struct Crowd {
  std::vector<std::string> names;  // of its submissions
  bool of_a_system = false;        // they are in a learning system's download
};

// Why an argument of this name is no class, as a part of a sentence for staff. Empty: it is one.
std::string why_no_class(const Crowd& crowd, std::string_view name, const Arguments& arguments);

}  // namespace grader
