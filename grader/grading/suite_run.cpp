// STAFF ONLY. Runs the hidden suite and reads its results.
#include "grader/grading/suite_run.h"

#include <signal.h>
#include <unistd.h>

#include <stdexcept>

#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/start_program.h"

namespace grader::inline grading {
namespace {

constexpr std::size_t kMostOutput = std::size_t{16} << 20;
// The suite's watchdog ends a student's worker long before; this limit is for the suite itself.
constexpr double kMostSeconds = 1200;

// Runs a trusted program with `input` on its standard input, and returns its standard output.
std::string run_trusted(const std::filesystem::path& program, const std::string& input) {
  Pipe in = make_pipe(), out = make_pipe();
  const std::string name = program.string();
  const pid_t process =
      hair::start_program({.words = {name}, .input = in.read_end.get(), .output = out.write_end.get()});
  in.read_end.close();
  out.write_end.close();
  if (write(in.write_end.get(), input.data(), input.size()) != static_cast<ssize_t>(input.size()))
    throw std::runtime_error(name + " does not read its job");
  in.write_end.close();
  const std::string output = read_all(out.read_end, kMostOutput, kMostSeconds);
  out.read_end.close();
  if (output.empty() || output.back() != '\n')
    kill(process, SIGKILL);  // it has not ended, and we don't wait for it
  const std::optional<int> code = hair::exit_code_of(process);
  if (code != 0)
    throw std::runtime_error(name + " failed " +
                             (code ? "with exit code " + std::to_string(*code) : "by a signal"));
  return output;
}

}  // namespace

SuiteResult run_suite(const std::filesystem::path& suite, const SuiteJob& job) {
  const std::string output = run_trusted(suite, to_json(job));
  try {
    return from_json_text<SuiteResult>(output, suite.string());
  } catch (const BadInput& error) {  // our own error, not the input's
    throw std::runtime_error(error.what());
  }
}

}  // namespace grader::grading
