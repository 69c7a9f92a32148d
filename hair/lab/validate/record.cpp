#include "hair/lab/validate/record.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace hair {

namespace {

std::string with_unit(const Check& check) {
  return check.unit.empty() ? check.shows : check.shows + ", " + check.unit;
}

std::string nine_digits(double value) {
  return printed("%.9g", value);
}

std::string two_digits(double value) {
  return printed("%.1e", value);
}

// A check: its sources, and the numbers that it found.
Row why(const Check& check) {
  return {{"id", "", check.id, {"check"}},
          {"source", "", check.source, {"expected: source"}},
          {"tolerance_from", "", check.tolerance_from, {"tolerance: from"}}};
}

Row found(const Check& check) {
  return {{"shows", "", check.shows, In::json},
          {"unit", "", check.unit, In::json},
          {"what", "", with_unit(check), In::tables},
          {"expected", "", check.expected, {.written = nine_digits}},
          {"measured", "", check.measured, {.written = nine_digits}},
          {"error", "", check.error(), {.written = two_digits}, In::tables},
          {"tolerance", "", check.tolerance, {.written = two_digits}},
          {"holds", "", check.holds(), In::json},
          {"holds", "", check.holds() ? "yes" : "NO", In::tables}};
}

std::string outcome(const ValidationRecord& record) {
  if (!record.ran()) return "left out: it needs " + record.left_out;
  if (!record.broke.empty()) return "broke: " + record.broke;
  return summary({record});
}

Section section_of(const ValidationRecord& record) {
  Section section{record.title,
                  {"hairlab validate " + record.id + " calls " + calls(record.exercises) + ": " +
                   outcome(record) + ". " + printed("%.2g", record.cpu_seconds) + " s of CPU time."}};
  const ValidationResult& result = record.result;
  if (result.checks.empty()) return section;
  section.first = {table_of(rows_of(result.checks, found), "Checks of " + record.id)};
  // An exercise's numbers may be NaN: the page must still appear.
  for (const Figure& figure : result.figures) try {
      section.figures.push_back(to_svg(figure));
    } catch (const std::invalid_argument& error) {
      section.paragraphs.push_back(std::string("A figure can't be drawn: ") + error.what() + ".");
    }
  section.tables = result.tables;
  section.tables.push_back(table_of(rows_of(result.checks, why),
                                    "Where expected values and tolerances of " + record.id + " come from"));
  return section;
}

OrderedJson json_of_tables(const std::vector<Table>& tables) {
  OrderedJson all = OrderedJson::array();
  for (const Table& table : tables)
    all.push_back({{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}});
  return all;
}

}  // namespace

std::string calls(const std::vector<std::string>& exercises) {
  std::string text;
  for (const std::string& id : exercises) text += (text.empty() ? "" : ", ") + id;
  return text.empty() ? "no exercise" : text;
}

bool ValidationRecord::holds() const {
  return ran() && broke.empty() &&
         std::ranges::all_of(result.checks, [](const Check& check) { return check.holds(); });
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
  const auto line = [&](const std::vector<std::string>& row, const char* verdict) {
    char rest[120];
    std::snprintf(rest, sizeof rest, " %13s %13s %8s %8s  %s\n", row[1].c_str(), row[2].c_str(),
                  row[3].c_str(), row[4].c_str(), verdict);
    return "  " + row[0] + std::string(width - row[0].size(), ' ') + rest;
  };
  text += line({"", "expected", "measured", "error", "tolerance"}, "");
  for (const Check& check : record.result.checks)
    text += line(table_of({found(check)}, "").rows[0], check.holds() ? "ok" : "DOES NOT HOLD");
  return text;
}

std::vector<Row> check_rows(const std::vector<ValidationRecord>& records) {
  std::vector<Row> rows;
  for (const ValidationRecord& record : records) {
    const Row id = {{"validation", "", record.id}};
    for (const Check& check : record.result.checks) rows.push_back(id + why(check) + found(check));
    if (record.ran() && record.broke.empty()) continue;
    rows.push_back(id + Row{{"id", "", {}},
                            {"source", "", {}},
                            {"tolerance_from", "", {}},
                            {"what", "", outcome(record)},
                            {"expected", "", {}},
                            {"measured", "", {}},
                            {"error", "", {}},
                            {"tolerance", "", {}},
                            {"holds", "", record.ran() ? "NO" : ""}});
  }
  return rows;
}

Page page_of(const std::vector<ValidationRecord>& records) {
  Page page{"Truth from outside",
            {"What theory says of hair and of the methods that move it, beside what the exercises' code "
             "does. A check holds if measured and expected differ by the tolerance at most, and the theory "
             "says how much that is.",
             summary(records) + "."}};
  for (const ValidationRecord& record : records) page.sections.push_back(section_of(record));
  return page;
}

OrderedJson json_of(const std::vector<ValidationRecord>& records) {
  OrderedJson validations = OrderedJson::array();
  for (const ValidationRecord& record : records) {
    OrderedJson one = {{"id", record.id},
                       {"title", record.title},
                       {"exercises", record.exercises},
                       {"holds", record.ran() ? OrderedJson(record.holds()) : OrderedJson()}};
    if (!record.ran()) one["left_out"] = record.left_out;
    if (!record.broke.empty()) one["broke"] = record.broke;
    one["checks"] =
        json_of(rows_of(record.result.checks, [](const Check& check) { return why(check) + found(check); }));
    one["tables"] = json_of_tables(record.result.tables);
    one["cpu_seconds"] = record.cpu_seconds;
    validations.push_back(std::move(one));
  }
  return {{"format", 2}, {"validations", std::move(validations)}};
}

}  // namespace hair
