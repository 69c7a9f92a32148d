// STAFF ONLY. Shares items out to TAs, and says how far each is.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "grader/review/items.h"

namespace grader::inline review {

enum class ShareBy { section, evenly };

// Returns an owner for each item that has none of the `graders`; all others keep theirs. By section, a
// section is one TA's, whichever items there are, and each TA has about as many people; a group's item
// belongs to the section of most. Evenly, and without a section, a person's items are one TA's, who had the
// fewest.
std::map<RowOfItem, std::string> shared_out(const std::vector<Item>& items,
                                            const std::vector<std::string>& graders, ShareBy by,
                                            const std::vector<ClassLine>& people);

struct ProgressOfTa {
  std::string who;                     // "": nobody's items
  std::size_t items = 0, decided = 0;  // counts this TA's items, and those of them that somebody decided
  std::size_t has_decided = 0;         // counts what this TA decided, also of others
};
std::vector<ProgressOfTa> progress(const std::vector<Item>& items, const std::map<RowOfItem, DeskRow>& rows);

// Limits the time from a heartbeat on in which an item counts as open.
inline constexpr std::chrono::seconds kOpenFor = std::chrono::minutes(3);

// Returns the TA who has it open, other than `who`; "": nobody.
std::string open_by_other(const RowOfItem& row, const std::map<RowOfItem, DeskRow>& rows,
                          const std::string& who, std::int64_t now);

}  // namespace grader::review
