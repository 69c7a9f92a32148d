// A page that stands alone: headings, text, figures, tables, in one HTML file, readable with scripts off and
// by a screen reader; and tables as CSV.
#pragma once

#include <string>
#include <vector>

namespace hair {

struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // as long as the header, each
};

struct Section {
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<std::string> figures = {};  // SVG texts
  std::vector<Table> tables = {};         // beneath the figures, folded unless there is no figure
  std::vector<Table> first = {};          // above the figures, never folded
};

struct Page {
  std::string title;
  std::vector<std::string> paragraphs = {};  // what it shows, on which machine, with what versions
  std::vector<Section> sections = {};
};

// Text is escaped; figures are taken as they are.
std::string to_html(const Page& page);

// RFC 4180, with line feeds alone: the header, then the rows.
std::string to_csv(const Table& table);

// Enough digits to see a difference, few enough to read: "1.23e-5".
std::string to_text(double value);

// The fewest digits that read back as the same number: for CSV.
std::string to_exact_text(double value);

}  // namespace hair
