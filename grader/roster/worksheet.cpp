// STAFF ONLY. Finds the columns of Moodle's worksheet.
#include "grader/roster/worksheet.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string_view>

#include "grader/text/letters.h"

namespace grader::inline roster {
namespace {

// Grades can be changed, and two dates: they follow the maximum.
constexpr std::size_t kBehindMaximum = 3;
// A blind worksheet without comments has identifier, status, grade, maximum, and these.
constexpr std::size_t kFewest = 4 + kBehindMaximum;

constexpr auto kNo = std::to_array<std::string_view>(
    {"no",  "nein", "non", "não", "nee",   "nej", "nei",    "ei",     "nie",    "ne", "nem", "nu",
     "нет", "ні",   "не",  "όχι", "hayır", "否",  "いいえ", "아니오", "아니요", "לא", "لا"});
constexpr auto kYes = std::to_array<std::string_view>(
    {"yes",  "ja", "oui", "sí",  "si",   "sì", "sim",  "kyllä", "tak", "ano", "áno", "da",
     "igen", "да", "так", "ναι", "evet", "是", "はい", "예",    "네",  "כן",  "نعم"});

bool is_one_of(const auto& words, const std::string& cell) {
  return std::ranges::find(words, lowered(composed(cell))) != words.end();
}

bool all_below(const Csv& table, std::size_t column, const std::function<bool(const std::string&)>& holds) {
  return table.rows.size() > 1 &&
         std::all_of(table.rows.begin() + 1, table.rows.end(),
                     [&](const Csv::Row& row) { return holds(composed(row.at(column))); });
}

std::size_t different_in(const Csv& table, std::size_t column) {
  std::set<std::string> seen;
  for (std::size_t i = 1; i < table.rows.size(); ++i) seen.insert(composed(table.rows[i].at(column)));
  return seen.size();
}

// True for "Participant 4711": one word, and numbers that differ.
bool counts_participants(const Csv& table, std::size_t column) {
  const auto word_of = [](const std::string& cell) {
    return cell.substr(0, cell.find_last_not_of("0123456789") + 1);
  };
  const std::string word = table.rows.size() > 1 ? word_of(composed(table.rows[1].at(column))) : "";
  return !word.empty() && !squeezed(word).empty() && different_in(table, column) + 1 == table.rows.size() &&
         all_below(table, column, [&](const std::string& cell) {
           return word_of(cell) == word && cell.size() > word.size();
         });
}

// Returns the maximum if all rows have the same.
std::optional<double> maximum_in(const Csv& table, std::size_t column) {
  const std::optional<double> maximum =
      table.rows.size() > 1 ? number_in(table.rows[1].at(column)) : std::nullopt;
  const bool is_one = maximum && *maximum > 0 && all_below(table, column, [&](const std::string& cell) {
                        return number_in(cell) == maximum;
                      });
  return is_one ? maximum : std::nullopt;
}

bool holds_grades(const Csv& table, std::size_t column, double maximum) {
  return all_below(table, column, [&](const std::string& cell) {
    const std::optional<double> number = number_in(cell);
    return cell.empty() || cell == "-" || (number && *number >= 0 && *number <= maximum);
  });
}

}  // namespace

bool says_no(const std::string& cell) {
  return is_one_of(kNo, cell);
}

std::optional<Worksheet> worksheet_by_form(const Csv& table, const std::string& grades) {
  const Cells& titles = table.rows.front().cells;
  Worksheet sheet;
  if (titles.size() < kFewest || !counts_participants(table, sheet.identifier)) return {};
  for (std::size_t i = 1; i + 1 + kBehindMaximum < titles.size(); ++i)
    if (const std::optional<double> maximum = maximum_in(table, i + 1);
        maximum && holds_grades(table, i, *maximum)) {
      sheet.grade = i;
      sheet.like_grades.push_back(composed(titles[i]));
    }
  if (sheet.like_grades.size() > 1) sheet.grade = kNoColumn;
  if (!grades.empty()) sheet.grade = column_of(table, grades);
  if (sheet.grade == 0) return {};
  if (sheet.grade != kNoColumn && sheet.grade + 1 < titles.size()) {
    const std::string first = composed(table.rows[1].at(sheet.grade + 1));
    // A scale's words are the same for all, too.
    if (!first.empty() &&
        all_below(table, sheet.grade + 1, [&](const std::string& cell) { return cell == first; }))
      sheet.maximum = sheet.grade + 1;
    for (std::size_t i = sheet.grade + 2; i < titles.size() && sheet.may_change == kNoColumn; ++i)
      if (all_below(table, i, [](const std::string& cell) { return is_one_of(kYes, cell) || says_no(cell); }))
        sheet.may_change = i;
  }
  const std::size_t end = std::min(sheet.grade, titles.size());
  for (std::size_t i = 1; i < end && sheet.email == kNoColumn; ++i)
    if (all_below(table, i, [](const std::string& cell) { return cell.find('@') != cell.npos; }))
      sheet.email = i;
  // Names follow the identifier, and nearly all differ; a blind worksheet has a few states there.
  if (end > 2 && sheet.email != 1 && 2 * different_in(table, 1) >= table.rows.size()) sheet.name = 1;
  return sheet;
}

}  // namespace grader::roster
