// STAFF ONLY. For tests: hairintake after an archive's bytes have taken it over. The archive's beginning
// names the attack: "evil-crash". All other archives are read as they should be.
#include <fcntl.h>
#include <locale.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "grader/intake/archives/archive_service.h"
#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace {

using namespace grader;

void refuse(Channel& channel, const std::string& text) {
  MessageWriter message;
  message.put(std::uint8_t{1}).put(text);
  channel.send(Kind::cannot_load, 0, message.bytes());
}

// Reports which of these files exist, and the file that the archive names.
std::string look(const std::string& secret) {
  std::string found;
  for (const std::string& path :
       {secret, std::string("/etc"), std::string("/home"), std::string("/root"), std::string("/proc"),
        std::string("/dev"), std::string("/tmp"), std::string("/var"), std::string("/usr/bin")}) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 || open(path.c_str(), O_RDONLY) >= 0) found += path + " ";
  }
  return "found: " + found;
}

void attack(const std::string& how, const std::string& rest) {
  Channel channel(kConversation, kConversation);
  channel.send(Kind::hello, 0);
  if (how == "crash") std::abort();
  if (how == "loop")
    for (volatile unsigned i = 0;;) i = i + 1;
  if (how == "sleep")
    for (timespec hour{3600, 0};;) nanosleep(&hour, nullptr);
  if (how == "memory") {
    try {
      std::string(std::size_t{2} << 30, 'x');
    } catch (const std::bad_alloc&) {
      channel.send(Kind::out_of_memory, 0);
    }
  }
  if (how == "socket") refuse(channel, "a socket: " + std::to_string(socket(AF_INET, SOCK_STREAM, 0)));
  if (how == "process") refuse(channel, "a process: " + std::to_string(fork()));
  if (how == "write") refuse(channel, "a file: " + std::to_string(open("/x", O_WRONLY | O_CREAT, 0600)));
  if (how == "look") refuse(channel, look(rest));
  if (how == "leave") _exit(7);
  if (how == "speech") refuse(channel, std::string("\x1b[2J<b>\n\xff ") + std::string(100'000, 'x'));
  if (how == "noise")
    for (int i = 0; i < 1000; ++i) (void)!write(kConversation, "noise ", 6);
  if (how == "boast") channel.send(Kind::done, 0, MessageWriter().put(std::uint64_t{1} << 60).bytes());
  if (how == "half") {  // sends the right list, and then ends
    Entry alice = entry_at("alice/conj_grad.cpp"), bob = entry_at("bob/conj_grad.cpp");
    channel.send(Kind::done, 0, packed_entries({alice, bob}));
    channel.receive(100);
  }
  if (how == "more") {  // sends too many bytes
    channel.send(Kind::done, 0, packed_entries({entry_at("conj_grad.cpp")}));
    channel.receive(100);
    channel.send(Kind::done, 0, std::vector<std::byte>(1001));
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc != 6) return 2;
  setlocale(LC_CTYPE, "C.UTF-8");
  const auto number = [&](int i) { return static_cast<std::size_t>(std::strtoull(argv[i], nullptr, 10)); };
  lock_reader({std::atoi(argv[1]), number(2)});
  std::string head(1000, '\0');
  head.resize(static_cast<std::size_t>(pread(kArchive, head.data(), head.size(), 0)));
  if (head.starts_with("evil-")) {
    const std::size_t end = head.find(' ');
    attack(head.substr(5, end - 5), end == std::string::npos ? "" : head.substr(end + 1));
    return 0;
  }
  serve_archive(argv[5], {number(3), number(4)});
  return 0;
}
