// STAFF ONLY. A change of a solution's file, by which a sample gets its bug: lines of the solution, which
// stand there once, and what takes their place.
//
//   -  double k = strand.stretch_rigidity / l0;    this line goes
//   =  double l0 = strand.rest_length(i);          this one stays: it says where
//   +  double k = strand.stretch_rigidity;         this one comes
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

// The text with all edits that name the file. Each looks for its lines in the text as it was. Throws BadInput
// if they are not there, or several times.
std::string edited(const std::string& text, const std::string& file, const std::vector<Edit>& edits);

}  // namespace grader::samples
