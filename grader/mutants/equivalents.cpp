// STAFF ONLY. Reads an exercise's list of mutants that are right programs.
#include "grader/mutants/equivalents.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace grader::inline mutants {

bool Equivalent::is(const std::string& source, const Mutation& mutation) const {
  return change == change_of(source, mutation) && line == line_of(source, mutation) &&
         occurrence == occurrence_of(source, mutation);
}

std::vector<Equivalent> equivalents_of(const std::string& exercise, const std::filesystem::path& project) {
  std::vector<Equivalent> all;
  std::ifstream file(project / "reference" / exercise / "equivalents.json");
  if (!file) return all;
  for (const nlohmann::json& entry : nlohmann::json::parse(file))
    all.push_back({entry.at("line"), entry.at("change"), entry.at("why"), entry.value("occurrence", 1),
                   entry.value("undefined", false)});
  return all;
}

}  // namespace grader::mutants
