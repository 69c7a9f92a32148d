// STAFF ONLY. Names of people, and their replacements in blind grading.
//
// It hides people's data in the class's tables and the download: names, ids, addresses, the folder's name. It
// can't know other names that students write, such as a nickname in a comment.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "grader/roster/class_list.h"

namespace grader::inline roster {

class HiddenNames {
 public:
  // A person on the list without a hand-in becomes "somebody".
  HiddenNames(const std::vector<HandIn>& hand_ins, const std::optional<ClassList>& list);

  // Changes a line that staff read: whole names and ids, and each single name of the people in the line.
  std::string in(std::string_view text) const;
  // Changes a text of this hand-in.
  std::string in_own(std::string_view text, const std::string& hand_in) const;

 private:
  using Words = std::map<std::string, std::string>;  // map words in lower case to replacements
  void add(const std::string& word, const std::string& code, Words& words);
  void add(const Owner& owner, const std::string& code);
  void add_parts(const std::string& name, const std::string& code);

  Words whole_;
  std::map<std::string, Words> own_;
};

}  // namespace grader::roster
