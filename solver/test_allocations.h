// STAFF ONLY. The number of allocations with new and malloc that this program's own code has made.
#pragma once

namespace reference_tests {

long allocations();

}  // namespace reference_tests
