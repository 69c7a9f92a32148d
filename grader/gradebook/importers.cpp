// STAFF ONLY. Reads gradebooks as learning systems do.
#include "grader/gradebook/importers.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace grader::inline gradebook {
namespace {

using std::string, std::vector;
using Row = vector<string>;

// This reader is independent of our writer, which it tests.
vector<Row> rows_of(const string& csv, char separator) {
  vector<Row> rows;
  Row row{""};
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      row.back() += csv[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == separator) {
      row.emplace_back();
    } else if (!quoted && (c == '\n' || c == '\r')) {
      if (row.size() > 1 || !row[0].empty()) rows.push_back(row);
      row = {""};
    } else {
      row.back() += c;
    }
  }
  if (row.size() > 1 || !row[0].empty()) rows.push_back(row);
  return rows;
}

// formats.md:34: it comes from the first three lines.
char separator_of_canvas(const string& csv) {
  std::istringstream lines(csv);
  string line;
  std::ptrdiff_t commas = 0, semicolons = 0;
  for (int i = 0; i < 3 && std::getline(lines, line); ++i) {
    commas += std::ranges::count(line, ',');
    semicolons += std::ranges::count(line, ';');
  }
  return semicolons > commas ? ';' : ',';
}

// formats.md:35: the last point or comma is the decimal one.
string canvas_number(const string& cell) {
  static const std::regex number("^-?[0-9.,]+%?$");
  if (!std::regex_match(cell, number)) return cell;
  string plain;
  const std::size_t last = cell.find_last_of(".,");
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (cell[i] != '.' && cell[i] != ',')
      plain += cell[i];
    else if (i == last)
      plain += '.';
  return plain;
}

string number_of(const string& title) {
  static const std::regex form("\\((\\d+)\\)$");
  std::smatch match;
  return std::regex_search(title, match, form) ? match[1].str() : "";
}

vector<Row> canvas_rows(const string& csv) {
  vector<Row> rows = rows_of(csv, separator_of_canvas(csv));
  for (Row& row : rows)
    for (string& cell : row) cell = canvas_number(cell);
  return rows;
}

bool is_about_columns(const Row& row) {
  return row[0].find("Points Possible") != string::npos || std::ranges::all_of(row, [](const string& cell) {
           return cell.empty() || cell == "Manual Posting";
         });
}

}  // namespace

Imported import_into_canvas(const string& csv, const string& exported, const string& assignment) {
  Imported found;
  const vector<Row> rows = canvas_rows(csv), before = canvas_rows(exported);
  const Row &head = rows.at(0), &known = before.at(0);
  // formats.md:33
  const bool header =
      head.size() > 3 && head[0].find("Student") != string::npos && head[1] == "ID" &&
      std::ranges::any_of(head, [](const string& cell) { return cell.find("Section") != string::npos; });
  if (!header) found.refused.emplace_back("formats.md:33: Invalid header row");
  std::map<string, const Row*> people;
  for (const Row& row : before)
    if (row.size() > 1) people[row[1]] = &row;
  for (std::size_t i = 4; i < head.size(); ++i) {
    if (head[i].find("Score") != string::npos) continue;  // formats.md:37: totals
    const string number = number_of(head[i]);
    const bool is_known = std::ranges::any_of(known, [&](const string& title) {
      return title == head[i] || (!number.empty() && number_of(title) == number);
    });
    if (!is_known) found.new_assignments.push_back(head[i]);  // formats.md:36
  }
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Row& row = rows[r];
    if (is_about_columns(row)) {
      if (std::ranges::find(before, row) == before.end())
        found.refused.emplace_back("formats.md:38: the row of points has changed");
      continue;
    }
    if (!people.contains(row.at(1))) {
      found.new_people.push_back(row[0]);  // formats.md:36
      continue;
    }
    const Row& old = *people[row[1]];
    for (std::size_t i = 4; i < row.size() && i < head.size(); ++i) {
      const std::size_t column = static_cast<std::size_t>(std::ranges::find(known, head[i]) - known.begin());
      const string was = column < old.size() ? old[column] : "";
      if (row[i] == was) continue;
      if (number_of(head[i]) == assignment)
        found.scores[row[1]] = row[i];
      else
        found.refused.push_back("formats.md:38: another column changes: " + head[i]);
    }
  }
  return found;
}

