// STAFF ONLY. The lines of a file GROUP.samples, sample by sample. sample.h explains them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::inline samples {

struct GroupLine {
  int number = 0;    // in the file, from 1
  std::string key;   // "shows"; or "-", "=", "+", "*": an edit's line
  std::string rest;  // follows the key, and a space
};

struct GroupFile {
  std::filesystem::path path;
  std::vector<GroupLine> common;                // come before the first sample
  std::vector<std::vector<GroupLine>> samples;  // each begins with its line "sample"

  // Throws BadInput with the file and the line's number.
  [[noreturn]] void fail(const GroupLine& line, const std::string& problem) const;

  // Takes a word, or a JSON string, and a space from the beginning of `rest`.
  std::string take_word(const GroupLine& line, std::string& rest) const;

  double number(const GroupLine& line, const std::string& text, double least, double most) const;
};

// Skips comments (#) and empty lines.
GroupFile read_group_file(const std::filesystem::path& path);

}  // namespace grader::samples
