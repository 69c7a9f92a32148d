#include "hair/io/files/json_text.h"

#include <nlohmann/json.hpp>

namespace hair {

std::string json_text(double number) {
  return nlohmann::json(number).dump();
}

std::string json_text(long number) {
  return nlohmann::json(number).dump();
}

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump();
}

std::string json_text(const std::optional<std::string>& text) {
  return text ? json_text(*text) : "null";
}

std::string json_text(const std::vector<std::string>& texts) {
  return nlohmann::json(texts).dump();
}

std::string json_object(std::initializer_list<JsonMember> members) {
  std::string text;
  for (const JsonMember& one : members)
    text += (text.empty() ? "" : ",") + json_text(one.key) + ":" + one.value;
  return "{" + text + "}";
}

std::string json_list(std::initializer_list<std::string> values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
  return "[" + text + "]";
}

}  // namespace hair