Imported import_into_moodle(const string& csv, const std::map<string, string>& participants,
                            bool decimal_comma) {
  Imported found;
  const vector<Row> rows = rows_of(csv, ',');
  const Row& head = rows.at(0);
  const auto column = [&](const char* title) {
    return static_cast<std::size_t>(std::ranges::find(head, title) - head.begin());
  };
  const std::size_t id = column("Identifier"), grade = column("Grade"), of = column("Maximum grade"),
                    locked = column("Grade can be changed");
  // formats.md:63
  for (const char* title : {"Identifier", "Grade", "Last modified (grade)"})
    if (column(title) == head.size()) found.refused.push_back(string("formats.md:63: no column ") + title);
  if (!found.refused.empty()) return found;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Row& row = rows[r];
    if (row.size() != head.size()) {
      found.refused.emplace_back("formats.md:67: a row with a wrong column count aborts all");
      return found;
    }
    const string number = row[id].substr(string("Participant ").size());  // formats.md:64
    const auto known = participants.find(number);
    if (known == participants.end() || row[grade].empty() || row[grade] == known->second)
      continue;  // formats.md:65
    string points = row[grade], maximum = of < row.size() ? row[of] : "";
    if (decimal_comma) {
      std::ranges::replace(points, ',', '.');  // formats.md:66
      std::ranges::replace(maximum, ',', '.');
    }
    if (points.find_first_not_of("0123456789.") != string::npos) {
      found.refused.push_back("formats.md:66: no number: " + row[grade]);
      continue;
    }
    const bool in_range = maximum.empty() || std::stod(points) <= std::stod(maximum);
    if (!in_range || (locked < row.size() && row[locked] == "No"))
      found.refused.push_back("formats.md:65: passed over: " + number);
    else
      found.scores[number] = points;
  }
  return found;
}

Imported import_into_brightspace(const string& csv, const vector<string>& items) {
  Imported found;
  const vector<Row> rows = rows_of(csv, ',');
  const Row& head = rows.at(0);
  // formats.md:102
  if (head[0] != "OrgDefinedId" && head[0] != "Username")
    found.refused.emplace_back("formats.md:102: no column of ids");
  if (head.back() != "End-of-Line Indicator")
    found.refused.emplace_back("formats.md:102: no end-of-line indicator");
  for (std::size_t i = 0; i + 1 < head.size(); ++i)
    if (head[i] != "OrgDefinedId" && head[i] != "Username" &&
        std::ranges::find(items, head[i]) == items.end())
      found.new_assignments.push_back(head[i]);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].size() != head.size() || rows[r].back() != "#")
      found.refused.emplace_back("formats.md:102: a row does not end with #");
    else
      found.scores[rows[r][0]] = rows[r][head.size() - 2];
  }
  return found;
}

Imported import_into_autolab(const string& csv, std::size_t problems) {
  Imported found;
  for (const Row& row : rows_of(csv, ',')) {
    // formats.md:88: no header; an e-mail, a value for each problem, and a word
    const bool fits =
        row.size() == problems + 2 && row[0].find('@') != string::npos &&
        (row.back().empty() || row.back() == "normal" || row.back() == "zeroed" || row.back() == "excused");
    string values;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      if (row[i].find_first_not_of("0123456789.") != string::npos)
        found.refused.push_back("formats.md:88: no number: " + row[i]);
      values += row[i] + "|";
    }
    if (fits)
      found.scores[row[0]] = values + row.back();
    else
      found.refused.push_back("formats.md:88: " + row[0]);
  }
  return found;
}

}  // namespace grader::gradebook
