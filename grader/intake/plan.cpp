// STAFF ONLY. Plans how the entries of an argument are read, and opens downloads in it.
#include "grader/intake/plan.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/layouts/division.h"
#include "grader/intake/layouts/folders.h"
#include "grader/intake/layouts/gradescope.h"
#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"
#include "grader/intake/submission.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

namespace fs = std::filesystem;

void add_gradescope_owners(Division& division, const std::vector<Entry>& list, const Argument& argument,
                           const Planner& planner) {
  if (division.system->name != "gradescope") return;
  for (const Division::Aside& aside : division.aside) {
    if (aside.as != Accounted::As::made) continue;
    const std::string shown = argument.origin + "/" + legible(list[aside.entry].shown, kLongestPathShown);
    std::string yaml;
    const std::shared_ptr<Container> container = planner.opened();
    container->list();
    container->visit({aside.entry}, [&](std::size_t, const Container::Read& read) {
      yaml = read(planner.limits.unpacked_bytes);
    });
    std::map<std::string, GradescopeRow> rows = read_gradescope_metadata(yaml, shown);
    for (FoundHandIn& hand_in : division.hand_ins) {
      const auto row = rows.find(hand_in.path.substr(hand_in.path.rfind('/') + 1));
      if (row == rows.end()) continue;
      hand_in.owner = row->second.owner;
      hand_in.handed_in = row->second.handed_in;
    }
  }
}

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

Argument argument_at(const fs::path& argument) {
  fs::path path = fs::absolute(argument).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  const std::string name = path.filename().string();
  return {argument, legible(argument.string(), kLongestPathShown), path.string(), composed_path(name),
          legible((path.parent_path().filename() / name).string())};
}

Argument checked_argument(const fs::path& argument) {
  Argument found = argument_at(argument);
  std::error_code error;
  const fs::file_status status = fs::status(argument, error);
  if (!fs::exists(status))
    throw BadInput(found.origin + ": there is no such file or folder; give a submission or a class");
  found.on_disk = fs::is_directory(status);
  const bool may_be_one =
      fs::is_regular_file(status) &&
      (has_document_ending(found.name) || has_archive_ending(found.name) || has_archive_content(argument));
  if (!found.on_disk && !may_be_one)
    throw BadInput(found.origin + ": is neither an archive nor a folder; give a .zip, a .tar.gz or a folder");
  return found;
}

Draft new_draft(const Owner& owner, const Argument& argument, const std::string& below,
                const IntakeLimits& limits) {
  Draft draft{.submission = {.name = name_of_owner(owner),
                             .origin = origin_text(kHandIn, legible(argument.path, kLongestPathShown)),
                             .owner = owner,
                             .system = "folders"},
              .origin = argument.origin,
              .path = argument.path,
              .shown = argument.shown,
              .budget = IntakeBudget(limits)};
  if (!below.empty()) {
    draft.origin += "/" + legible(below, kLongestPathShown);
    draft.path += "/" + below;
    draft.shown = legible((fs::path(argument.name) / fs::path(below).filename()).string());
  }
  return draft;
}

std::optional<Planned> Planner::by_system(std::vector<Entry>& list, const Argument& argument) const {
  if (choices.from == "folders") return {};
  const std::string name(without_archive_ending(argument.name));
  std::optional<Division> division =
      divide(list, name, system_called(choices.from), arguments.may_be_class(), choices.known);
  if (!division) return {};
  // A student's hand-in can hold one folder with somebody else's name.
  if (!arguments.may_be_class() && !argument.on_disk && division->hand_ins.size() < 2) return {};
  add_gradescope_owners(*division, list, argument, *this);
  Planned planned{.is_class = true, .system = division->system};
  for (FoundHandIn& hand_in : division->hand_ins) {
    Draft draft = new_draft(hand_in.owner, argument, hand_in.path, limits);
    draft.submission.origin = origin_text(kLearningSystem, legible(argument.path, kLongestPathShown));
    draft.submission.system = division->system->name;
    draft.submission.handed_in = hand_in.handed_in;
    draft.submission.marked_late = hand_in.late;
    for (const std::string& doubt : hand_in.doubts)
      draft.notices.push_back(argument.origin + "/" + legible(doubt, kLongestPathShown));
    for (const std::string& remark : hand_in.remarks)
      draft.remarks.push_back(argument.origin + "/" + legible(remark, kLongestPathShown));
    planned.drafts.push_back(std::move(draft));
    planned.shares.push_back({.draft = nullptr, .entries = std::move(hand_in.entries), .is_attached = true});
  }
  for (const Division::Aside& aside : division->aside) {
    const Entry& entry = list[aside.entry];
    Accounted file{argument.origin + "/" + legible(entry.shown, kLongestPathShown), aside.as, aside.reason,
                   ""};
    if (aside.hand_in == Division::kNobody) {
      planned.nobodys.push_back(std::move(file));
      continue;
    }
    Draft& draft = planned.drafts[aside.hand_in];
    draft.accounted.push_back(std::move(file));
    const auto likeness = exercise_file(name_of(entry), files);
    if (aside.as == Accounted::As::older && likeness && likeness->degree != Likeness::Degree::like)
      draft.pass_over(likeness->file, legible(entry.shown));
  }
  return planned;
}

Planned Planner::by_folders(const std::vector<Entry>& list, const Argument& argument) const {
  // A folder with one archive among several arguments belongs to one student.
  const Layout layout = layout_of(list, files, argument.on_disk && arguments.may_be_class());
  if (!layout.found && (argument.on_disk || !arguments.several)) {
    std::string names;
    for (const std::string& file : files) names += (names.empty() ? "" : ", ") + file;
    throw BadInput(
        argument.origin + ": there is no exercise file (" + names +
        ") and no archive in it, and no learning system's names; give a submission or a class of them");
  }
  Planned planned{.is_class = layout.is_class};
  std::set<std::size_t> mine;
  for (const Member& member : layout.members) {
    const std::optional<Told> told =
        layout.is_class ? std::nullopt : told_by_name(argument.name, argument.on_disk, choices.known);
    const std::string below = layout.is_class ? fs::path(member.path).filename().string() : argument.name;
    planned.drafts.push_back(
        new_draft(told ? told->named.owner : Owner{.name = std::string(without_archive_ending(below))},
                  argument, member.path, limits));
    Submission& submission = planned.drafts.back().submission;
    if (layout.is_class) submission.origin = origin_text(kClass, legible(argument.path, kLongestPathShown));
    if (told) {
      submission.system = told->system->name;
      submission.handed_in = told->named.handed_in;
      submission.marked_late = told->named.late;
      if (!told->named.doubt.empty())
        planned.drafts.back().notices.push_back(argument.origin + " " + told->named.doubt);
    }
    mine.insert(member.entries.begin(), member.entries.end());
    planned.shares.push_back({.draft = nullptr,
                              .entries = member.entries,
                              .is_archive = member.kind == Member::Kind::archive,
                              .is_document = member.kind == Member::Kind::document});
  }
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].kind != Entry::Kind::folder && !is_ignored(list[i].path) && !mine.contains(i))
      planned.nobodys.push_back({argument.origin + "/" + legible(list[i].shown, kLongestPathShown),
                                 Accounted::As::left_over,
                                 "belongs to nobody: it lies beside the submissions of a class", ""});
  return planned;
}

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
