#include "hair/validate/record.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace hair {

namespace {

std::string number(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string with_unit(const Check& check) {
  return check.unit.empty() ? check.shows : check.shows + ", " + check.unit;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// What a check found, and why it says so.
const std::vector<std::string> kFound = {"what", "expected", "measured", "error", "tolerance", "holds"};
const std::vector<std::string> kWhy = {"check", "expected: source", "tolerance: from"};

std::vector<std::string> found(const Check& check) {
  return {with_unit(check),
          number("%.9g", check.expected),
          number("%.9g", check.measured),
          number("%.1e", check.error()),
          number("%.1e", check.tolerance),
          check.holds() ? "yes" : "NO"};
}

std::vector<std::string> why(const Check& check) {
  return {check.id, check.source, check.tolerance_from};
}

std::string outcome(const ValidationRecord& record) {
  if (!record.ran()) return "left out: it needs " + record.left_out;
  if (!record.broke.empty()) return "broke: " + record.broke;
  return summary({record});
}

Section section_of_checks(const ValidationRecord& record) {
  Section section{record.title,
                  {"hairlab validate " + record.id + " calls " +
                   (record.exercises.empty() ? "no exercise" : joined(record.exercises)) + ": " +
                   outcome(record) + ". " + number("%.2g", record.cpu_seconds) + " s of CPU time."}};
  if (record.result.checks.empty()) return section;
  Table& table = section.tables.emplace_back(Table{"Checks of " + record.id, kFound, {}});
  for (const Check& check : record.result.checks) table.rows.push_back(found(check));
  return section;
}

Section section_of_details(const ValidationRecord& record) {
  Section section{record.title + ": in detail"};
  // An exercise's numbers may be none: that must not cost the page.
  for (const Figure& figure : record.result.figures) try {
      section.figures.push_back(to_svg(figure));
    } catch (const std::invalid_argument& error) {
      section.paragraphs.push_back(std::string("A figure can't be drawn: ") + error.what() + ".");
    }
  section.tables = record.result.tables;
  Table& table = section.tables.emplace_back(
      Table{"Where expected values and tolerances of " + record.id + " come from", kWhy, {}});
  for (const Check& check : record.result.checks) table.rows.push_back(why(check));
  return section;
}

using Json = nlohmann::ordered_json;

Json json_of_check(const Check& check) {
  return {{"id", check.id},
          {"shows", check.shows},
          {"unit", check.unit},
          {"source", check.source},
          {"expected", check.expected},
          {"measured", check.measured},
          {"tolerance", check.tolerance},
          {"tolerance_from", check.tolerance_from},
          {"holds", check.holds()}};
}

}  // namespace

bool ValidationRecord::holds() const {
  return ran() && broke.empty() &&
         std::all_of(result.checks.begin(), result.checks.end(),
                     [](const Check& check) { return check.holds(); });
}

std::string summary(const std::vector<ValidationRecord>& records) {
  std::size_t count = 0, holding = 0;
  for (const ValidationRecord& record : records)
    for (const Check& check : record.result.checks) {
      ++count;
      holding += check.holds() ? 1 : 0;
    }
  return std::to_string(holding) + " of " + std::to_string(count) + " checks hold";
}

std::string terminal_text(const ValidationRecord& record) {
  std::string text = record.id + ": " + record.title + "\n";
  if (!record.ran() || !record.broke.empty()) return text + "  " + outcome(record) + "\n";
  std::size_t width = 4;
  for (const Check& check : record.result.checks) width = std::max(width, with_unit(check).size());
  const auto line = [&](const std::string& what, const std::string& rest) {
    return "  " + what + std::string(width - what.size(), ' ') + rest + "\n";
  };
  const auto columns = [](const char* a, const char* b, const char* c, const char* d, const char* e) {
    char rest[120];
    std::snprintf(rest, sizeof rest, " %13s %13s %8s %8s  %s", a, b, c, d, e);
    return std::string(rest);
  };
  text += line("", columns("expected", "measured", "error", "tolerance", ""));
  for (const Check& check : record.result.checks) {
    const std::vector<std::string> row = found(check);
    text += line(row[0], columns(row[1].c_str(), row[2].c_str(), row[3].c_str(), row[4].c_str(),
                                 check.holds() ? "ok" : "DOES NOT HOLD"));
  }
  return text;
}

Table table_of_checks(const std::vector<ValidationRecord>& records) {
  Table table{"Checks", {"validation"}, {}};
  table.header.insert(table.header.end(), kWhy.begin(), kWhy.end());
  table.header.insert(table.header.end(), kFound.begin(), kFound.end());
  for (const ValidationRecord& record : records)
    for (const Check& check : record.result.checks) {
      std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{record.id});
      for (const std::vector<std::string>& part : {why(check), found(check)})
        row.insert(row.end(), part.begin(), part.end());
      row[5] = to_exact_text(check.expected);
      row[6] = to_exact_text(check.measured);
    }
  return table;
}

Page page_of(const std::vector<ValidationRecord>& records, bool quick) {
  Page page{
      "Truth from outside",
      {"What theory says of hair and of the methods that move it, beside what the exercises' code does. A "
       "check holds if measured and expected differ by the tolerance at most, and the theory says how much "
       "that is.",
       summary(records) + "."}};
  if (quick) page.paragraphs.emplace_back("A quick run: fewer and coarser.");
  for (const ValidationRecord& record : records) {
    page.sections.push_back(section_of_checks(record));
    if (!record.result.checks.empty()) page.sections.push_back(section_of_details(record));
  }
  return page;
}

std::string json_of(const std::vector<ValidationRecord>& records, bool quick) {
  Json validations = Json::array();
  for (const ValidationRecord& record : records) {
    Json checks = Json::array();
    for (const Check& check : record.result.checks) checks.push_back(json_of_check(check));
    Json one = {{"id", record.id},
                {"title", record.title},
                {"exercises", record.exercises},
                {"holds", record.ran() ? Json(record.holds()) : Json()}};
    if (!record.ran()) one["left_out"] = record.left_out;
    if (!record.broke.empty()) one["broke"] = record.broke;
    one["checks"] = std::move(checks);
    one["tables"] = Json::array();
    for (const Table& table : record.result.tables)
      one["tables"].push_back({{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}});
    one["cpu_seconds"] = record.cpu_seconds;
    validations.push_back(std::move(one));
  }
  return Json({{"format", "hairlab validate 1"}, {"quick", quick}, {"validations", std::move(validations)}})
             .dump(1) +
         "\n";
}

}  // namespace hair
