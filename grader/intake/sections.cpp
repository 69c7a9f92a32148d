// STAFF ONLY. Opens downloads in a folder or an archive.
#include "grader/intake/sections.h"

#include <algorithm>
#include <string>
#include <utility>

#include "grader/intake/draft.h"
#include "grader/intake/layouts/division.h"
#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"

namespace grader::inline intake {
namespace {

constexpr std::size_t kMostSections = 20;

struct Part {
  std::shared_ptr<Container> container;
  std::vector<Entry> list;
};

// Joins several containers to one.
class Parts : public Container {
 public:
  explicit Parts(std::vector<Part> parts) : parts_(std::move(parts)) {}

  std::vector<Entry> list() override {
    std::vector<Entry> all;
    for (const Part& part : parts_) all.insert(all.end(), part.list.begin(), part.list.end());
    return all;
  }

  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t index, const Read&)>& take) override {
    std::size_t first = 0;
    for (const Part& part : parts_) {
      std::vector<std::size_t> mine;
      for (const std::size_t index : indices)
        if (index >= first && index - first < part.list.size()) mine.push_back(index - first);
      if (!mine.empty())
        part.container->visit(mine, [&](std::size_t index, const Read& read) { take(first + index, read); });
      first += part.list.size();
    }
  }

 private:
  std::vector<Part> parts_;
};

}  // namespace

std::shared_ptr<Container> open_sections(std::shared_ptr<Container> outer, std::vector<Entry> list,
                                         std::size_t least, const System* said, const OpenEntry& open) {
  const auto folder_of = [&](std::size_t i) { return list[i].path.substr(0, list[i].path.rfind('/') + 1); };
  std::vector<std::size_t> archives;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].kind == Entry::Kind::folder || is_ignored(list[i].path) ||
        !has_archive_ending(name_of(list[i])))
      continue;
    if (list[i].encrypted || !problem_of(list[i], "").empty() || archives.size() == kMostSections) return {};
    archives.push_back(i);
    if (folder_of(i) != folder_of(archives.front())) return {};
  }
  if (archives.size() < least) return {};
  std::vector<Part> parts(1);
  try {
    for (const std::size_t i : archives) {
      Part part{open(i), {}};
      part.list = part.container->list();
      settle_names(part.list, list[i].shown);
      std::vector<Entry> names = part.list;
      const std::optional<Division> division = divide(names, std::string(name_of(list[i])), said);
      if (!division) return {};
      said = division->system;
      for (Entry& entry : part.list) {
        entry.shown.insert(0, list[i].shown + "/");
        entry.path.insert(0, list[i].path + "/");
      }
      list[i].kind = Entry::Kind::folder;
      parts.push_back(std::move(part));
    }
  } catch (const Refused&) {
    return {};
  }
  parts.front() = {std::move(outer), std::move(list)};
  return std::make_shared<Parts>(std::move(parts));
}

}  // namespace grader::intake
