// STAFF ONLY. Asks the person at the terminal.
#pragma once

#include "grader/intake/question.h"
#include "grader/tool/origins.h"

namespace grader {

// True if a person says yes to it. Where the input or the errors are no terminal, nobody is asked.
bool says_yes(const Question& question);

// Does `work`, again after each question that a person says yes to; `word` has the answers. Throws a question without that answer.
template <class Work>
auto asking(CallersWord& word, const Work& work) {
  for (;;) try {
      return work();
    } catch (const Question& question) {
      if (!says_yes(question)) throw;
      (question.option == kSaysClass ? word.choices.classes : word.replace) = true;
    }
}

}  // namespace grader
