// STAFF ONLY. Names that systems leave behind and that no student writes: they are passed over without a
// word, with all below them, and use up no limit.
#pragma once

#include <string_view>

namespace grader::inline intake {

bool is_ignored(std::string_view path);

}  // namespace grader::intake
