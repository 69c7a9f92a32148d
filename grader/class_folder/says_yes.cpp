// STAFF ONLY. Asks questions on a terminal.
#include "grader/class_folder/says_yes.h"

#include <unistd.h>

#include <iostream>

namespace grader::inline class_folder {

bool says_yes(const Question& question) {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDERR_FILENO) == 0) return false;
  std::cerr << "hairgrade: " << question.what() << "\nGo on as with " << question.option << "? [y/N] "
            << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "yes";
}

}  // namespace grader::class_folder
