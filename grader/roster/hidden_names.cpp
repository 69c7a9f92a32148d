// STAFF ONLY. Hides names.
#include "grader/roster/hidden_names.h"

#include <algorithm>

#include "grader/intake/names/exercise_names.h"
#include "grader/text/letters.h"

namespace grader::inline roster {
namespace {

constexpr std::size_t kShortest = 3;  // bytes; shorter names are not hidden

bool in_a_word(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
         (byte >= 'A' && byte <= 'Z');
}

// Replaces the longest word at each place that begins and ends at a word's limits.
std::string replaced(std::string_view text, const std::map<std::string, std::string>& words) {
  if (words.empty()) return std::string(text);
  const std::string lower = in_lower_case(text);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::pair<const std::string, std::string>* best = nullptr;
    if (in_a_word(text[at]) && (at == 0 || !in_a_word(text[at - 1]))) {
      const std::string first(1, lower[at]);
      for (auto word = words.lower_bound(first); word != words.end() && word->first[0] == lower[at]; ++word) {
        const std::size_t end = at + word->first.size();
        if (lower.compare(at, word->first.size(), word->first) != 0) continue;
        if (end < text.size() && in_a_word(text[end]) && in_a_word(text[end - 1])) continue;
        if (!best || best->first.size() < word->first.size()) best = &*word;
      }
    }
    if (best) {
      result += best->second;
      at += best->first.size();
    } else {
      result += text[at++];
    }
  }
  return result;
}

}  // namespace

void HiddenNames::add(const std::string& word, const std::string& code, Words& words) {
  if (word.size() >= kShortest && word != code) words.try_emplace(in_lower_case(word), code);
}

void HiddenNames::add_parts(const std::string& name, const std::string& code) {
  std::string part;
  for (const char c : name + " ") {
    if (in_a_word(c)) {
      part += c;
      continue;
    }
    for (const std::string& spelling : {part, without_marks(part)}) add(spelling, code, own_[code]);
    part.clear();
  }
}

void HiddenNames::add(const Owner& owner, const std::string& code) {
  const std::string name = composed(owner.name);
  std::string turned = name;  // is "Jane Doe" for "Doe, Jane"
  if (const std::size_t comma = name.find(", "); comma != name.npos)
    turned = name.substr(comma + 2) + " " + name.substr(0, comma);
  for (const std::string& word : {name, turned, owner.id, owner.email}) {
    std::string joined = word;
    std::ranges::replace(joined, ' ', '_');
    for (const std::string& spelling : {word, without_marks(word), squeezed(word), joined})
      add(spelling, code, whole_);
  }
  add_parts(name, code);
  for (const Owner& member : owner.members) add(member, code);
}

HiddenNames::HiddenNames(const std::vector<HandIn>& hand_ins, const std::optional<ClassList>& list) {
  for (const HandIn& hand_in : hand_ins) {
    add(hand_in.owner, hand_in.name);
    add(hand_in.known_as, hand_in.name, whole_);
    add_parts(hand_in.known_as, hand_in.name);
  }
  if (!list) return;
  for (const ClassList::Row& row : list->rows) {
    const std::string code = row.hand_ins.empty() ? "somebody" : row.hand_ins.front();
    add(Owner{.name = row.person.name}, code);
    for (const std::string& id : row.person.ids) add(id, code, whole_);
  }
}

std::string HiddenNames::in(std::string_view text) const {
  std::string line = replaced(text, whole_);
  for (const auto& [code, words] : own_)
    if (line.find(code) != line.npos) line = replaced(line, words);
  return line;
}

std::string HiddenNames::in_own(std::string_view text, const std::string& hand_in) const {
  const auto own = own_.find(hand_in);
  const std::string without = in(text);
  return own == own_.end() ? without : replaced(without, own->second);
}

}  // namespace grader::roster
