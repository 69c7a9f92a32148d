// STAFF ONLY.
#include "grader/intake/draft.h"

namespace grader {

void IntakeBudget::charge(const std::vector<Entry>& list, const std::vector<std::size_t>& entries) {
  entries_ += entries.size();
  if (entries_ > limits_.entries) {
    throw Refused("More than " + std::to_string(limits_.entries) +
                  " files and folders were handed in. Hand in only the exercise files.");
  }
  for (const std::size_t i : entries) {
    if (list[i].bytes > bytes_left_) {
      throw Refused("What was handed in unpacks to more than " + shown_size(limits_.unpacked_bytes) +
                    ". Hand in only the exercise files.");
    }
    bytes_left_ -= static_cast<std::size_t>(list[i].bytes);
  }
}

void Draft::refuse(const Refused& why) {
  const auto* unreadable = dynamic_cast<const Unreadable*>(&why);
  submission.files.clear();
  submission.problem = why.what();
  submission.unreadable = unreadable != nullptr;
  if (unreadable != nullptr && !unreadable->failure().empty())
    notices.push_back(origin + ": " + unreadable->failure());
}

void LeftOut::add(const std::string& entry_and_reason) {
  if (count++ == 0) first = entry_and_reason;
}

std::vector<std::string> Draft::all_notices() const {
  std::vector<std::string> all = notices;
  for (const LeftOut* left : {&shut, &outdated}) {
    if (left->count == 0) continue;
    const std::string more = left->count > 1 ? ", and " + std::to_string(left->count - 1) + " more" : "";
    all.push_back(origin + ": " + left->first + more);
  }
  return all;
}

std::string problem_of(const Entry& entry, const std::string& shown) {
  switch (entry.kind) {
    case Entry::Kind::symbolic_link:
      return shown + " is a symbolic link. Hand in the file itself.";
    case Entry::Kind::hard_link:
      return shown + " is a link to another file. Hand in the file itself.";
    case Entry::Kind::special:
    case Entry::Kind::folder:
      return shown + " is not a file. Hand in the file itself.";
    case Entry::Kind::file:
      break;
  }
  if (!entry.leads_outside) return "";
  return shown +
         " leads out of the archive. Pack it again without \"..\" and without a path that begins at a root.";
}

}  // namespace grader
