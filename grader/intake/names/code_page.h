// STAFF ONLY. Decodes names in archives: they are UTF-8 if their bytes are. For others no archive names the
// code page reliably: zip has a flag, which some programs set for any bytes, and others never. So it is
// guessed from all names of an archive together, and the guess is reported.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

// Changes names into UTF-8 and returns their code page ("GB18030"); "" if all were UTF-8 already. It always
// finds one.
std::string decode_names(std::vector<std::string>& names);

}  // namespace grader::intake
