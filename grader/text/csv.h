// STAFF ONLY. Tables as text, RFC 4180: from learning systems, or written again by spreadsheets. The
// separator (, ; or tab, or from a first line "sep=;"), the encoding and the ends of lines are found. Cells
// are written so that no spreadsheet runs one as a formula.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/text/encoding.h"

namespace grader::inline text {

using Cells = std::vector<std::string>;

struct Csv {
  struct Row {
    Cells cells;             // UTF-8; unchanged, also blanks
    std::size_t line = 0;    // is its first line in the file, from 1
    std::string_view bytes;  // is its part of `text`, without its end

    // Returns "" beyond the row's end, also for kNoColumn.
    std::string at(std::size_t column) const { return column < cells.size() ? cells[column] : ""; }
  };
  std::string file;  // is for messages
  Encoding encoding;
  char separator = ',';
  std::string end_of_line = "\r\n";
  std::vector<Row> rows;                    // leave out empty lines
  std::vector<std::string> said;            // for staff, a line each: properties found or guessed
  std::shared_ptr<const std::string> text;  // is the whole file, decoded
};

// Throws BadInput with the line: no rows at all, a quote that never ends, text behind a quote, a NUL.
Csv parse_csv(std::string_view bytes, const std::string& file);

// Throws BadInput, too, for a file that can't be read.
Csv read_csv(const std::filesystem::path& file);

// Returns the column of this title, without regard to case and blanks around it; npos if there is none. Two
// such columns throw BadInput.
inline constexpr std::size_t kNoColumn = std::string::npos;
std::size_t column_of(const Csv& table, const std::string& title);

// Writes "roster.csv, line 7".
std::string place_of(const Csv& table, const Csv::Row& row);

// Reads the number of a cell, "10", "10.00", "10,00"; returns nothing for other texts.
std::optional<double> number_in(const std::string& cell);

// True if a spreadsheet would run it: after blanks it begins with = + - or @, also in their wide forms, and
// has more text, and is no number.
bool starts_formula(std::string_view cell);

// A cell that would be run gets U+2060 in front, which is invisible and no blank. A number keeps its sign.
// Invalid UTF-8 becomes U+FFFD.
std::string csv_line(const Cells& cells, char separator = ',', const std::string& end_of_line = "\r\n",
                     bool all_quoted = false);

}  // namespace grader::text
