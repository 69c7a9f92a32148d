// STAFF ONLY. For tests: the importers of learning systems, as their sources and documents describe them.
// Each rule names its line in the project's notes on formats (formats.md:35 is line 35).
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "grader/gradebook/filling.h"

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

// True if a line of the gradebook has these words.
inline bool says(const Gradebook& book, const std::string& words) {
  return std::ranges::any_of(book.said,
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

}  // namespace grader::gradebook
