// STAFF ONLY. A hand-in of one student can look like a class: it holds folders with the names of others, or a
// learning system's names. Then the content decides nothing: the caller's word does, or that it is alone and
// its own name is no hand-in's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader::inline intake {

struct Arguments {
  bool several = false;  // then each is a hand-in of one student
  bool classes = false;  // the caller says that each may be a class
  bool may_be_class() const { return classes || !several; }
};

// Why an argument of this name, with submissions of these names in it, is no class: a part of a sentence for
// staff, which kSaysClass ends. Empty: it is one.
std::string why_no_class(const std::vector<std::string>& names, std::string_view name,
                         const Arguments& arguments);

}  // namespace grader::intake
