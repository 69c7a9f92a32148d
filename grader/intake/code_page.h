// STAFF ONLY. Names in archives are UTF-8 if their bytes are. For others no archive says the code page
// reliably: zip has a flag, which some programs set for any bytes, and others never. So it is guessed, by all
// names of an archive together, and said.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

// Changes names that are no UTF-8 into it. Returns the code page ("GB18030"); "" if all were UTF-8 already.
// Always finds one.
std::string decode_names(std::vector<std::string>& names);

}  // namespace grader::intake
