#include "hair/lab/validate/record.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace hair {

namespace {

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
          printed("%.9g", check.expected),
          printed("%.9g", check.measured),
          printed("%.1e", check.error()),
          printed("%.1e", check.tolerance),
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

Section section_of(const ValidationRecord& record) {
  Section section{record.title,
                  {"hairlab validate " + record.id + " calls " +
                   (record.exercises.empty() ? "no exercise" : joined(record.exercises)) + ": " +
                   outcome(record) + ". " + printed("%.2g", record.cpu_seconds) + " s of CPU time."}};
  const ValidationResult& result = record.result;
  if (result.checks.empty()) return section;
  Table checks{"Checks of " + record.id, kFound, {}};
  Table sources{"Where expected values and tolerances of " + record.id + " come from", kWhy, {}};
  for (const Check& check : result.checks) {
    checks.rows.push_back(found(check));
    sources.rows.push_back(why(check));
  }
  section.first = {std::move(checks)};
  // An exercise's numbers may be none: that must not cost the page.
  for (const Figure& figure : result.figures) try {
      section.figures.push_back(to_svg(figure));
    } catch (const std::invalid_argument& error) {
      section.paragraphs.push_back(std::string("A figure can't be drawn: ") + error.what() + ".");
    }
  section.tables = result.tables;
  section.tables.insert(section.tables.end(), result.times.begin(), result.times.end());
  section.tables.push_back(std::move(sources));
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

Json json_of_tables(const std::vector<Table>& tables) {
  Json all = Json::array();
  for (const Table& table : tables)
    all.push_back({{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}});
  return all;
}

}  // namespace

bool ValidationRecord::holds() const {
  return ran() && broke.empty() &&
         std::all_of(result.checks.begin(), result.checks.end(),
                     [](const Check& check) { return check.holds(); });
}

std::string summary(const std::vector<ValidationRecord>& records) {
  std::size_t count = 0, holding = 0, broke = 0, left_out = 0;
  for (const ValidationRecord& record : records) {
    for (const Check& check : record.result.checks) {
      ++count;
      holding += check.holds() ? 1 : 0;
    }
    broke += record.broke.empty() ? 0 : 1;
    left_out += record.ran() ? 0 : 1;
  }
  std::string text = std::to_string(holding) + " of " + std::to_string(count) + " checks hold";
  const std::string all = " of " + std::to_string(records.size()) + " validations ";
  if (broke > 0) text += "; " + std::to_string(broke) + all + "broke";
  if (left_out > 0) text += "; " + std::to_string(left_out) + all + "are left out";
  return text;
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
  for (const ValidationRecord& record : records) {
    if (!record.ran() || !record.broke.empty())
      table.rows.push_back(
          {record.id, "", "", "", outcome(record), "", "", "", "", record.ran() ? "NO" : ""});
    for (const Check& check : record.result.checks) {
      std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{record.id});
      for (const std::vector<std::string>& part : {why(check), found(check)})
        row.insert(row.end(), part.begin(), part.end());
      row[5] = to_exact_text(check.expected);
      row[6] = to_exact_text(check.measured);
    }
  }
  return table;
}

Page page_of(const std::vector<ValidationRecord>& records, bool quick, const std::string& machine) {
  Page page{
      "Truth from outside",
      {"What theory says of hair and of the methods that move it, beside what the exercises' code does. A "
       "check holds if measured and expected differ by the tolerance at most, and the theory says how much "
       "that is.",
       summary(records) + ".", machine}};
  if (quick) page.paragraphs.emplace_back("A quick run: fewer and coarser.");
  for (const ValidationRecord& record : records) page.sections.push_back(section_of(record));
  return page;
}

std::string json_of(const std::vector<ValidationRecord>& records, bool quick, const std::string& machine) {
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
    one["tables"] = json_of_tables(record.result.tables);
    one["times"] = json_of_tables(record.result.times);
    one["cpu_seconds"] = record.cpu_seconds;
    validations.push_back(std::move(one));
  }
  return Json({{"format", "hairlab validate 1"},
               {"quick", quick},
               {"machine", machine},
               {"validations", std::move(validations)}})
             .dump(1) +
         "\n";
}

}  // namespace hair
