// STAFF ONLY. Runs hairprobe in sandboxes, to test their layers.
#include "grader/sandbox/fences.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>
#include <vector>

#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/processes/identity.h"

namespace grader::inline sandbox {

namespace {

// Listens on a port of the loopback that the machine chooses, and returns it. Throws std::system_error if
// there is none.
int listen_on(const Descriptor& socket) {
  constexpr int kWaiting = 8;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  if (bind(socket.get(), plain, size) != 0 || listen(socket.get(), kWaiting) != 0 ||
      getsockname(socket.get(), plain, &size) != 0)
    throw std::system_error(errno, std::generic_category(), "a server on the loopback");
  return ntohs(address.sin_port);
}

constexpr double kMostSeconds = 60;

struct Tried {
  Ending ending;
  std::string said;
};

Tried tries(const Sandbox& sandbox, const std::vector<std::string>& arguments,
            const SandboxedProcess::LeaveOut& leave_out) {
  std::vector<std::string> command = {"/probe"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Pipe output = make_pipe();
  SandboxedProcess process(sandbox, command, -1, -1, output.write_end.get(), leave_out);
  output.write_end.close();
  std::string said = read_all(output.read_end, 1000, kMostSeconds);
  return {process.wait(kMostSeconds), said};
}

// True if a process that the probe has left behind still lives. `number` is its number outside, or empty.
bool lives(const std::string& number) {
  pid_t process = 0;
  std::from_chars(number.data(), number.data() + number.size(), process);
  return process > 1 && (kill(process, 0) == 0 || errno == EPERM);
}

}  // namespace

std::string open_fence(const Sandbox& sandbox, const SandboxedProcess::LeaveOut& leave_out) {
  // The probe exits with 0 if its attempt is stopped; otherwise it prints the attempt.
  const Tried starts = tries(sandbox, {"start"}, leave_out);
  if (!starts.ending.well())
    return "no program starts in it: " + (starts.said.empty() ? "no reason is given\n" : starts.said);

  const StagingFolder staff;
  const std::vector<std::string> attempts[] = {
      {"processes", std::to_string(getpid())}, {"files", staff.path()}, {"rights"}};
  Sandbox open = sandbox;
  open.syscalls.reset();  // tests each layer alone
  for (const auto& arguments : attempts)
    if (const Tried tried = tries(open, arguments, leave_out); !tried.ending.well())
      return "student code " + tried.said;

  Sandbox filtered = sandbox;
  filtered.syscalls = Syscalls::toolchain;
  if (const Tried tried = tries(filtered, {"network"}, leave_out); !tried.ending.well())
    return "student code " + tried.said;

  if (sandbox.isolation == Isolation::namespaces) {  // containers have the filter alone
    const Descriptor server(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (const Tried tried = tries(open, {"reach", std::to_string(listen_on(server))}, leave_out);
        !tried.ending.well())
      return "student code " + tried.said;
  }

  if (sandbox.isolation == Isolation::container) {  // only here a process has the same number inside
    if (const Tried tried = tries(open, {"stay"}, leave_out); lives(tried.said))
      return "a process of student code outlives its run";
    Sandbox small = open;
    small.limits.memory_bytes = std::size_t{64} << 20;
    if (!tries(small, {"memory", std::to_string(std::size_t{512} << 20)}, leave_out).ending.out_of_memory)
      return "student code can take more memory than it may";
  }
  return {};
}

}  // namespace grader::sandbox
