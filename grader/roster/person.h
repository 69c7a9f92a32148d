// STAFF ONLY. A person on a roster.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grader::inline roster {

// Ids of one kind are compared with each other alone: Moodle's participant 4711 is not Canvas's user 4711.
enum class IdKind { id, sis, login, org_defined, participant, github_id, github_login, email };
inline constexpr std::size_t kIdKinds = 8;

const char* title_of(IdKind kind);  // for messages: "SIS user id"

// Returns an id in its one form for comparisons: without invisible letters, and as it was before a
// spreadsheet wrote 1001.0 or ="1001".
std::string plain_id(std::string_view cell);

// Names are compared as letters and digits in lower case. Canvas names files by "Doe, Jane", other systems by
// "Jane Doe".
struct NameKeys {
  std::string as_spoken, as_sorted;  // "janedoe", "doejane"
  bool operator==(const NameKeys&) const = default;
};

// Reads "Doe, Jane" or "Jane Doe"; without a comma the last word is the family name.
NameKeys keys_of(const std::string& name);

struct Person {
  std::string name;        // is for people, NFC; as in the table, or "First Last" of two columns
  std::string section;     // "" or several, as the table writes them
  std::string group = {};  // likewise: people who hand in together
  std::array<std::string, kIdKinds> ids{};  // "" if the table has none
  NameKeys keys{};                          // compare the name
  std::size_t line = 0;                     // is the table's

  const std::string& id(IdKind kind) const { return ids[static_cast<std::size_t>(kind)]; }
  std::string& id(IdKind kind) { return ids[static_cast<std::size_t>(kind)]; }
  const std::string& email() const { return id(IdKind::email); }
  // Returns a word for the person in lists of ids: the first id that exists, or else the name.
  const std::string& shown_id() const;
};

}  // namespace grader::roster
