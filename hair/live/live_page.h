// The page of `hairlab live`.
#pragma once

#include <string>

namespace hair {

std::string live_page(const std::string& name, const std::string& shows);

}  // namespace hair
