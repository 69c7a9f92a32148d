// STAFF ONLY. Writes a list of the input's files that were left over.
#include <nlohmann/json.hpp>
#include <set>

#include "grader/intake/submission.h"

namespace grader::inline intake {

std::string line_about(const Accounted& left_over) {
  return left_over.path + ": was not graded, since it " + left_over.reason;
}

std::vector<Accounted> listed(const Intake& intake) {
  std::vector<Accounted> all;
  std::set<std::string> said;
  for (const Accounted& file : intake.accounted) {
    if (file.as == Accounted::As::left_over) said.insert(line_about(file));
    if (file.as != Accounted::As::hand_in) all.push_back(file);
  }
  for (const std::string& notice : intake.notices) {
    if (said.contains(notice)) continue;
    const auto whose = intake.whose_notice.find(notice);
    all.push_back(
        {"", Accounted::As::notice, notice, whose == intake.whose_notice.end() ? "" : whose->second});
  }
  return all;
}

std::string left_over_json(const std::vector<Accounted>& listed) {
  using Json = nlohmann::ordered_json;
  using enum Accounted::As;
  Json all = Json::object();
  for (const Accounted::As as : {left_over, older, made}) {
    Json& files = all[to_string(as)] = Json::array();
    for (const Accounted& file : listed)
      if (file.as == as)
        files.push_back({{"path", file.path}, {"reason", file.reason}, {"whose", file.whose}});
  }
  Json& notices = all["notices"] = Json::array();
  for (const Accounted& file : listed)
    if (file.as == left_over || file.as == notice)
      notices.push_back(file.as == notice ? file.reason : line_about(file));
  return all.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader::intake
