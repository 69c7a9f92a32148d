// STAFF ONLY. How often this program has allocated memory with new.
#pragma once

namespace reference_tests {

long allocations();

}  // namespace reference_tests
