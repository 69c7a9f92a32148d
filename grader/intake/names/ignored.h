// STAFF ONLY. Names that operating systems leave behind and no student writes: they are skipped without a
// line, with all files below them, and use up no limit.
#pragma once

#include <string_view>

namespace grader::inline intake {

bool is_ignored(std::string_view path);

}  // namespace grader::intake
