// STAFF ONLY. Reads numbers in the cells of tables.
#pragma once

#include <optional>
#include <string>

namespace grader::inline text {

// Reads "10", "10.00", "10,00"; returns nothing for other texts.
std::optional<double> number_in(const std::string& cell);

}  // namespace grader::text
