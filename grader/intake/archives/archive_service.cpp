// STAFF ONLY. Serves an archive's contents from inside the sandbox.
#include "grader/intake/archives/archive_service.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <new>
#include <numeric>
#include <optional>

#include "grader/sandbox/system_calls/syscalls.h"
#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader::inline intake {
namespace {

void limit_to(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  if (setrlimit(resource, &value) != 0) _exit(120);
}

void say(Channel& channel, Kind kind, const Refused& why) {
  MessageWriter message;
  message.put(static_cast<std::uint8_t>(dynamic_cast<const Unreadable*>(&why) != nullptr));
  message.put(std::string(why.what()));
  channel.send(kind, 0, message.bytes());
}

struct Asked {
  std::size_t entry, most;
};

std::optional<Asked> next_question(Channel& channel) {
  const std::optional<Message> message = channel.receive(2 * sizeof(std::uint64_t));
  if (!message) return {};
  MessageReader body(message->body);
  const auto entry = body.get<std::uint64_t>();
  return Asked{entry, body.get<std::uint64_t>()};
}

void answer_questions(Channel& channel, Archive& archive, std::size_t entries) {
  std::optional<Asked> asked = next_question(channel);
  if (!asked) return;
  std::vector<std::size_t> all(entries);
  std::iota(all.begin(), all.end(), std::size_t{0});
  archive.visit(all, [&](std::size_t index, const Container::Read& read) {
    if (index != asked->entry) return;
    try {
      const std::string bytes = read(asked->most);
      channel.send(Kind::done, index, std::as_bytes(std::span(bytes)));
    } catch (const Refused& why) {
      say(channel, Kind::threw, why);
    }
    asked = next_question(channel);
    if (!asked) _exit(0);
  });
}

}  // namespace

void lock_reader(const ReaderLimits& limits) {
  limit_to(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu_seconds), static_cast<rlim_t>(limits.cpu_seconds) + 1);
  limit_to(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
  limit_to(RLIMIT_FSIZE, 0, 0);
  limit_to(RLIMIT_NOFILE, 32, 32);
  limit_to(RLIMIT_CORE, 0, 0);
  signal(SIGPIPE, SIG_IGN);
  restrict_syscalls(Syscalls::compute);
}

void serve_archive(const std::string& shown, ArchiveLimits limits) {
  Channel channel(kConversation, kConversation);
  channel.send(Kind::hello, 0);
  try {
    Archive archive(Descriptor(kArchive), shown, limits);
    const std::vector<Entry> entries = archive.list();
    channel.send(Kind::done, 0, packed_entries(entries));
    answer_questions(channel, archive, entries.size());
  } catch (const Refused& why) {
    say(channel, Kind::cannot_load, why);
  } catch (const std::bad_alloc&) {
    channel.send(Kind::out_of_memory, 0);
  }
}

std::vector<std::byte> packed_entries(const std::vector<Entry>& entries) {
  MessageWriter message;
  message.put(static_cast<std::uint64_t>(entries.size()));
  for (const Entry& entry : entries) {
    message.put(entry.shown)
        .put(static_cast<std::uint8_t>(entry.kind))
        .put(static_cast<std::uint8_t>(entry.encrypted))
        .put(static_cast<std::uint64_t>(entry.bytes));
  }
  return message.bytes();
}

std::vector<Entry> unpacked_entries(std::vector<std::byte> bytes, std::size_t most) {
  MessageReader message(std::move(bytes));
  const auto count = message.get<std::uint64_t>();
  if (count > most)
    throw MalformedMessage(std::to_string(count) + " entries; at most " + std::to_string(most));
  std::vector<Entry> entries;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string path = message.get_document();
    if (path.size() > kLongestPath)
      throw MalformedMessage("a path of " + std::to_string(path.size()) + " bytes");
    const auto kind = message.get<std::uint8_t>();
    if (kind > static_cast<std::uint8_t>(Entry::Kind::special))
      throw MalformedMessage("an entry of kind " + std::to_string(kind));
    // The path is interpreted here, outside the sandbox, as for any other container.
    Entry& entry = entries.emplace_back(entry_at(path));
    entry.kind = static_cast<Entry::Kind>(kind);
    entry.encrypted = message.get<std::uint8_t>() != 0;
    entry.bytes = message.get<std::uint64_t>();
  }
  message.expect_end();
  return entries;
}

}  // namespace grader::intake
