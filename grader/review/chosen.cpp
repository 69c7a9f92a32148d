// STAFF ONLY. Chooses items by words, kind, place and TA.
#include <algorithm>
#include <sstream>

#include "grader/review/items.h"
#include "grader/text/letters.h"

namespace grader::inline review {

std::vector<const Item*> chosen(const std::vector<Item>& items, const Choice& choice,
                                const std::vector<ClassLine>& people) {
  std::map<std::string, std::vector<const ClassLine*>> lines;
  for (const ClassLine& line : people) lines[line.hand_in].push_back(&line);
  const auto any_line = [&](const Item& item, const auto& holds) {
    return std::ranges::any_of(item.people, [&](const std::string& name) {
      const auto found = lines.find(name);
      return found != lines.end() && std::ranges::any_of(found->second, holds);
    });
  };
  const auto has = [&](const Item& item, const std::string& word) {
    const auto holds = [&](const std::string& text) { return lowered(text).find(word) != std::string::npos; };
    return holds(item.exercise + " " + item.titles) || std::ranges::any_of(item.categories, holds) ||
           std::ranges::any_of(item.people, holds) ||
           any_line(item, [&](const ClassLine* line) { return holds(line->name + " " + line->id); });
  };
  std::vector<std::string> words;
  std::istringstream text(lowered(choice.text));
  for (std::string word; text >> word;) words.push_back(word);
  std::vector<const Item*> found;
  for (const Item& item : items) {
    const auto in_section = [&](const ClassLine* line) { return line->section == choice.section; };
    if ((choice.kind && item.kind != *choice.kind) || (choice.undecided && item.is_decided()) ||
        (!choice.exercise.empty() && item.exercise != choice.exercise) ||
        (!choice.owner.empty() && item.owner != choice.owner) ||
        (!choice.section.empty() && !any_line(item, in_section)) ||
        !std::ranges::all_of(words, [&](const std::string& word) { return has(item, word); }))
      continue;
    found.push_back(&item);
  }
  if (choice.by_lost_points)
    std::ranges::stable_sort(found, [](const Item* a, const Item* b) { return comes_before(*a, *b, true); });
  return found;
}

}  // namespace grader::review
