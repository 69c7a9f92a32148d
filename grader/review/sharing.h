// STAFF ONLY. Shares items out to TAs, and says how far each is.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "grader/review/items.h"

namespace grader::inline review {

enum class ShareBy { section, evenly };

// Returns owners for items that have none of `graders` as owner: others keep theirs. By section, all items of
// a section are one TA's (of a group, the section of most); sections go to the TA who has fewest people. Evenly,
// a person's items are one TA's, the one who has fewest. `people` say who is in which section.
std::map<RowOfItem, std::string> shared_out(const std::vector<Item>& items,
                                            const std::vector<std::string>& graders, ShareBy by,
                                            const std::vector<ClassLine>& people);

struct ProgressOfTa {
  std::string who;                     // "": items that are nobody's
  std::size_t items = 0, decided = 0;  // are hers, and of these
  std::size_t decided_in_all = 0;      // by her, also others' items
};
std::vector<ProgressOfTa> progress(const std::vector<Item>& items);

// An item that somebody has open counts as such until so long after the last heartbeat.
inline constexpr std::chrono::seconds kOpenFor = std::chrono::minutes(3);
// Returns the TA, other than `who`, who has it open; "": nobody.
std::string open_by_other(const Item& item, const std::map<RowOfItem, DeskRow>& rows, const std::string& who,
                          std::int64_t now);

}  // namespace grader::review
