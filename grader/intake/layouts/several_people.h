// STAFF ONLY. Recognises a hand-in of one student that looks like a class: it holds folders with other names,
// or a learning system's names. Then its content must not decide: it is a class only if the caller says so,
// or if it is the only argument and its own name is no hand-in's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader::inline intake {

struct Arguments {
  bool several = false;  // each argument is then one student's hand-in
  bool classes = false;  // the caller says that each may be a class
  bool may_be_class() const { return classes || !several; }
};

// Returns why an argument of this name, which holds submissions of these names, is no class: a part of a
// sentence for staff, which kSaysClass ends. Empty: it is a class.
std::string why_no_class(const std::vector<std::string>& names, std::string_view name,
                         const Arguments& arguments);

}  // namespace grader::intake
