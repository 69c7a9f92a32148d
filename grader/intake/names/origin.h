// STAFF ONLY. An origin of a submission: the argument itself, or the class that held it. In a folder of
// grades no submission is replaced by one of another origin unless a person says so: the content of a hand-in
// must not reach other students' results.
//
// "hand-in /home/ta/alice.zip", "class /home/ta/class.zip", "class of a learning system /home/ta/export.zip"
#pragma once

#include <string>
#include <string_view>

namespace grader::inline intake {

inline constexpr std::string_view kHandIn = "hand-in", kClass = "class",
                                  kLearningSystem = "class of a learning system";

inline std::string origin_text(std::string_view kind, const std::string& absolute_path) {
  return std::string(kind) + " " + absolute_path;
}
inline bool is_of_a_class(std::string_view origin) {
  return origin.starts_with(kClass);
}

}  // namespace grader::intake
