// STAFF ONLY. The number of allocations with new that this program has made.
#pragma once

namespace reference_tests {

long allocations();

}  // namespace reference_tests
