// STAFF ONLY. An archive's reader in a sandbox, and what it says. It begins with two open descriptors: the
// archive, and one end of a conversation about it.
//
//   intake -> reader             reader -> intake
//
//                                hello, once its limits and its system call filter are on
//                                done(the entries) | cannot_load(why)
//   request(entry, most bytes)   done(its bytes) | threw(why this one can't be read) | cannot_load(why)
//
// Entries are asked for in ascending order. "cannot_load" is about the whole archive, and the last word.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>
#include <vector>

#include "grader/intake/archive.h"
#include "grader/intake/container.h"

namespace grader::inline intake {

enum : int { kArchive = 3, kConversation = 4 };

struct ReaderLimits {
  int cpu_seconds = 0;
  std::size_t memory_bytes = 0;
};

// From now on this process reads what is open, computes, and writes to the conversation. Ends it if that
// can't be had.
void lock_reader(const ReaderLimits& limits);

// Reads the archive and answers until nobody asks any more.
void serve_archive(const std::string& shown, ArchiveLimits limits);

// The list of entries as bytes.
std::vector<std::byte> packed_entries(const std::vector<Entry>& entries);

// The same back. Nothing in it is trusted: throws MalformedMessage for more than `most` entries, for a path
// that is too long, and for anything else that no reader says.
std::vector<Entry> unpacked_entries(std::vector<std::byte> bytes, std::size_t most);

}  // namespace grader::intake
