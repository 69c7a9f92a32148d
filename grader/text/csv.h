// STAFF ONLY. Tables as text, RFC 4180: what learning systems export, and what spreadsheets write of it
// again. The separator (, ; or tab, also as a first line "sep=;" says it), the encoding and the ends of lines
// are found. Cells are written so that no spreadsheet runs one as a formula.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grader/text/encoding.h"

namespace grader::inline text {

using Cells = std::vector<std::string>;

struct Csv {
  struct Row {
    Cells cells;             // UTF-8; as they are, blanks too
    std::size_t line = 0;    // in the file, from 1: where it begins
    std::string_view bytes;  // as it stands in `text`, without its end

    // "" beyond the row's end, also for kNoColumn.
    std::string at(std::size_t column) const { return column < cells.size() ? cells[column] : ""; }
  };
  std::string file;  // for messages
  Encoding encoding;
  char separator = ',';
  std::string end_of_line = "\r\n";
  std::vector<Row> rows;                    // without empty lines
  std::vector<std::string> said;            // for staff, a line each: what was found or guessed
  std::shared_ptr<const std::string> text;  // the whole file, decoded
};

// Throws BadInput with the line: no rows at all, a quote that never ends, text behind a quote, a NUL.
Csv parse_csv(std::string_view bytes, const std::string& file);

// Throws BadInput, too, for a file that can't be read.
Csv read_csv(const std::filesystem::path& file);

// The column of this title, letters' case and blanks around it aside; npos if there is none. Two columns of
// it throw BadInput.
inline constexpr std::size_t kNoColumn = std::string::npos;
std::size_t column_of(const Csv& table, const std::string& title);

// "roster.csv, line 7"
std::string place_of(const Csv& table, const Csv::Row& row);

// A spreadsheet would run it: it begins, blanks aside, with = + - or @, also in their wide forms, has more
// than that, and is no number.
bool starts_formula(std::string_view cell);

// A cell that would be run begins with U+2060 instead, which nobody sees and which is no blank. A number
// keeps its sign. What is no UTF-8 becomes U+FFFD.
std::string csv_line(const Cells& cells, char separator = ',', const std::string& end_of_line = "\r\n",
                     bool all_quoted = false);

}  // namespace grader::text
