// Roots of a group of strands, from JSON.
#pragma once

#include <functional>
#include <vector>

#include "hair/io/files/strict_json.h"
#include "hair/strand/rest_shape.h"

namespace hair::json {

// Calls `expect` with the number of roots before making any; it throws for too many.
std::vector<RootFrame> read_roots(const JsonValue& object,
                                  const std::function<void(const JsonValue& where, long count)>& expect);

}  // namespace hair::json
