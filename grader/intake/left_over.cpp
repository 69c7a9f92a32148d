// STAFF ONLY. Writes down which files of the input were left over.
#include "grader/intake/left_over.h"

#include <nlohmann/json.hpp>

namespace grader {

std::string left_over_json(const Intake& intake) {
  using Json = nlohmann::ordered_json;
  Json all = {{"left_over", Json::array()},
              {"older", Json::array()},
              {"made", Json::array()},
              {"notices", intake.notices}};
  for (const Accounted& file : intake.accounted) {
    const char* key = file.as == Accounted::As::left_over ? "left_over"
                      : file.as == Accounted::As::older   ? "older"
                      : file.as == Accounted::As::made    ? "made"
                                                          : nullptr;
    if (key) all[key].push_back({{"path", file.path}, {"reason", file.reason}, {"whose", file.whose}});
  }
  return all.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
