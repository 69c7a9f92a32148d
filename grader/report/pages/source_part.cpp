// STAFF ONLY. Finds the line of each message: the compiler names it; the linker and the search for memory
// errors name a function, which stands first where it is defined or called.
#include "grader/report/pages/pages.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>
#include <vector>

namespace grader::inline report {
namespace {

using hair::html, hair::Html;

constexpr std::size_t kLongest = 40;  // longer files are folded

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Maps a line's place, from 0, to messages.
using AtLines = std::map<std::size_t, std::vector<std::string>>;

// Returns the text between `begin` and `end`; empty if they are not there.
std::string between(const std::string& text, const std::string& begin, char end) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return {};
  const std::string rest = text.substr(at + begin.size());
  return rest.substr(0, rest.find(end));
}

AtLines messages_of(const ExerciseResult& exercise, const std::vector<std::string>& lines) {
  AtLines all;
  for (const std::string& message : lines_of(exercise.compiler_messages + "\n" + exercise.staff_log)) {
    std::size_t number = 0;
    if (const std::string file = exercise.file + ":"; message.starts_with(file))
      std::from_chars(message.data() + file.size(), message.data() + message.size(), number);
    if (number > 0 && number <= lines.size()) {
      std::vector<std::string>& there = all[number - 1];
      if (std::ranges::count(there, message) == 0) there.push_back(message);
    } else if (const std::string name = between(message, "undefined reference to ", '('); name.size() > 1) {
      const std::string call = name.substr(name.find_last_of("`':") + 1) + "(";
      const auto line =
          std::ranges::find_if(lines, [&](const std::string& one) { return one.find(call) != one.npos; });
      if (line != lines.end()) all[static_cast<std::size_t>(line - lines.begin())].push_back(message);
    }
  }
  return all;
}

}  // namespace

Html source_part(const ExerciseResult& exercise) {
  if (exercise.source.empty()) return {};
  const std::vector<std::string> lines = lines_of(exercise.source);
  const AtLines messages = messages_of(exercise, lines);
  Html text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    text +=
        html("{} {}\n", {std::string(5 - std::min<std::size_t>(5, number.size()), ' ') + number, lines[i]});
    if (const auto here = messages.find(i); here != messages.end())
      for (const std::string& message : here->second) text += html("<mark>      {}</mark>\n", {message});
  }
  std::string said;
  for (const auto& [line, all] : messages)
    said += (said.empty() ? "; messages at " : ", ") + std::to_string(line + 1);
  return html(
      "<details{}><summary>{}, {} lines{}</summary>\n<pre>{}</pre></details>\n",
      {lines.size() <= kLongest ? html(" open=\"\"") : Html(), exercise.file, lines.size(), said, text});
}

}  // namespace grader::report
