// STAFF ONLY. Numbers in the cells of tables.
#pragma once

#include <optional>
#include <string>

namespace grader::inline text {

// "10", "10.00", "10,00"; nothing for what is no number.
std::optional<double> number_in(const std::string& cell);

}  // namespace grader::text
