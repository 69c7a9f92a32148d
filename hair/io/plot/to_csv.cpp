#include <string>

#include "hair/io/plot/check_table.h"
#include "hair/io/plot/page.h"

namespace hair {

namespace {

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

}  // namespace

std::string to_csv(const Table& table) {
  plot::check_table(table);
  std::string out = line(table.header);
  for (const std::vector<std::string>& row : table.rows) out += line(row);
  return out;
}

}  // namespace hair
