// STAFF ONLY.
#include "grader/intake/clashes.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "grader/intake/names.h"

namespace grader {
namespace {

bool comes_before(const Draft& a, const Draft& b) {
  return std::tie(a.submission.name, a.path) < std::tie(b.submission.name, b.path);
}

// A draft and another one of its name.
void mark(Draft& draft, const std::string& name, const Draft& other, std::vector<std::string>& notices) {
  const std::string both = " are both the submission \"" + name + "\"";
  draft.refuse(Refused(draft.shown + " and " + other.shown + both +
                       ", so neither of them was graded. One of them needs another name."));
  notices.push_back(draft.origin + " and " + other.origin + both + "; rename one of them. This one is \"" +
                    draft.submission.name + "\" for now, and not graded");
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
    for (std::size_t i = begin; i < end; ++i) {
      std::string own = name_among_equals(name, drafts[i].path);
      while (!taken.insert(own).second) own += 'x';
      drafts[i].submission.name = own;
      mark(drafts[i], name, drafts[i == begin ? begin + 1 : begin], notices);
    }
  }
  std::sort(drafts.begin(), drafts.end(), comes_before);
}

}  // namespace grader
