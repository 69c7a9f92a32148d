// The columns of a study's rows, declared once; JSON, CSV and the tables of pages are made from them.
//
//   Row row_of(const Run& run) {
//     return {{"step", "s", run.step}, {"error.rms", "m", run.rms, {"RMS, mm", 1e3}}};
//   }
//
// The name is the key in JSON, in which a dot opens an object. CSV has name and unit: step_s, error_rms_m.
// Pages have "step, s", or a heading of the column's own. A value is a truth value, a number, a text, an
// optional of these, or a list of numbers or texts; only JSON shows lists. A number that is not finite is
// null in JSON. All rows of a table have the same columns.
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hair/io/plot/page.h"

namespace hair {

using OrderedJson = nlohmann::ordered_json;

// A column on pages.
struct OnPages {
  std::string heading = {};                  // empty: name and unit
  double scale = 1;                          // a factor for numbers: 1e3 for mm
  std::string (*written)(double) = to_text;  // formats numbers that are not whole
};

enum class In { all, files, tables, json, csv, page };  // files: JSON and CSV; tables: CSV and pages

class Value {
 public:
  Value(bool truth) : value_(truth) {}
  Value(std::integral auto whole) : value_(static_cast<long>(whole)) {}
  Value(double number) : value_(number) {}
  Value(const char* text) : value_(std::string(text)) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(std::vector<double> numbers) : value_(std::move(numbers)) {}
  Value(std::vector<std::string> texts) : value_(std::move(texts)) {}
  template <class Some>
  Value(const std::optional<Some>& value) : Value(value ? Value(*value) : Value()) {}
  Value() = default;

  OrderedJson json() const;
  std::string exact() const;  // for CSV
  std::string on(const OnPages& page) const;

 private:
  std::variant<std::monostate, bool, long, double, std::string, std::vector<double>, std::vector<std::string>>
      value_;
};

struct Field {
  Field(std::string key, std::string of, Value what, OnPages page = {}, In where = In::all)
      : name(std::move(key)),
        unit(std::move(of)),
        value(std::move(what)),
        on_pages(std::move(page)),
        in(where) {}
  Field(std::string key, std::string of, Value what, In where)
      : Field(std::move(key), std::move(of), std::move(what), OnPages{}, where) {}

  std::string name, unit;
  Value value;
  OnPages on_pages;
  In in;
};

using Row = std::vector<Field>;
Row operator+(Row first, const Row& then);

// A row for each of some things.
template <class Things, class RowOf>
std::vector<Row> rows_of(const Things& things, RowOf row_of) {
  std::vector<Row> rows;
  for (const auto& one : things) rows.push_back(row_of(one));
  return rows;
}

OrderedJson json_of(const Row& row);
OrderedJson json_of(const std::vector<Row>& rows);

// A record's bytes: indented, and with a line's end.
std::string record_text(const OrderedJson& record);

std::string csv_of(const std::vector<Row>& rows);                          // empty without rows
Table table_of(const std::vector<Row>& rows, const std::string& caption);  // for pages
// Adds the table, unless there are no rows.
void add_table(std::vector<Table>& tables, const std::vector<Row>& rows, const std::string& caption);

// Null in JSON and empty in tables, rather than an empty text.
inline std::optional<std::string> if_any(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace hair
