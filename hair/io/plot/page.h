// A self-contained page of headings, text, figures and tables: one HTML file, readable without scripts and by
// a screen reader; pictures are files in its folder. Also tables as CSV.
#pragma once

#include <string>
#include <vector>

namespace hair {

struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
};

struct Section {
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<std::string> figures = {};  // SVG texts
  std::vector<Table> tables = {};         // beneath the figures, folded if there is a figure
  std::vector<Table> first = {};          // above the figures, never folded
};

struct Page {
  std::string title;
  std::vector<std::string> paragraphs = {};  // the topic, the machine, the versions
  std::vector<Section> sections = {};
  bool picture_files = false;  // figures show picture files in the page's folder
};

// Text is escaped; figures are inserted unchanged.
std::string to_html(const Page& page);

struct Html;                                                  // html.h
Html html_of(const Section& section, const std::string& id);  // a part of a page

// RFC 4180, except that lines end with a line feed only: the header, then the rows.
std::string to_csv(const Table& table);

// Enough digits to see a difference, few enough to read: "1.23e-5".
std::string to_text(double value);

// Formats like printf: "%.9g".
std::string printed(const char* format, double value);

// The shortest text that reads back as the same number: for CSV.
std::string to_exact_text(double value);

}  // namespace hair
