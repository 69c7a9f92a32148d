// STAFF ONLY. Reads ids and names of a person.
#include "grader/roster/person.h"

#include <algorithm>

#include "grader/text/letters.h"

namespace grader::inline roster {

const char* title_of(IdKind kind) {
  constexpr std::array<const char*, kIdKinds> kTitles = {
      "id",        "SIS user id",  "login", "OrgDefinedId", "participant number",
      "GitHub id", "GitHub login", "e-mail"};
  return kTitles[static_cast<std::size_t>(kind)];
}

std::string plain_id(std::string_view cell) {
  std::string id = composed(without_unseen(cell));
  if (id.size() > 3 && id.starts_with("=\"") && id.ends_with('"')) id = composed(id.substr(2, id.size() - 3));
  if (id.find_first_not_of("0123456789., ") == id.npos) std::erase(id, ' ');
  const std::size_t digits = id.find_first_not_of("0123456789");
  const bool whole = digits != id.npos && digits > 0 && digits + 1 < id.size() &&
                     (id[digits] == '.' || id[digits] == ',') &&
                     id.find_first_not_of('0', digits + 1) == id.npos;
  return whole ? id.substr(0, digits) : id;
}

const std::string& Person::shown_id() const {
  const auto found = std::ranges::find_if(ids, [](const std::string& id) { return !id.empty(); });
  return found == ids.end() ? name : *found;
}

NameKeys keys_of(const std::string& name) {
  const auto key = [](const std::string& text) {
    std::string letters = squeezed(text);
    std::erase(letters, '_');  // Moodle writes a space for it, Canvas none
    return letters;
  };
  if (const std::size_t comma = name.find(','); comma != name.npos)
    return {key(name.substr(comma + 1) + name.substr(0, comma)), key(name)};
  const std::size_t blank = name.rfind(' ');
  return {key(name), blank == name.npos ? key(name) : key(name.substr(blank) + name.substr(0, blank))};
}

}  // namespace grader::roster
