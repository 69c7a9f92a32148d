#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hair/io/plot/check_table.h"
#include "hair/io/plot/page.h"
#include "hair/io/plot/xml.h"

namespace hair {

namespace {

using plot::XmlWriter;

// Nothing is loaded and no script runs, whatever a text or a figure holds.
constexpr const char* kPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { margin: 0; background: #fff; color: #1a1a1a; font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 60rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 2.5rem 0 .75rem; border-top: 1px solid #d0d0d0; padding-top: 1rem; }
p { max-width: 45rem; margin: 0 0 .75rem; }
a { color: #005a8c; }
figure { margin: 1rem 0 1.5rem; }
svg { display: block; max-width: 100%; height: auto; }
summary { cursor: pointer; padding: .25rem 0; }
.wide { overflow-x: auto; margin: .5rem 0 1rem; }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: bold; padding: .25rem 0; }
th, td { padding: .2rem .75rem .2rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid #e4e4e4; }
thead th { border-bottom: 2px solid #767676; vertical-align: bottom; }
tbody th { font-weight: normal; }
.number { text-align: right; white-space: nowrap; }
@media print { body { font-size: 11pt; } figure, tr { break-inside: avoid; } h2 { break-after: avoid; } }
)";

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") != std::string::npos &&
         text.find_first_not_of("0123456789+-.e%") == std::string::npos;
}

// Columns of numbers stand with their last digits below each other.
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

void write_table(XmlWriter& html, const Table& table) {
  plot::check_table(table);
  const std::vector<bool> numbers = columns_of_numbers(table);
  const auto cell = [&](const char* tag, const char* scope, std::size_t column, const std::string& text) {
    const char* kind = numbers[column] ? "number" : "text";
    if (scope)
      html.leaf(tag, {{"scope", scope}, {"class", kind}}, text);
    else
      html.leaf(tag, {{"class", kind}}, text);
  };
  // What is wider than the page scrolls, with the keyboard, too.
  html.open("div", {{"class", "wide"}, {"role", "region"}, {"aria-label", table.caption}, {"tabindex", "0"}});
  html.open("table").leaf("caption", {}, table.caption);
  html.open("thead").open("tr");
  for (std::size_t i = 0; i < table.header.size(); ++i) cell("th", "col", i, table.header[i]);
  html.close().close().open("tbody");
  for (const std::vector<std::string>& row : table.rows) {
    html.open("tr");
    for (std::size_t i = 0; i < row.size(); ++i)
      cell(i == 0 ? "th" : "td", i == 0 ? "row" : nullptr, i, row[i]);
    html.close();
  }
  html.close().close().close();
}

std::string section_id(std::size_t section) {
  return "section-" + std::to_string(section + 1);
}

void write_section(XmlWriter& html, const Section& section, const std::string& id) {
  html.open("section", {{"aria-labelledby", id}});
  html.leaf("h2", {{"id", id}}, section.heading);
  for (const std::string& paragraph : section.paragraphs) html.leaf("p", {}, paragraph);
  for (const Table& table : section.first) write_table(html, table);
  for (const std::string& figure : section.figures) html.open("figure").as_it_is(figure).close();
  for (const Table& table : section.tables) {
    if (section.figures.empty()) {
      write_table(html, table);
      continue;
    }
    html.open("details").leaf("summary", {}, "Table: " + table.caption);
    write_table(html, table);
    html.close();
  }
  html.close();
}

// An id that comes twice leads readers to the wrong place.
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

std::string to_html(const Page& page) {
  require_unique_ids(page);
  XmlWriter html;
  html.as_it_is("<!DOCTYPE html>\n").open("html", {{"lang", "en"}}).open("head");
  html.empty("meta", {{"charset", "utf-8"}});
  html.empty("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", kPolicy}});
  html.empty("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  html.leaf("title", {}, page.title);
  html.open("style").as_it_is(kStyle).close().close();
  html.open("body").open("main").leaf("h1", {}, page.title);
  for (const std::string& paragraph : page.paragraphs) html.leaf("p", {}, paragraph);
  if (page.sections.size() > 2) {
    html.open("nav", {{"aria-label", "Contents"}}).open("ul");
    for (std::size_t i = 0; i < page.sections.size(); ++i)
      html.open("li").leaf("a", {{"href", "#" + section_id(i)}}, page.sections[i].heading).close();
    html.close().close();
  }
  for (std::size_t i = 0; i < page.sections.size(); ++i) write_section(html, page.sections[i], section_id(i));
  return html.close().close().close().take();
}

}  // namespace hair
