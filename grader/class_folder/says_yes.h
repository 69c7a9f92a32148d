// STAFF ONLY. Asks the person at the terminal.
#pragma once

#include "grader/intake/submission.h"

namespace grader::inline class_folder {

// True if a person says yes. Without a terminal for input and errors it asks nobody.
bool says_yes(const Question& question);

// Does `work`, again after each question that a person confirms; a yes to --class is kept in `classes`, one
// to --replace in `replace`. Throws a question without a yes.
template <class Work>
auto until_answered(bool& classes, bool& replace, const Work& work) {
  for (;;) try {
      return work();
    } catch (const Question& question) {
      if (!says_yes(question)) throw;
      (question.option == kSaysClass ? classes : replace) = true;
    }
}

}  // namespace grader::class_folder
