// STAFF ONLY. Starts sim, and reads its output.
#include "grader/similar/sim.h"

#include <regex>
#include <sstream>
#include <stdexcept>

#include "grader/course/input.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"
#include "hair/io/files/write_file.h"

namespace grader::inline similar {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "/usr/bin/sim_c++";
constexpr std::size_t kMostOutput = std::size_t{1} << 28;

std::size_t number(const std::string& digits) {
  return static_cast<std::size_t>(std::stoul(digits));
}

Lines lines(const std::string& first, const std::string& last) {
  return {std::stoi(first), std::stoi(last)};
}

// Reads "File 3: 522 tokens, 65 lines" and "3: line 5-20  |7: line 8-23[114]"; ignores other lines.
Matches read(const std::string& output, std::size_t texts) {
  static const std::regex kFile(R"(File (\d+): (\d+) tokens.*)");
  static const std::regex kRun(R"((\d+): line (\d+)-(\d+) *\|(\d+): line (\d+)-(\d+) *\[(\d+)\])");
  Matches found;
  found.tokens.assign(texts, -1);
  std::istringstream in(output);
  std::smatch part;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, part, kFile)) {
      if (const std::size_t text = number(part[1]); text < texts) found.tokens[text] = std::stoi(part[2]);
    } else if (std::regex_match(line, part, kRun)) {
      found.all.push_back({number(part[1]), number(part[4]), lines(part[2], part[3]), lines(part[5], part[6]),
                           std::stoi(part[7])});
    }
  }
  return found;
}

}  // namespace

Sim::Sim(Isolation isolation) {
  if (!fs::exists(kProgram))
    throw BadInput(std::string(kProgram) + " is missing; install Debian's package similarity-tester");
  fs::create_directory(folder_.path() / "in");
  sandbox_.isolation = isolation;
  sandbox_.roots = folder_.path() / "roots";
  sandbox_.mounts = library_mounts(isolation, {kProgram});
  sandbox_.mounts.push_back({kProgram, "/sim"});
  sandbox_.mounts.push_back({folder_.path() / "in", "/in"});
  sandbox_.folder = "/in";
  sandbox_.syscalls = Syscalls::toolchain;
  sandbox_.limits.wall_seconds = 3600;
}

std::string Sim::output_of(const std::vector<std::string>& options, std::size_t texts, std::size_t given,
                           int cpu_seconds, bool& well) const {
  std::vector<std::string> command{"/sim", "-n", "-e", "-w", "80"};
  command.insert(command.end(), options.begin(), options.end());
  for (std::size_t i = 0; i < texts; ++i) command.push_back(std::to_string(i));
  if (given > 0) command.emplace_back("/");
  for (std::size_t i = texts; i < texts + given; ++i) command.push_back(std::to_string(i));
  Sandbox sandbox = sandbox_;
  sandbox.limits.cpu_seconds = cpu_seconds;
  sandbox.limits.cpu_seconds_of_all = cpu_seconds;
  Pipe output = make_pipe();
  SandboxedProcess process(sandbox, command, -1, -1, output.write_end.get());
  output.write_end.close();
  std::string text = read_all(output.read_end, kMostOutput, sandbox_.limits.wall_seconds);
  well = process.wait(1).well() && text.size() < kMostOutput;
  return text;
}

Matches Sim::matches(const std::vector<std::string>& texts, const std::vector<std::string>& given, int least,
                     int cpu_seconds) const {
  if (texts.empty()) return {};
  std::size_t name = 0;
  for (const std::vector<std::string>* some : {&texts, &given})
    for (const std::string& text : *some) {
      const fs::path file = folder_.path() / "in" / std::to_string(name++);
      hair::write_file(file, text);
      fs::permissions(file, fs::perms(0644));
    }
  bool well = false;
  const std::string output =
      output_of(given.empty() ? std::vector<std::string>{"-r", std::to_string(least), "-a", "-s"}
                              : std::vector<std::string>{"-r", std::to_string(least), "-S"},
                texts.size(), given.size(), cpu_seconds, well);
  if (!well)
    throw std::runtime_error(
        "sim did not come to an end: " +
        printable(output.substr(output.size() - std::min<std::size_t>(output.size(), 300))));
  Matches found = read(output, texts.size());
  for (Match& match : found.all)
    if (!given.empty()) match.other -= texts.size();
  return found;
}

}  // namespace grader::similar
