// STAFF ONLY. The importers of learning systems, as their sources and documents describe them, for tests.
// Each rule names its line in the project's notes on formats (formats.md:35 is line 35).
#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader::inline gradebook {

struct Imported {
  std::map<std::string, std::string> scores{};  // by the system's id: the changed values after the import
  std::vector<std::string> refused{};           // are broken rules
  std::vector<std::string> new_assignments{};   // would be made by the importer, after a question
  std::vector<std::string> new_people{};
};

// `exported` is Canvas's own export, with its columns and people.
Imported import_into_canvas(const std::string& csv, const std::string& exported,
                            const std::string& assignment);

// `participants` are those in Moodle, with their present grades.
Imported import_into_moodle(const std::string& csv, const std::map<std::string, std::string>& participants,
                            bool decimal_comma);

Imported import_into_brightspace(const std::string& csv, const std::vector<std::string>& items);

Imported import_into_autolab(const std::string& csv, std::size_t problems);

}  // namespace grader::gradebook
