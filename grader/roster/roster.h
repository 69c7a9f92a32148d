// STAFF ONLY. The people of a class, from a table with a row for each, as Canvas (gradebook), Moodle
// (worksheet, participants), Gradescope, GitHub Classroom and Brightspace export them, or a plain one: id,
// name, e-mail, section, further ids. A spreadsheet may have written it again.
//
// People are found by ids, then by e-mail, then by a name that only one person has.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/names/owner.h"
#include "grader/roster/person.h"
#include "grader/text/csv.h"

namespace grader::inline roster {

class Roster {
 public:
  // Throws BadInput with the row: no column of ids, e-mails or names, nobody below the titles, an id that two
  // people have, two ids of one row that name different people.
  explicit Roster(const Csv& table);

  // Takes people of an earlier roster.
  explicit Roster(std::vector<Person> people);

  const std::vector<Person>& people() const { return people_; }
  const std::vector<std::string>& said() const {
    return said_;
  }  // for staff, a line each: guesses, and ids that a spreadsheet changed

  // Returns the person of this line of the table; several lines may be one person's.
  std::optional<std::size_t> at_line(std::size_t line) const;

  struct Match {
    std::optional<std::size_t> person;  // is a place in people()
    std::string told = {};              // for staff: an unusual way to find the person, or why not
    bool has_other_name = false;        // the id's person has another name on the roster
  };
  // `system` is the layout of the download, as --from takes it: it determines the ids of its hand-ins. A
  // group is nobody; its members may be somebody.
  Match find(const Owner& owner, const std::string& system) const;
  // Finds a hand-in's people, of a group its members; with a roster also by the ids that both tables have.
  // `told` gets the lines of all matches.
  std::vector<std::size_t> find_all(const Owner& owner, const std::string& system, const Roster* roster,
                                    std::vector<std::string>& told) const;
  // Returns the title of a column that finds the hand-ins of a download.
  static const char* column_for(const std::string& system);
  // Finds a person of another table, by the ids that both have.
  Match find(const Person& person) const;

 private:
  using Places = std::map<std::string, std::vector<std::size_t>, std::less<>>;

  void add(const Csv& table, const Csv::Row& row, Person person);
  void add(Person person);
  std::vector<std::size_t> with_id(IdKind kind, const std::string& id, std::string& told) const;

  std::vector<Person> people_;
  std::map<std::size_t, std::size_t> by_line_;
  std::vector<std::string> said_;
  std::array<Places, kIdKinds> by_id_, by_id_without_zeros_;
  Places by_spoken_, by_sorted_;
};

}  // namespace grader::roster
