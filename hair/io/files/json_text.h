// Writes JSON as text: single values, and objects and lists of such texts. json_text.cpp hides the JSON
// library, which is slow to compile.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace hair {

std::string json_text(double number);  // the shortest text that reads back the same; null if it is not finite
std::string json_text(long number);
inline std::string json_text(int number) {
  return json_text(static_cast<long>(number));
}
std::string json_text(const std::string& text);
inline std::string json_text(const char* text) {
  return json_text(std::string(text));
}
std::string json_text(const std::optional<std::string>& text);  // or null
std::string json_text(const std::vector<std::string>& texts);

struct JsonMember {
  std::string key, value;  // the value as JSON
};

std::string json_object(std::initializer_list<JsonMember> members);  // {"key":value,"key":value}
std::string json_list(std::initializer_list<std::string> values);    // [value,value]

}  // namespace hair
