// STAFF ONLY. Keeps submissions with the same name apart.
#include "grader/intake/clashes.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "grader/intake/names/names.h"
#include "grader/intake/names/origin.h"

namespace grader::inline intake {
namespace {

bool comes_before(const Draft& a, const Draft& b) {
  return std::tie(a.submission.name, a.path) < std::tie(b.submission.name, b.path);
}

// Marks a draft that has the same name as another one.
void mark(Draft& draft, const std::string& name, const Draft& other) {
  const std::string both = " are both the submission \"" + name + "\"";
  draft.submission.origin.clear();  // its name is made of a path, not of a student
  draft.refuse(Refused(draft.shown + " and " + other.shown + both +
                       ", so this one was not graded. One of them needs another name."));
  draft.notices.push_back(draft.origin + " and " + other.origin + both +
                          "; rename one of them. This one is \"" + draft.submission.name +
                          "\" for now, and not graded");
}

}  // namespace

void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices) {
  std::stable_sort(drafts.begin(), drafts.end(), comes_before);
  std::set<std::string> taken;
  std::vector<Draft> kept;
  for (Draft& draft : drafts) {
    if (!kept.empty() && kept.back().path == draft.path &&
        kept.back().submission.name == draft.submission.name) {
      notices.push_back(draft.origin + ": was given twice; it is graded once");
      continue;
    }
    taken.insert(draft.submission.name);
    kept.push_back(std::move(draft));
  }
  drafts = std::move(kept);

  for (std::size_t begin = 0, end = 0; begin < drafts.size(); begin = end) {
    const std::string name = drafts[begin].submission.name;
    while (end < drafts.size() && drafts[end].submission.name == name) ++end;
    if (end - begin == 1) continue;
    // A person chooses the names of arguments, and students the names in them: an argument keeps its name
    // even if a class holds the same one.
    const auto is_hand_in = [](const Draft& draft) { return !is_of_a_class(draft.submission.origin); };
    const auto first = drafts.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = drafts.begin() + static_cast<std::ptrdiff_t>(end);
    const bool one_stands = std::count_if(first, last, is_hand_in) == 1;
    if (one_stands) std::iter_swap(first, std::find_if(first, last, is_hand_in));
    const auto whose = [](const Draft& draft) {
      return draft.submission.owner.name + "\n" + draft.submission.owner.id;
    };
    for (std::size_t i = one_stands ? begin + 1 : begin; i < end; ++i) {
      const bool alone = std::count_if(first, last, [&](const Draft& other) {
                           return whose(other) == whose(drafts[i]);
                         }) == 1;
      std::string own = name_among_equals(name, alone ? whose(drafts[i]) : drafts[i].path);
      while (!taken.insert(own).second) own += 'x';
      drafts[i].submission.name = own;
      if (alone) continue;  // "x 1" and "x_1" are two people
      mark(drafts[i], name, drafts[i == begin ? begin + 1 : begin]);
    }
  }
  std::sort(drafts.begin(), drafts.end(), comes_before);
}

}  // namespace grader::intake
