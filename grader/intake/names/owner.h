// STAFF ONLY. The owner of a hand-in, as the download names it. Letters are kept (NFC, UTF-8): it is for
// people, never a file's name.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

struct Owner {
  // "Jörg Müller-Lüdenscheidt", "müllerlüdenscheidtjörg" (Canvas), a group's name; "" if the layout has none.
  std::string name = {};
  // Comes from the system's names or tables: Canvas's user number, Moodle's participant number, Blackboard's
  // user name, Brightspace's number, Autolab's e-mail, a login (Classroom), Gradescope's sid; "" if the
  // layout has none.
  std::string id = {};
  std::string email = {};           // "" if the layout has none
  bool anonymous = false;           // `id` is a code in place of a person's
  bool group = false;               // one hand-in of several people
  std::vector<Owner> members = {};  // are a group's, if the layout lists them
};

}  // namespace grader::intake
