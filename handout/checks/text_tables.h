// The tables of an exercise's text that its checks point to: categories with their points, and "what you see".
#pragma once

#include <string>
#include <vector>

namespace checks {

struct TextTables {
  struct Category {
    std::string title;
    std::string points;
  };
  struct Row {
    std::string seen, look;  // in plain letters
  };
  std::vector<Category> categories;
  std::vector<Row> symptoms;
};

// Empty tables if the text can't be read.
TextTables read_text_tables(const std::string& path);

// Without the signs of Markdown and LaTeX: "$k = 2 EI/\bar l$" becomes "k = 2 EI/l".
std::string plain(const std::string& text);

}  // namespace checks
