// STAFF ONLY. The importers of learning systems, as their sources and documents describe them, for tests.
// Each rule names its line in the project's notes on formats (formats.md:35 is line 35).
#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader::inline gradebook {

struct Imported {
  std::map<std::string, std::string>
      scores{};  // by the system's id: what it holds after the import, of those that change
  std::vector<std::string> refused{};          // rules that are broken
  std::vector<std::string> new_assignments{};  // that an importer would offer to make
  std::vector<std::string> new_people{};
};

// `exported` is what Canvas wrote: its columns and people are what it knows.
Imported import_into_canvas(const std::string& csv, const std::string& exported,
                            const std::string& assignment);

// `participants`: those that Moodle knows, with the grade that it has.
Imported import_into_moodle(const std::string& csv, const std::map<std::string, std::string>& participants,
                            bool decimal_comma);

Imported import_into_brightspace(const std::string& csv, const std::vector<std::string>& items);

Imported import_into_autolab(const std::string& csv, std::size_t problems);

}  // namespace grader::gradebook
