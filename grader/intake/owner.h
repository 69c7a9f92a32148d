// STAFF ONLY. Whose a hand-in is, as the download says it. Letters are kept (NFC, UTF-8): it is for people,
// never a file's name.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

struct Owner {
  // "Jörg Müller-Lüdenscheidt", "müllerlüdenscheidtjörg" (Canvas), a group's name; "" where the layout has
  // none.
  std::string name = {};
  // As the system's names or tables carry it: Canvas's user number, Moodle's participant number, Blackboard's
  // user name, Brightspace's number, Autolab's e-mail, a login (Classroom), Gradescope's sid; "" where the
  // layout has none.
  std::string id = {};
  std::string email = {};           // "" where the layout has none
  bool anonymous = false;           // `id` is a code that stands for a person
  bool group = false;               // one hand-in of several people
  std::vector<Owner> members = {};  // of a group, where the layout says them
};

}  // namespace grader::intake
