// Reports the exercise that a process is in when it crashes, or when SIGUSR1 asks: a line "@ H6 FUNCTION",
// with the function's name as the linker has it, or none. It finds only exercises in shared libraries:
// student_H6 in libstudent_H6.so.
#pragma once

namespace hair {

void say_whereabouts(int descriptor);

}  // namespace hair
