// STAFF ONLY. For tests: changes every place of a struct's JSON in every way, and expects its reader to
// report it in one line.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "grader/course/input.h"

namespace grader::inline result {

// Reads a text that errors name "a.json".
using ReadText = std::function<void(const std::string& text)>;

inline std::string complaint_about(const std::string& text, const ReadText& read) {
  try {
    read(text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

inline void expect_one_line(const std::string& complaint, const std::string& about,
                            const std::string& change) {
  EXPECT_TRUE(complaint.starts_with("a.json: ")) << change << ": \"" << complaint << '"';
  EXPECT_NE(complaint.find(about), std::string::npos) << change << ": \"" << complaint << '"';
  for (const char c : complaint) EXPECT_TRUE(c >= ' ' && c <= '~') << change << ": \"" << complaint << '"';
  EXPECT_LT(complaint.size(), 600U) << change;
}

// `whole` is the JSON of a struct whose members all differ from their defaults. `may_be_missing` returns true
// for a place, such as "/scenes/0/parts/0/points/0/note", that a right text may lack.
inline void expect_each_field_checked(const nlohmann::json& whole, const ReadText& read,
                                      const std::function<bool(const std::string& place)>& may_be_missing) {
  using Json = nlohmann::json;
  using Place = Json::json_pointer;
  const std::function<void(const Place&)> visit = [&](const Place& place) {
    const Json& here = whole.at(place);
    const std::string name = place.to_string();
    if (!place.empty()) {
      const std::string key = place.back();
      // A text becomes a number, and any other value a text.
      Json other = whole;
      other[place] = here.is_string() ? Json(17) : Json("17");
      // An element of a list is named by its number.
      const bool element = whole.at(place.parent_pointer()).is_array();
      expect_one_line(complaint_about(other.dump(), read), element ? "[" + key + "]" : key,
                      name + " of another kind");
      if (!element && !may_be_missing(name)) {
        Json fewer = whole;
        fewer[place.parent_pointer()].erase(key);
        expect_one_line(complaint_about(fewer.dump(), read), "\"" + key + "\" is missing", name + " removed");
      }
    }
    if (here.is_object()) {
      Json more = whole;
      more[place]["hostile\n\x1b[31m"] = 1;
      expect_one_line(complaint_about(more.dump(), read), "hostile", name + " with one field more");
      for (const auto& item : here.items()) visit(place / item.key());
    }
    if (here.is_array())
      for (std::size_t i = 0; i < here.size(); ++i) visit(place / i);
  };
  visit(Place());
}

}  // namespace grader::result
