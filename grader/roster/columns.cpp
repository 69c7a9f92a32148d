// STAFF ONLY. Finds a roster's columns.
#include "grader/roster/columns.h"

#include <algorithm>
#include <cctype>

#include "grader/course/input.h"
#include "grader/roster/worksheet.h"
#include "grader/text/letters.h"

namespace grader::inline roster {
namespace {

using Titles = std::vector<const char*>;

// Canvas: Student, ID, SIS User ID, SIS Login ID, Section. Moodle: Identifier, Full name, First name, Last
// name, ID number, Email address, Groups. Gradescope: First Name, Last Name, SID, Email, Sections. Classroom:
// identifier, github_username, github_id, name. Brightspace: OrgDefinedId, Username, First Name, Last Name,
// Email. Canvas's export of a group set: name, canvas_user_id, user_id (the SIS one), login_id, sections,
// group_name.
const Titles kNames = {"Name", "Full name", "Student", "Student name"};
const Titles kFirstNames = {"First name", "FirstName", "Given name"};
const Titles kLastNames = {"Last name", "LastName", "Surname", "Family name"};
const Titles kSections = {"Section", "Sections", "Section name"};
// Moodle's groups may be sections or teams: its participants have no other column.
const Titles kGroups = {"group_name", "Group name", "Group", "Groups", "Team"};

const Titles& titles(IdKind kind) {
  static const std::array<Titles, kIdKinds> all = {
      Titles{"canvas_user_id", "ID", "SID", "Student ID", "User ID", "student_id", "user_id",
             "Matriculation number"},
      Titles{"SIS User ID", "SIS ID", "ID number", "sis_id", "sis_user_id"},
      Titles{"SIS Login ID", "Login ID", "Login", "Username", "User name", "login_id", "user_name"},
      Titles{"OrgDefinedId", "Org Defined ID"},
      Titles{"Identifier", "Participant", "Participant number"},
      Titles{"github_id", "GitHub ID"},
      Titles{"github_username", "GitHub username", "GitHub login", "GitHub"},
      Titles{"Email", "e-mail", "Email address", "Mail", "e-mail address"}};
  return all[static_cast<std::size_t>(kind)];
}

// Returns the first title that the table has; two of them would be two columns for one value.
std::size_t first_of(const Csv& table, const Titles& titles) {
  for (const char* title : titles)
    if (const std::size_t column = column_of(table, title); column != kNoColumn) return column;
  return kNoColumn;
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// True for "1.23457E+11", as a spreadsheet shows a long number.
bool is_shortened(const std::string& id) {
  const std::size_t e = id.find_first_of("eE");
  return e != id.npos && e > 0 && e + 2 < id.size() && id[e + 1] == '+' && is_digit(id[0]) &&
         id.find_first_not_of("0123456789.,", 0) == e &&
         std::all_of(id.begin() + static_cast<std::ptrdiff_t>(e) + 2, id.end(), is_digit);
}

// A spreadsheet's numbers have 15 digits, and zeros behind them.
constexpr std::size_t kKeptDigits = 15;
bool is_cut(const std::string& id) {
  return id.size() > kKeptDigits && std::ranges::all_of(id, is_digit) &&
         id.find_first_not_of('0', kKeptDigits) == id.npos;
}

std::string cell_of(const Csv::Row& row, std::size_t column) {
  const std::string cell = composed(row.at(column));
  return cell == "-" ? "" : cell;  // Moodle's empty cell
}

// Returns the number of "Participant 4711", in any language.
std::string trailing_number(const std::string& text) {
  std::size_t begin = text.size();
  while (begin > 0 && is_digit(text[begin - 1])) --begin;
  return text.substr(begin);
}

}  // namespace

RosterColumns::RosterColumns(const Csv& table) {
  for (std::size_t kind = 0; kind < kIdKinds; ++kind)
    ids_[kind] = first_of(table, titles(static_cast<IdKind>(kind)));
  name_ = first_of(table, kNames);
  first_name_ = first_of(table, kFirstNames);
  last_name_ = first_of(table, kLastNames);
  group_ = first_of(table, kGroups);
  section_ = first_of(table, kSections);
  if (section_ == kNoColumn) section_ = group_;
  std::size_t& sis = ids_[static_cast<std::size_t>(IdKind::sis)];
  if (sis == kNoColumn && column_of(table, "canvas_user_id") != kNoColumn) sis = column_of(table, "user_id");
  // Classroom's identifier is the teacher's own.
  std::size_t& participant = ids_[static_cast<std::size_t>(IdKind::participant)];
  std::size_t& id = ids_[static_cast<std::size_t>(IdKind::id)];
  if (ids_[static_cast<std::size_t>(IdKind::github_login)] != kNoColumn && participant != kNoColumn) {
    if (id == kNoColumn) id = participant;
    participant = kNoColumn;
  }
  if (participant == kNoColumn)
    if (const std::optional<Worksheet> sheet = worksheet_by_form(table)) {
      participant = sheet->identifier;
      if (id == participant) id = kNoColumn;
      name_ = sheet->name;
      std::size_t& email = ids_[static_cast<std::size_t>(IdKind::email)];
      if (email == kNoColumn) email = sheet->email;
    }
  const bool any_id = std::ranges::any_of(ids_, [](std::size_t column) { return column != kNoColumn; });
  if (!any_id && name_ == kNoColumn && last_name_ == kNoColumn)
    throw BadInput(place_of(table, table.rows.front()) +
                   ": no title is known; a roster needs one of \"id\", \"name\", \"email\", or the titles of "
                   "Canvas, Moodle, "
                   "Gradescope, GitHub Classroom or Brightspace");
}

std::optional<Person> RosterColumns::person(const Csv& table, const Csv::Row& row,
                                            std::vector<std::string>& said) const {
  Person person;
  person.line = row.line;
  person.section = cell_of(row, section_);
  person.group = cell_of(row, group_);
  for (std::size_t i = 0; i < kIdKinds; ++i) {
    const auto kind = static_cast<IdKind>(i);
    std::string id = plain_id(cell_of(row, ids_[i]));
    if (kind == IdKind::participant) id = trailing_number(id);
    if ((kind == IdKind::org_defined || kind == IdKind::login) && id.starts_with('#')) id.erase(0, 1);
    if (kind == IdKind::email || kind == IdKind::github_login) id = lowered(id);
    const bool cut = is_cut(id);
    if (cut || is_shortened(id)) {
      said.push_back(place_of(table, row) + ": " + title_of(kind) + " " + id +
                     (cut ? " has only zeros beyond its 15th digit" : " is a shortened number") +
                     ", as a spreadsheet leaves it; it finds nobody: export the table again");
      id.clear();
    }
    person.ids[i] = std::move(id);
  }
  person.name = cell_of(row, name_);
  const std::string first = cell_of(row, first_name_), last = cell_of(row, last_name_);
  if (person.name.empty()) person.name = composed(first + " " + last);
  person.keys = keys_of(last.empty() || first.empty() ? person.name : last + ", " + first);
  const bool anybody = std::ranges::any_of(person.ids, [](const std::string& id) { return !id.empty(); });
  if (person.name == "Points Possible" && person.id(IdKind::id).empty()) return {};
  if (!anybody && person.name.empty()) return {};
  return person;
}

}  // namespace grader::roster
