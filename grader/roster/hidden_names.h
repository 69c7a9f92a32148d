// STAFF ONLY. Words that name people, and what stands in their place where grading is blind.
//
// It hides what the class's tables and the download say of a person: names, ids, addresses, the folder's
// name. It can't know what else students write of themselves, such as a nickname in a comment.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "grader/roster/class_list.h"

namespace grader::inline roster {

class HiddenNames {
 public:
  // Whoever is on the list without a hand-in becomes "somebody".
  HiddenNames(const std::vector<HandIn>& hand_ins, const std::optional<ClassList>& list);

  // In every line that staff reads: whole names and ids, and each single name of those whom it is about.
  std::string in(std::string_view text) const;
  // In what belongs to this hand-in.
  std::string in_own(std::string_view text, const std::string& hand_in) const;

 private:
  using Words = std::map<std::string, std::string>;  // in lower case; what stands in its place
  void add(const std::string& word, const std::string& code, Words& words);
  void add(const Owner& owner, const std::string& code);
  void add_parts(const std::string& name, const std::string& code);

  Words whole_;
  std::map<std::string, Words> own_;
};

}  // namespace grader::roster
