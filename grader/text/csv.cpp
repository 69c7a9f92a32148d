// STAFF ONLY. Reads and writes tables.
#include "grader/text/csv.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "grader/course/input.h"
#include "grader/text/encoding.h"
#include "grader/text/letters.h"
#include "hair/io/files/read_file.h"
#include "hair/io/plot/readable.h"

namespace grader::inline text {
namespace {

// This fits all data of a million people.
constexpr std::size_t kMostBytes = std::size_t{1} << 28;
constexpr std::size_t kRowsToCompare = 4;

class Reader {
 public:
  Reader(std::string_view text, char separator, const std::string& file, std::size_t line = 1)
      : text_(text), separator_(separator), file_(file), line_(line) {}

  bool at_end() const { return at_ == text_.size(); }

  Csv::Row row() {
    Csv::Row row{{}, line_, {}};
    const std::size_t begin = at_;
    for (bool more = true; more;) {
      row.cells.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted() : plain());
      more = at_ < text_.size() && text_[at_] == separator_;
      at_ += more;
    }
    row.bytes = text_.substr(begin, at_ - begin);
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
    return row;
  }

 private:
  std::string plain() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\r' && text_[at_] != '\n') ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string quoted() {
    std::string cell;
    const std::size_t begins = line_;
    for (++at_;; ++at_) {
      const std::size_t end = std::min(text_.find('"', at_), text_.size());
      const std::string_view part = text_.substr(at_, end - at_);
      line_ += static_cast<std::size_t>(std::ranges::count(part, '\n'));
      cell += part;
      if (end == text_.size()) fail(begins, "a quote begins here and never ends");
      at_ = end + 1;
      if (at_ == text_.size() || text_[at_] != '"') break;
      cell += '"';
    }
    if (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\r' && text_[at_] != '\n')
      fail(line_, "text stands between the end of a quote and the separator; a quote within a cell is two");
    return cell;
  }

  [[noreturn]] void fail(std::size_t line, const std::string& why) const {
    throw BadInput(file_ + ", line " + std::to_string(line) + ": " + why);
  }

  std::string_view text_;
  char separator_;
  const std::string& file_;
  std::size_t line_, at_ = 0;
};

bool is_empty(const Csv::Row& row) {
  return row.cells.size() == 1 && row.cells[0].empty();
}

// Compares the head and the rows below it: more columns are better, if the rows have as many as the head.
char separator_of(std::string_view text, const std::string& file) {
  char best = ',';
  std::size_t most = 1;
  for (const char separator : {',', ';', '\t'}) {
    std::vector<std::size_t> counts;
    try {
      Reader reader(text, separator, file);
      while (!reader.at_end() && counts.size() < kRowsToCompare)
        if (const Csv::Row row = reader.row(); !is_empty(row)) counts.push_back(row.cells.size());
    } catch (const BadInput&) {  // a quote needs another separator, or the reader reports it
      continue;
    }
    const std::size_t columns = counts.empty()                                                ? 0
                                : std::ranges::count(counts, counts[0]) == std::ssize(counts) ? 2 * counts[0]
                                                                                              : counts[0];
    if (!counts.empty() && counts[0] > 1 && columns > most) {
      best = separator;
      most = columns;
    }
  }
  return best;
}

// Returns the length of a first line "sep=;", which spreadsheets read and write; 0 without one.
std::size_t separator_told_in(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  std::string_view line = text.substr(0, end);
  if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  if (end == text.npos || line.size() != 5 || lowered(line.substr(0, 4)) != "sep=" || line[4] == '"')
    return 0;
  return end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
}

}  // namespace

Csv parse_csv(std::string_view bytes, const std::string& file) {
  Csv table;
  table.file = file;
  Decoded decoded_text = decoded(bytes, file);
  table.said = std::move(decoded_text.said);
  table.encoding = decoded_text.encoding;
  table.text = std::make_shared<const std::string>(std::move(decoded_text.text));
  std::string_view text = *table.text;
  if (const std::size_t nul = text.find('\0'); nul != text.npos)
    throw BadInput(file + ", line " + std::to_string(1 + std::ranges::count(text.substr(0, nul), '\n')) +
                   ": a NUL byte is no text; save the table as CSV in UTF-8");
  const std::size_t told = separator_told_in(text);
  table.separator = told == 0 ? separator_of(text, file) : text[text.find('=') + 1];
  if (table.separator != ',')
    table.said.push_back(file + ": its separator is " +
                         (table.separator == ';'    ? "a semicolon"
                          : table.separator == '\t' ? "a tab"
                                                    : std::string(1, table.separator)));
  const std::size_t end = text.find('\n');
  if (end != text.npos && (end == 0 || text[end - 1] != '\r')) table.end_of_line = "\n";
  Reader reader(text.substr(told), table.separator, file, told == 0 ? 1 : 2);
  while (!reader.at_end())
    if (Csv::Row row = reader.row(); !is_empty(row)) table.rows.push_back(std::move(row));
  if (table.rows.empty()) throw BadInput(file + ": is empty; a table with a row of titles is needed");
  return table;
}

Csv read_csv(const std::filesystem::path& file) {
  return parse_csv(hair::read_file(file, kMostBytes, "a table, a CSV file"), printable(file.string(), 4096));
}

std::size_t column_of(const Csv& table, const std::string& title) {
  const auto same = [wanted = squeezed(title)](const std::string& cell) { return squeezed(cell) == wanted; };
  const Cells& head = table.rows.front().cells;
  const auto found = std::ranges::find_if(head, same);
  if (found == head.end()) return kNoColumn;
  if (std::find_if(found + 1, head.end(), same) != head.end())
    throw BadInput(place_of(table, table.rows.front()) + ": two columns are called \"" + composed(title) +
                   "\"; rename one");
  return static_cast<std::size_t>(found - head.begin());
}

std::string place_of(const Csv& table, const Csv::Row& row) {
  return table.file + ", line " + std::to_string(row.line);
}

std::optional<double> number_in(const std::string& cell) {
  std::string digits = composed(cell);
  const std::size_t last = digits.find_last_of(".,");
  std::string plain;
  for (std::size_t i = 0; i < digits.size(); ++i)
    if (digits[i] != '.' && digits[i] != ',')
      plain += digits[i];
    else if (i == last)
      plain += '.';
  double value = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (plain.empty() || error != std::errc() || end != plain.data() + plain.size() || !std::isfinite(value))
    return {};
  return value;
}

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
