// STAFF ONLY. A change of a solution's file, which gives a sample its bug: lines of the solution, which occur
// once, and their replacement.
//
//   -  double k = strand.stretch_rigidity / l0;    this line is removed
//   =  double l0 = strand.rest_length(i);          this line stays: it shows the place
//   +  double k = strand.stretch_rigidity;         this line is added
#pragma once

#include <string>
#include <vector>

namespace grader::inline samples {

struct EditLine {
  char mark = '=';
  std::string text;
};

struct Edit {
  std::string where;  // "H1.samples:12", for messages
  std::string file;   // "stretch_springs.cpp"
  std::vector<EditLine> lines;
};

// Returns the text with all edits that name the file. Each searches its lines in the original text. Throws
// BadInput if they are missing, or occur several times.
std::string edited(const std::string& text, const std::string& file, const std::vector<Edit>& edits);

}  // namespace grader::samples
