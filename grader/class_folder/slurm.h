// STAFF ONLY. Slurm, by its programs sbatch, scancel, scontrol and squeue, which PATH finds.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace grader::inline class_folder {

struct SentJob {
  std::string number;
  bool failed = false;  // it was waited for (--wait), and ended otherwise than by exit code 0
};

// Sends a job that runs `command` in a shell. `options` are further words of a shell for sbatch, and come
// last. Throws BadInput if sbatch refuses.
SentJob sbatch(std::vector<std::string> words, const std::string& options, const std::string& command);

void scancel(const std::string& job);
std::size_t max_array_size();  // bounds an array's tasks; throws BadInput if scontrol does not say it

struct TaskState {
  std::string state, node;  // "TIMEOUT", "n2"

  bool is_under_way() const;
};
// Returns states by the number in the array, or 0. Slurm forgets a job some minutes after its end. Throws
// BadInput if squeue does not answer.
std::map<std::size_t, TaskState> tasks_of(const std::string& job);

}  // namespace grader::class_folder
