#include "text_tables.h"

#include <cctype>
#include <fstream>
#include <utility>

namespace checks {
namespace {

// The cells of a row "| a | b |".
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t begin = 2; begin < row.size();) {
    const std::size_t end = row.find(" |", begin);
    if (end == std::string::npos) break;
    cells.push_back(row.substr(begin, end - begin));
    begin = end + 3;
  }
  return cells;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::string plain(const std::string& text) {
  static const std::pair<const char*, const char*> signs[] = {{"\\lvert ", "|"},
                                                              {" \\rvert", "|"},
                                                              {"\\lvert", "|"},
                                                              {"\\rvert", "|"},
                                                              {"\\mathrel", ""},
                                                              {"\\lVert ", "|"},
                                                              {" \\rVert", "|"},
                                                              {"\\lVert", "|"},
                                                              {"\\rVert", "|"},
                                                              {"\\partial ", "d"},
                                                              {"\\partial", "d"},
                                                              {"\\nabla", "grad "},
                                                              {"\\varphi", "phi"},
                                                              {"\\cdot", "."},
                                                              {"\\times", "x"},
                                                              {"\\bar ", "mean "},
                                                              {"\\hat ", ""},
                                                              {"\\ddot q", "q\""},
                                                              {"\\dot J", "dJ/dt"},
                                                              {"\\text", ""},
                                                              {"\\,", " "},
                                                              {"\\ge", ">="},
                                                              {"\\le", "<="},
                                                              {"{", ""},
                                                              {"}", ""},
                                                              {"\\", ""},
                                                              {"$", ""},
                                                              {"`", ""},
                                                              {"*", ""}};
  std::string result;
  for (const char letter : text) {  // "k\\varphi" is a product
    if (letter == '\\' && !result.empty() && std::isalnum(static_cast<unsigned char>(result.back())) != 0)
      result += ' ';
    result += letter;
  }
  for (const auto& [from, to] : signs) replace_all(result, from, to);
  replace_all(result, "  ", " ");
  return result;
}

TextTables read_text_tables(const std::string& path) {
  TextTables tables;
  std::ifstream in(path);
  bool points = false, symptoms = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("|")) {
      points = symptoms = false;
    } else if (line.starts_with("| category | points |")) {
      points = true;
    } else if (line.starts_with("| what you see | where to look |")) {
      symptoms = true;
    } else if (const std::vector<std::string> cells = cells_of(line); cells.size() >= 2) {
      if (points) tables.categories.push_back({cells[0], cells[1]});
      if (symptoms) tables.symptoms.push_back({plain(cells[0]), plain(cells[1])});
    }
  }
  return tables;
}

}  // namespace checks
