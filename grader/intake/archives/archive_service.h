// STAFF ONLY. The protocol of an archive's reader in a sandbox. The reader begins with two open descriptors:
// the archive, and a socket to intake.
//
//   intake -> reader             reader -> intake
//
//                                hello, once its limits and its system call filter are on
//                                done(the entries) | cannot_load(why)
//   request(entry, most bytes)   done(its bytes) | threw(why this one can't be read) | cannot_load(why)
//
// Entries are asked for in ascending order. "cannot_load" is about the whole archive, and the last message.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>
#include <vector>

#include "grader/intake/archives/archive.h"
#include "grader/intake/archives/container.h"

namespace grader::inline intake {

enum : int { kArchive = 3, kConversation = 4 };

struct ReaderLimits {
  int cpu_seconds = 0;
  std::size_t memory_bytes = 0;
};

// Limits this process to reading open files, computing, and writing to the socket. Ends it if the kernel
// refuses the limits.
void lock_reader(const ReaderLimits& limits);

// Reads the archive and answers requests until the socket closes.
void serve_archive(const std::string& shown, ArchiveLimits limits);

// Returns the list of entries as bytes.
std::vector<std::byte> packed_entries(const std::vector<Entry>& entries);

// Returns the list of these bytes. It trusts nothing: it throws MalformedMessage for more than `most`
// entries, for a path that is too long, and for any other deviation from the protocol.
std::vector<Entry> unpacked_entries(std::vector<std::byte> bytes, std::size_t most);

}  // namespace grader::intake
