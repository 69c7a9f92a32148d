#include "hair/io/plot/columns.h"

namespace hair {

namespace {

std::string heading_of(const Field& field, bool page) {
  if (page && !field.on_pages.heading.empty()) return field.on_pages.heading;
  std::string text = field.name;
  for (char& c : text)
    if (c == '.' || c == '_') c = page ? ' ' : '_';
  return field.unit.empty() ? text : text + (page ? ", " : "_") + field.unit;
}

Table made_of(const std::vector<Row>& rows, const std::string& caption, bool page) {
  Table table{caption, {}, {}};
  for (const Row& row : rows) {
    std::vector<std::string>& texts = table.rows.emplace_back();
    for (const Field& field : row) {
      const bool here = field.in == In::all || field.in == In::tables ||
                        (page ? field.in == In::page : field.in == In::files || field.in == In::csv);
      if (!here) continue;
      if (&row == &rows.front()) table.header.push_back(heading_of(field, page));
      texts.push_back(page ? field.value.on(field.on_pages) : field.value.exact());
    }
  }
  return table;
}

}  // namespace

OrderedJson Value::json() const {
  return std::visit(
      [](const auto& value) -> OrderedJson {
        if constexpr (std::same_as<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      value_);
}

std::string Value::exact() const {
  if (const auto* number = std::get_if<double>(&value_)) return to_exact_text(*number);
  return on({});
}

std::string Value::on(const OnPages& page) const {
  if (const auto* number = std::get_if<double>(&value_)) return page.written(page.scale * *number);
  if (const auto* text = std::get_if<std::string>(&value_)) return *text;
  if (const auto* truth = std::get_if<bool>(&value_)) return *truth ? "yes" : "no";
  if (const auto* whole = std::get_if<long>(&value_)) return std::to_string(*whole);
  return "";
}

Row operator+(Row first, const Row& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

OrderedJson json_of(const Row& row) {
  OrderedJson all = OrderedJson::object();
  for (const Field& field : row) {
    if (field.in != In::all && field.in != In::files && field.in != In::json) continue;
    OrderedJson* at = &all;
    std::size_t begin = 0;
    for (std::size_t dot = field.name.find('.'); dot != field.name.npos; dot = field.name.find('.', begin)) {
      at = &(*at)[field.name.substr(begin, dot - begin)];
      begin = dot + 1;
    }
    (*at)[field.name.substr(begin)] = field.value.json();
  }
  return all;
}

OrderedJson json_of(const std::vector<Row>& rows) {
  OrderedJson all = OrderedJson::array();
  for (const Row& row : rows) all.push_back(json_of(row));
  return all;
}

std::string record_text(const OrderedJson& record) {
  return record.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string csv_of(const std::vector<Row>& rows) {
  return rows.empty() ? "" : to_csv(made_of(rows, "", false));
}

Table table_of(const std::vector<Row>& rows, const std::string& caption) {
  return made_of(rows, caption, true);
}

void add_table(std::vector<Table>& tables, const std::vector<Row>& rows, const std::string& caption) {
  if (!rows.empty()) tables.push_back(table_of(rows, caption));
}

}  // namespace hair
