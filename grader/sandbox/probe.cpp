// STAFF ONLY. Tries from inside of a sandbox what student code could try. Exit code 0: it was stopped. 1: it
// succeeded, and standard output says "can ...".
// hairprobe start | files STAFF_FOLDER | processes STAFF_PROCESS | rights | network | reach PORT
//   | fork COUNT | memory BYTES | stay
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

// Prints a success, and returns `succeeded`.
bool did(bool succeeded, const std::string& what) {
  if (succeeded) std::cout << "can " << what << "\n";
  return succeeded;
}

bool opens(const std::string& path, int flags = O_RDONLY) {
  const int file = open(path.c_str(), flags | O_CLOEXEC, 0600);
  if (file >= 0) close(file);
  return file >= 0;
}

bool files(const std::string& folder) {
  return did(opens(folder, O_RDONLY | O_DIRECTORY), "open the staff's folders") ||
         did(opens("/etc/passwd") || opens("/../../../etc/passwd"), "read the system's files") ||
         did(opens("/proc/self/maps"), "read /proc") || did(opens("/x", O_WRONLY | O_CREAT), "write to /");
}

bool processes(pid_t staff) {
  char byte = 0;
  const iovec here{&byte, 1},
      there{reinterpret_cast<void*>(0x400000), 1};  // NOLINT(performance-no-int-to-ptr)
  return did(kill(staff, 0) == 0, "signal the staff's processes") ||
         did(process_vm_readv(staff, &here, 1, &there, 1, 0) >= 0 || errno == EFAULT,
             "read the staff's processes") ||
         did(ptrace(PTRACE_SEIZE, staff, nullptr, nullptr) == 0, "stop the staff's processes");
}

bool rights() {
  return did(geteuid() == 0 || getuid() == 0, "do all that root may: it is root") ||
         did(setuid(0) == 0 || setresgid(0, 0, 0) == 0, "become root") ||
         did(chroot("/") == 0, "change its root folder") ||
         did(mount("none", "/", "tmpfs", 0, nullptr) == 0, "mount file systems") ||
         did(unshare(CLONE_NEWUSER) == 0, "make namespaces");
}

bool network() {
  return did(socket(AF_INET, SOCK_STREAM, 0) >= 0, "reach the network") ||
         did(socket(AF_UNIX, SOCK_STREAM, 0) >= 0, "reach services of this machine");
}

bool reach(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<in_port_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int to = socket(AF_INET, SOCK_STREAM, 0);
  return did(to >= 0 && connect(to, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0,
             "reach servers of this machine");
}

// The processes last until the sandbox ends, or a minute.
bool start_processes(int count) {
  constexpr unsigned kSeconds = 60;
  for (int i = 0; i < count; ++i) {
    const pid_t child = fork();
    if (child < 0) return false;
    if (child == 0) {
      close(STDOUT_FILENO);
      close(STDERR_FILENO);
      sleep(kSeconds);
      _exit(0);
    }
  }
  return did(true, "start " + std::to_string(count) + " processes");
}

bool memory(std::size_t bytes) {
  constexpr std::size_t kPage = 4096;
  auto* taken = static_cast<volatile char*>(std::malloc(bytes));
  for (std::size_t at = 0; taken != nullptr && at < bytes; at += kPage) taken[at] = 1;
  return did(taken != nullptr, "take memory");
}

// Leaves a process behind, in a session of its own, and prints its number.
bool stay() {
  const pid_t child = fork();
  if (child == 0) {
    setsid();
    close(STDOUT_FILENO);
    for (;;) pause();
  }
  std::cout << child << std::flush;
  return false;
}

}  // namespace

int main(int count, char* arguments[]) {
  const std::string what = count > 1 ? arguments[1] : "", argument = count > 2 ? arguments[2] : "";
  if (what == "start") return 0;
  if (what == "files") return files(argument) ? 1 : 0;
  if (what == "processes") return processes(std::atoi(argument.c_str())) ? 1 : 0;
  if (what == "rights") return rights() ? 1 : 0;
  if (what == "network") return network() ? 1 : 0;
  if (what == "reach") return reach(std::atoi(argument.c_str())) ? 1 : 0;
  if (what == "fork") return start_processes(std::atoi(argument.c_str())) ? 1 : 0;
  if (what == "memory") return memory(std::strtoull(argument.c_str(), nullptr, 10)) ? 1 : 0;
  if (what == "stay") return stay() ? 1 : 0;
  return 2;
}
