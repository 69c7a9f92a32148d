// STAFF ONLY. Writes tables.
#include <algorithm>
#include <cctype>

#include "grader/text/csv.h"
#include "hair/io/plot/readable.h"

namespace grader::inline text {
namespace {

constexpr const char* kNotSeen = "\u2060";  // is the word joiner

bool is_number(std::string_view cell) {
  if (!cell.empty() && (cell[0] == '-' || cell[0] == '+')) cell.remove_prefix(1);
  if (!cell.empty() && cell.back() == '%') cell.remove_suffix(1);
  const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  return !cell.empty() && digit(static_cast<unsigned char>(cell[0])) &&
         std::ranges::count_if(cell, digit) >= std::ssize(cell) - 1 &&
         cell.find_first_not_of("0123456789.,") == cell.npos;
}

std::string written(const std::string& bytes, char separator, bool always) {
  std::string text = hair::valid_utf8(bytes);
  if (starts_formula(text)) text = kNotSeen + text;
  const bool bare =
      !always && text.find_first_of("\"\r\n\t") == text.npos && text.find(separator) == text.npos;
  if (bare) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

bool starts_formula(std::string_view cell) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  while (!cell.empty()) {
    if (kBlanks.find(cell[0]) != kBlanks.npos)
      cell.remove_prefix(1);
    else if (cell.starts_with("\u00a0"))
      cell.remove_prefix(2);
    else if (cell.starts_with("\u3000") || cell.starts_with("\ufeff"))
      cell.remove_prefix(3);
    else
      break;
  }
  for (const std::string_view begin : {"=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20", "\u2212"})
    if (cell.starts_with(begin)) return cell.size() > begin.size() && !is_number(cell);
  return false;
}

std::string csv_line(const Cells& cells, char separator, const std::string& end_of_line, bool all_quoted) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text += separator;
    text += written(cells[i], separator, all_quoted);
  }
  return text + end_of_line;
}

}  // namespace grader::text
