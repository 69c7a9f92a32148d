// Gives memory that nobody sets the same contents in each run, at home as in grading. With filled_blocks.cpp
// a program's malloc fills each block that it returns, and so do `new`, the standard library's containers and
// Eigen's matrices. Otherwise a block keeps its old contents, addresses among them, which differ from run to
// run.
#pragma once

#include <cstddef>

namespace solver {

// The byte that GCC's -ftrivial-auto-var-init=pattern gives to a student's unset variables.
inline constexpr int kUnsetByte = 0xfe;

// Larger blocks come fresh from the kernel, and hold zeros in each run. Filling them would cost programs time
// that only reserve memory.
inline constexpr std::size_t kMostFilled = 1 << 20;

}  // namespace solver
