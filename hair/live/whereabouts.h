// Says in which exercise a process is when it crashes, or when it is asked by SIGUSR1: a line "@ H6
// FUNCTION", with the function's name as the linker has it, or none. Only exercises in shared libraries are
// found: student_H6 in libstudent_H6.so.
#pragma once

namespace hair {

void say_whereabouts(int descriptor);

}  // namespace hair
