// STAFF ONLY. Starts Slurm's programs, and reads their answers.
#include "grader/class_folder/slurm.h"

#include <set>
#include <sstream>

#include "grader/course/input.h"
#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/start_program.h"

namespace grader::inline class_folder {
namespace {

constexpr std::size_t kMostOutput = std::size_t{64} << 20;
constexpr double kLongest = 1e7;  // in seconds: a cluster's queue may be long

// Runs a line of a shell with these arguments, and returns its output. `well` gets true if it ends by 0.
std::string ask(const std::string& line, std::vector<std::string> words = {}, bool* well = nullptr) {
  Pipe out = make_pipe();
  words.insert(words.begin(), {"/bin/sh", "-c", line, "sh"});
  const pid_t process = hair::start_program({.words = words, .output = out.write_end.get()});
  out.write_end.close();
  const std::string text = read_all(out.read_end, kMostOutput, kLongest);
  const bool ended_well = hair::exit_code_of(process) == 0;
  if (well != nullptr) *well = ended_well;
  return text;
}

}  // namespace

SentJob sbatch(std::vector<std::string> words, const std::string& options, const std::string& command) {
  words.insert(words.begin(), {"--parsable", "--job-name=hairgrade", "--requeue", "--open-mode=append",
                               "--ntasks=1", "--mem=3G"});
  words.push_back("--wrap=" + command);
  bool well = false;
  const std::string answer = ask("exec sbatch \"$@\" " + options, words, &well);
  const std::string job = answer.substr(0, answer.find_first_not_of("0123456789"));
  if (job.empty()) throw BadInput("sbatch does not take the job; its line is above");
  return {job, !well};
}

void scancel(const std::string& job) {
  ask("exec scancel \"$1\"", {job});
}

std::size_t max_array_size() {
  std::size_t most = 0;
  if (std::istringstream(ask("scontrol show config | sed -n 's/^MaxArraySize *= *//p'")) >> most && most > 0)
    return most;
  throw BadInput("scontrol show config names no MaxArraySize above 0; is this a machine of a Slurm cluster?");
}

bool TaskState::is_under_way() const {
  // A task that is queued again is COMPLETING first.
  static const std::set<std::string> all{"PENDING",  "RUNNING",    "CONFIGURING",  "SUSPENDED",
                                         "REQUEUED", "COMPLETING", "REQUEUE_HOLD", "SIGNALING",
                                         "STOPPED",  "RESIZING"};
  return all.contains(state);
}

std::map<std::size_t, TaskState> tasks_of(const std::string& job) {
  std::map<std::size_t, TaskState> all;
  bool well = false;
  // Asked for a job that it has forgotten, squeue would fail as if no controller answered.
  std::istringstream tasks(ask(
      "exec squeue --user=\"$(id -un)\" --noheader --array --states=all --format='%F %K %T %N'", {}, &well));
  if (!well) throw BadInput("squeue does not answer; its line is above");
  for (std::string line; std::getline(tasks, line);) {
    std::istringstream words(line);
    std::string of, number;
    TaskState state;
    words >> of >> number >> state.state >> state.node;
    if (of == job) all[number == "N/A" ? 0 : std::stoul(number)] = state;
  }
  return all;
}

}  // namespace grader::class_folder
