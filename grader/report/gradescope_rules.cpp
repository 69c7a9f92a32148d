// STAFF ONLY. Tests results.json against Gradescope's documents.
#include "grader/report/gradescope_rules.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "grader/report/results_json.h"

namespace grader::inline report {
namespace {

using nlohmann::json;
using Words = std::set<std::string>;
using Check = std::function<bool(const json&)>;

bool are_texts(const json& value) {
  return value.is_array() && std::ranges::all_of(value, &json::is_string);
}

Check one_of(const Words& words) {
  return [words](const json& value) { return value.is_string() && words.contains(value.get<std::string>()); };
}

const Check kFormat = one_of({"text", "html", "simple_format", "md", "ansi"});
const Check kVisibility = one_of({"hidden", "after_due_date", "after_published", "visible"});

using Keys = std::map<std::string, Check>;

const Keys kTop = {{"score", &json::is_number},      {"execution_time", &json::is_number},
                   {"output", &json::is_string},     {"output_format", kFormat},
                   {"test_output_format", kFormat},  {"test_name_format", kFormat},
                   {"visibility", kVisibility},      {"stdout_visibility", kVisibility},
                   {"extra_data", &json::is_object}, {"tests", &json::is_array}};

const Keys kTest = {
    {"score", &json::is_number},  {"max_score", &json::is_number}, {"status", one_of({"passed", "failed"})},
    {"name", &json::is_string},   {"name_format", kFormat},        {"number", &json::is_string},
    {"output", &json::is_string}, {"output_format", kFormat},      {"tags", are_texts},
    {"visibility", kVisibility},  {"extra_data", &json::is_object}};

class Rules {
 public:
  void ask(bool holds, const std::string& rule) {
    if (!holds) broken.push_back(rule);
  }

  void ask_keys(const json& object, const Keys& keys, const std::string& where) {
    ask(object.is_object(), "specs.md: " + where + " is an object");
    if (!object.is_object()) return;
    for (const auto& [key, value] : object.items()) {
      const auto known = keys.find(key);
      ask(known != keys.end(), "specs.md: " + where + " has no " + key);
      if (known != keys.end())
        ask(known->second(value), "specs.md: " + where + ": " + key + " is no such value");
    }
  }

  std::vector<std::string> broken;
};

double number_or_0(const json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_number() ? object[key].get<double>()
                                                                               : 0;
}

std::string text_of(const json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_string()
             ? object[key].get<std::string>()
             : "";
}

// Allows elements that the platform's filter of HTML is likely to leave: paragraphs, and embedded pictures.
bool is_plain_html(const std::string& text) {
  const std::string picture = "<img width=\"240\" alt=\"", source = "\" src=\"data:image/png;base64,";
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = std::string_view(text).substr(at);
    if (rest.starts_with("<p>") || rest.starts_with("</p>")) continue;
    if (!rest.starts_with(picture) || rest.substr(0, rest.find('>')).find(source) == std::string_view::npos)
      return false;
  }
  return true;
}

void ask_test(Rules& rules, const json& test, const std::string& where) {
  rules.ask_keys(test, kTest, where);
  rules.ask(text_of(test, "visibility") == "visible" || !test.contains("visibility"),
            "specs.md: a test that is not visible hides the student's total: " + where);
  rules.ask(number_or_0(test, "score") >= 0 && number_or_0(test, "score") <= number_or_0(test, "max_score"),
            "ours: " + where + " has between none and all of its points");
  if (text_of(test, "output_format") == "html")
    rules.ask(is_plain_html(text_of(test, "output")), "specs.md: HTML is filtered: " + where);
}

}  // namespace

std::vector<std::string> broken_rules(const std::string& text) {
  Rules rules;
  rules.ask(text.size() <= kMostResultsBytes, "ours: it has a bound");
  rules.ask(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }),
            "ours: it is ASCII, with lines that end with \\n alone");
  const json all = json::parse(text, nullptr, false);
  rules.ask(!all.is_discarded(), "specs.md: it is JSON");
  if (!all.is_object()) return rules.broken;
  rules.ask_keys(all, kTop, "the whole");
  rules.ask(all.contains("score") || all.contains("tests"), "specs.md: score or tests are there");
  rules.ask(text_of(all, "visibility") == "visible" || !all.contains("visibility"),
            "specs.md: results that are not visible hide the student's total");
  rules.ask(text_of(all, "stdout_visibility") == "hidden",
            "ours: students don't see what the grader prints, which staff see by specs.md's default");
  double sum = 0;
  std::size_t count = 0;
  if (all.contains("tests") && all["tests"].is_array())
    for (const json& test : all["tests"]) {
      ask_test(rules, test, "tests[" + std::to_string(count++) + "]");
      sum += number_or_0(test, "score");
    }
  // Points are rounded to four decimals.
  rules.ask(std::abs(number_or_0(all, "score") - sum) <= 0.5e-4 * (static_cast<double>(count) + 1) ||
                !all.contains("score"),
            "specs.md: score, which counts, is the tests' sum");
  return rules.broken;
}

}  // namespace grader::report
