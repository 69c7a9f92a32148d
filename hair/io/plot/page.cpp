#include "hair/io/plot/page.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hair/io/plot/html.h"

namespace hair {

namespace {

// It has a header, and all rows are as long as the header.
void check_table(const Table& table) {
  if (table.header.empty())
    throw std::invalid_argument("table \"" + table.caption + "\": the header is empty; a column is needed");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != table.header.size())
      throw std::invalid_argument("table \"" + table.caption + "\": row " + std::to_string(i) + " has " +
                                  std::to_string(table.rows[i].size()) + " fields; the header has " +
                                  std::to_string(table.header.size()));
}

std::string field(const std::string& text) {
  if (text.find_first_of("\",\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string line(const std::vector<std::string>& fields) {
  // A single empty field is quoted, because most CSV readers take an empty line for no record.
  if (fields.size() == 1 && fields[0].empty()) return "\"\"\n";
  std::string out;
  for (std::size_t i = 0; i < fields.size(); ++i) out += (i > 0 ? "," : "") + field(fields[i]);
  return out + "\n";
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") != std::string::npos &&
         text.find_first_not_of("0123456789+-.e%") == std::string::npos;
}

// Columns of numbers align their last digits.
std::vector<bool> columns_of_numbers(const Table& table) {
  std::vector<bool> numbers(table.header.size(), !table.rows.empty());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto fits = [i](const std::vector<std::string>& row) {
      return row[i].empty() || is_number(row[i]);
    };
    const auto says = [i](const std::vector<std::string>& row) { return !row[i].empty(); };
    numbers[i] = std::all_of(table.rows.begin(), table.rows.end(), fits) &&
                 std::any_of(table.rows.begin(), table.rows.end(), says);
  }
  return numbers;
}

Html table_of(const Table& table) {
  check_table(table);
  const std::vector<bool> numbers = columns_of_numbers(table);
  const auto kind = [&](std::size_t column) { return numbers[column] ? "number" : "text"; };
  // A table wider than the page scrolls, also with the keyboard.
  Html all = html(
      "<div class=\"wide\" role=\"region\" aria-label=\"{}\" "
      "tabindex=\"0\"><table>\n<caption>{}</caption>\n<thead><tr>",
      {table.caption, table.caption});
  for (std::size_t i = 0; i < table.header.size(); ++i)
    all += html("<th scope=\"col\" class=\"{}\">{}</th>", {kind(i), table.header[i]});
  all += html("</tr></thead>\n<tbody>\n");
  for (const std::vector<std::string>& row : table.rows) {
    all += html("<tr>");
    for (std::size_t i = 0; i < row.size(); ++i)
      all += i == 0 ? html("<th scope=\"row\" class=\"{}\">{}</th>", {kind(i), row[i]})
                    : html("<td class=\"{}\">{}</td>", {kind(i), row[i]});
    all += html("</tr>\n");
  }
  return all += html("</tbody>\n</table></div>\n");
}

std::string section_id(std::size_t section) {
  return "section-" + std::to_string(section + 1);
}

// A duplicate id leads readers to the wrong place.
std::vector<std::string> ids_in(const std::string& figure) {
  constexpr std::string_view kId = " id=\"";
  std::vector<std::string> ids;
  for (std::size_t at = figure.find(kId); at != std::string::npos; at = figure.find(kId, at)) {
    at += kId.size();
    ids.push_back(figure.substr(at, figure.find('"', at) - at));
  }
  return ids;
}

void require_unique_ids(const Page& page) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    all.push_back(section_id(i));
    for (const std::string& figure : page.sections[i].figures)
      for (std::string& id : ids_in(figure)) all.push_back(std::move(id));
  }
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  if (twice == all.end()) return;
  throw std::invalid_argument("page \"" + page.title + "\": the id \"" + *twice +
                              "\" comes twice; give each figure an id of its own");
}

}  // namespace

Html html_of(const Section& section, const std::string& id) {
  Html all = html("<section aria-labelledby=\"{}\">\n<h2 id=\"{}\">{}</h2>\n", {id, id, section.heading});
  for (const std::string& paragraph : section.paragraphs) all += html("<p>{}</p>\n", {paragraph});
  for (const Table& table : section.first) all += table_of(table);
  for (const std::string& figure : section.figures) all += html("<figure>{}</figure>\n", {Html{figure}});
  for (const Table& table : section.tables)
    all += section.figures.empty() ? table_of(table)
                                   : html("<details><summary>Table: {}</summary>\n{}</details>\n",
                                          {table.caption, table_of(table)});
  return all += html("</section>\n");
}

std::string to_html(const Page& page) {
  require_unique_ids(page);
  Html body = html("<main>\n<h1>{}</h1>\n", {page.title});
  for (const std::string& paragraph : page.paragraphs) body += html("<p>{}</p>\n", {paragraph});
  if (page.sections.size() > 2) {
    body += html("<nav aria-label=\"Contents\"><ul>\n");
    for (std::size_t i = 0; i < page.sections.size(); ++i)
      body += html("<li><a href=\"#{}\">{}</a></li>\n", {section_id(i), page.sections[i].heading});
    body += html("</ul></nav>\n");
  }
  for (std::size_t i = 0; i < page.sections.size(); ++i) body += html_of(page.sections[i], section_id(i));
  body += html("</main>\n");
  return html_page(page.title, body, {}, page.picture_files ? Pictures::beside : Pictures::inside);
}

std::string to_csv(const Table& table) {
  check_table(table);
  std::string out = line(table.header);
  for (const std::vector<std::string>& row : table.rows) out += line(row);
  return out;
}

}  // namespace hair
