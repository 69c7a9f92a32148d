// STAFF ONLY. Starts an archive's reader in a sandbox and asks it for entries.
#include "grader/intake/archives/sandboxed_archive.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archives/archive_service.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/system_mounts.h"
#include "grader/sandbox/watchdog.h"
#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader::inline intake {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "hairintake";
constexpr std::size_t kLargestList = std::size_t{256} << 20;  // bounds the longest paths of a class
constexpr std::size_t kLargestReason = 4096;
constexpr std::size_t kMemory = std::size_t{3} << 29;  // fits a nested archive in a text that doubles

// Slow machines unpack ten megabytes a second.
int cpu_seconds(ArchiveLimits limits) {
  return static_cast<int>(std::min<std::size_t>(5 + limits.unpacked_bytes / 10'000'000, 7200));
}

// It also waits for disks, which read ten megabytes a second at least; wall time counts its waits for a
// processor, too.
Watchdog::Patience patience(ArchiveLimits limits, int archive) {
  struct stat status = {};
  const double megabytes = fstat(archive, &status) == 0 ? 1e-6 * static_cast<double>(status.st_size) : 0;
  const double most = cpu_seconds(limits);
  return {.idle_seconds = 5 + megabytes / 10, .cpu_seconds = most + 1, .wall_seconds = 120 + 4 * most};
}

Pipe make_conversation() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

class SandboxedArchive : public Container {
 public:
  SandboxedArchive(const Sandbox& sandbox, const ArchiveSource& source, std::string shown,
                   ArchiveLimits limits)
      : shown_(std::move(shown)),
        limits_(limits),
        archive_(opened(source, shown_)),
        conversation_(make_conversation()),
        process_(sandbox, command(), archive_.get(), conversation_.write_end.get(), said_.write_end.get()),
        watchdog_(process_, patience(limits, archive_.get())),
        channel_(conversation_.read_end.get(), conversation_.read_end.get(),
                 [this](int descriptor, short events) { return watchdog_.wait_for(descriptor, events); }) {
    conversation_.write_end.close();
    said_.write_end.close();
    archive_.close();
    const std::optional<Message> hello = channel_.receive(0);
    if (!hello || hello->kind != Kind::hello)
      throw std::runtime_error("no reader of archives starts: " +
                               printable(read_all(said_.read_end, 1000, 1)));
  }

  std::vector<Entry> list() override {
    try {
      return unpacked_entries(reply(kLargestList).body, limits_.entries);
    } catch (const MalformedMessage& error) {
      fail("broke its protocol: " + std::string(error.what()));
    }
  }

  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t, const Read&)>& take) override {
    for (const std::size_t index : indices) {
      take(index, [&](std::size_t most) { return read(index, most); });
      // A caller may go on after one bad entry. A failure of the whole archive is final.
      if (broken_) throw Unreadable(*broken_);
    }
  }

 private:
  std::vector<std::string> command() const {
    return {std::string("/") + kProgram,     std::to_string(cpu_seconds(limits_)),
            std::to_string(kMemory),         std::to_string(limits_.unpacked_bytes),
            std::to_string(limits_.entries), shown_};
  }

  std::string read(std::size_t index, std::size_t most) {
    if (broken_) throw Unreadable(*broken_);
    MessageWriter question;
    question.put(static_cast<std::uint64_t>(index)).put(static_cast<std::uint64_t>(most));
    try {
      channel_.send(Kind::request, 0, question.bytes());  // a reader that is gone never answers
      const Message answer = reply(std::max(most, kLargestReason));
      if (answer.body.size() > most) throw MalformedMessage("more bytes than it was asked for");
      return {reinterpret_cast<const char*>(answer.body.data()), answer.body.size()};
    } catch (const MalformedMessage& error) {
      fail("broke its protocol: " + std::string(error.what()));
    }
  }

  // Throws Refused for a request that failed.
  Message reply(std::size_t limit) {
    std::optional<Message> message = channel_.receive(limit);
    if (!message) fail(ended());
    switch (message->kind) {
      case Kind::done:
        return std::move(*message);
      case Kind::threw:
      case Kind::cannot_load:
        refuse(message->kind == Kind::cannot_load, MessageReader(std::move(message->body)));
      case Kind::out_of_memory:
        fail("ran out of memory");
      default:
        throw MalformedMessage("an unknown kind of message");
    }
  }

  [[noreturn]] void refuse(bool whole, MessageReader body) {
    const bool unreadable = body.get<std::uint8_t>() != 0;
    std::string why = body.get_text();
    std::replace_if(
        why.begin(), why.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    if (whole) broken_ = why;
    if (unreadable) throw Unreadable(why);
    throw Refused(why);
  }

  std::string ended() {
    const bool asleep = watchdog_.waited_in_vain();
    const Ending ending = process_.wait(asleep ? 0 : 1);
    if (ending.out_of_memory) return "ran out of memory";
    if (ending.timed_out || asleep) return "took too long";
    return ending.signal != 0 ? "ended by signal " + std::to_string(ending.signal)
                              : "ended with code " + std::to_string(ending.code);
  }

  [[noreturn]] void fail(const std::string& how) {
    broken_ = shown_ +
              " can't be read: it is damaged, or larger than it seems. Pack it again, and check that "
              "it opens.";
    process_.kill();
    throw Unreadable(*broken_, "the reader of " + shown_ + " " + how);
  }

  std::string shown_;
  ArchiveLimits limits_;
  Descriptor archive_;
  Pipe conversation_, said_ = make_pipe();
  SandboxedProcess process_;
  Watchdog watchdog_;
  Channel channel_;
  std::optional<std::string> broken_;  // is the student's reason why nothing more can be read
};

// `program` is the reader.
Sandbox reader_sandbox(const fs::path& program, Isolation isolation) {
  Sandbox sandbox;
  sandbox.isolation = isolation;
  sandbox.roots = program.parent_path() / "roots";
  sandbox.mounts = library_mounts(isolation, {program});
  sandbox.mounts.push_back({program, std::string("/") + kProgram});
  sandbox.limits.memory_bytes = kMemory;
  sandbox.limits.processes = 4;
  return sandbox;
}

}  // namespace

SandboxedReader::SandboxedReader(const fs::path& program, Isolation isolation) {
  if (!fs::exists(program)) throw BadInput(program.string() + " is missing; build the target grading");
  fs::copy_file(program, folder_.path() / kProgram);
  fs::permissions(folder_.path() / kProgram, fs::perms(0755));
  sandbox_ = reader_sandbox(folder_.path() / kProgram, isolation);
}

OpenArchive SandboxedReader::opener() const {
  return [this](const ArchiveSource& source, const std::string& shown, ArchiveLimits limits) {
    return std::make_unique<SandboxedArchive>(sandbox_, source, shown, limits);
  };
}

}  // namespace grader::intake
