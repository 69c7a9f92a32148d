// STAFF ONLY. Reads hand-ins and classes out of folders and archives.
#include "grader/intake/submission.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archive_format.h"
#include "grader/intake/clashes.h"
#include "grader/intake/draft.h"
#include "grader/intake/folder.h"
#include "grader/intake/hand_in_reader.h"
#include "grader/intake/ignored.h"
#include "grader/intake/layouts/division.h"
#include "grader/intake/layouts/folders.h"
#include "grader/intake/layouts/gradescope.h"
#include "grader/intake/left_over.h"
#include "grader/intake/names.h"
#include "grader/intake/origin.h"
#include "grader/intake/several_people.h"
#include "grader/text/letters.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kClassEntriesFactor = 10;
constexpr std::uintmax_t kMostShrinking = 20;
constexpr std::size_t kLongestPathShown = 4096;

std::vector<std::string> names_in(const std::vector<Draft>& drafts) {
  std::vector<std::string> names;
  for (const Draft& draft : drafts) names.push_back(draft.submission.name);
  return names;
}

// The drafts that an argument holds, and their parts of its container.
struct Planned {
  std::vector<Draft> drafts = {};
  std::vector<Share> shares = {};  // in the order of the drafts, which they point at in the end
  std::vector<Accounted> nobodys = {};
  bool is_class = false;
  const System* system = nullptr;
};

class ClassReader {
 public:
  ClassReader(const Course& course, const OpenArchive& open_archive, const IntakeLimits& limits,
              const Arguments& arguments, const std::string& from)
      : open_archive_(open_archive), limits_(limits), arguments_(arguments), from_(from) {
    for (const Exercise& exercise : course.exercises) {
      if (exercise.role != Role::absent) files_.insert(exercise.file);
    }
  }

  void read_argument(const fs::path& argument);
  void read_hand_in(const fs::path& folder, const std::string& name);
  Intake finish();

 private:
  struct Named {
    fs::path argument;
    std::string origin, path, name, shown;
    bool on_disk = false;
  };

  static Named named(const fs::path& argument);
  static Named checked(const fs::path& argument);
  Draft new_draft(const Owner& owner, const Named& argument, const std::string& below) const;
  std::unique_ptr<Container> open(const Named& named) const;

  std::optional<Planned> by_system(std::vector<Entry>& list, const Named& argument) const;
  Planned by_folders(const std::vector<Entry>& list, const Named& argument) const;
  void add_gradescope_owners(Division& division, const std::vector<Entry>& list, const Named& argument) const;
  void say_what_it_is(const Planned& planned, const Named& argument);
  void could_not_open(const Named& argument, const Refused& why);

  const OpenArchive& open_archive_;
  IntakeLimits limits_;
  Arguments arguments_;
  std::string from_;
  FileNames files_;
  std::vector<Draft> drafts_;
  Intake intake_;
};

ClassReader::Named ClassReader::named(const fs::path& argument) {
  fs::path path = fs::absolute(argument).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  const std::string name = path.filename().string();
  return {argument, legible(argument.string(), kLongestPathShown), path.string(), composed_path(name),
          legible((path.parent_path().filename() / name).string())};
}

// Throws BadInput for what can't be a submission.
ClassReader::Named ClassReader::checked(const fs::path& argument) {
  Named found = named(argument);
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

Draft ClassReader::new_draft(const Owner& owner, const Named& argument, const std::string& below) const {
  Draft draft{.submission = {.name = name_of_owner(owner),
                             .origin = origin_text(kHandIn, legible(argument.path, kLongestPathShown)),
                             .owner = owner,
                             .system = "folders"},
              .origin = argument.origin,
              .path = argument.path,
              .shown = argument.shown,
              .budget = IntakeBudget(limits_)};
  if (!below.empty()) {
    draft.origin += "/" + legible(below, kLongestPathShown);
    draft.path += "/" + below;
    draft.shown = legible((fs::path(argument.name) / fs::path(below).filename()).string());
  }
  return draft;
}

std::unique_ptr<Container> ClassReader::open(const Named& named) const {
  const std::size_t most_entries = limits_.entries * kClassEntriesFactor;
  if (named.on_disk) return std::make_unique<Folder>(named.argument, printable(named.name), most_entries);
  const std::uintmax_t size = std::min(fs::file_size(named.argument), std::uintmax_t{1} << 50);
  const std::size_t most_bytes = std::max<std::size_t>(limits_.stream_bytes, size * kMostShrinking);
  return open_archive_(named.argument, printable(named.name), ArchiveLimits{most_bytes, most_entries});
}

void ClassReader::add_gradescope_owners(Division& division, const std::vector<Entry>& list,
                                        const Named& argument) const {
  if (division.system->name != "gradescope") return;
  for (const Division::Aside& aside : division.aside) {
    if (aside.as != Accounted::As::made) continue;
    const std::string shown = argument.origin + "/" + legible(list[aside.entry].shown, kLongestPathShown);
    std::string yaml;
    const std::unique_ptr<Container> container = open(argument);
    container->list();
    container->visit({aside.entry},
                     [&](std::size_t, const Container::Read& read) { yaml = read(limits_.unpacked_bytes); });
    std::map<std::string, GradescopeRow> rows = read_gradescope_metadata(yaml, shown);
    for (HandIn& hand_in : division.hand_ins) {
      const auto row = rows.find(hand_in.path.substr(hand_in.path.rfind('/') + 1));
      if (row == rows.end()) continue;
      hand_in.owner = row->second.owner;
      hand_in.handed_in = row->second.handed_in;
    }
  }
}

// Empty if no learning system gives such names.
std::optional<Planned> ClassReader::by_system(std::vector<Entry>& list, const Named& argument) const {
  if (from_ == "folders") return {};
  const std::string name(without_archive_ending(argument.name));
  std::optional<Division> division = divide(list, name, system_called(from_));
  if (!division) return {};
  // A student's hand-in can hold one folder of somebody else's name.
  if (!arguments_.may_be_class() && !argument.on_disk && division->hand_ins.size() < 2) return {};
  add_gradescope_owners(*division, list, argument);
  Planned planned{.is_class = true, .system = division->system};
  for (HandIn& hand_in : division->hand_ins) {
    Draft draft = new_draft(hand_in.owner, argument, hand_in.path);
    draft.submission.origin = origin_text(kLearningSystem, legible(argument.path, kLongestPathShown));
    draft.submission.system = division->system->name;
    draft.submission.handed_in = hand_in.handed_in;
    draft.submission.marked_late = hand_in.late;
    for (const std::string& doubt : hand_in.doubts)
      draft.remarks.push_back(argument.origin + "/" + legible(doubt, kLongestPathShown));
    planned.drafts.push_back(std::move(draft));
    planned.shares.push_back({.draft = nullptr, .entries = std::move(hand_in.entries), .is_attached = true});
  }
  for (const Division::Aside& aside : division->aside) {
    Accounted file{argument.origin + "/" + legible(list[aside.entry].shown, kLongestPathShown), aside.as,
                   aside.reason, ""};
    if (aside.hand_in == Division::kNobody)
      planned.nobodys.push_back(std::move(file));
    else
      planned.drafts[aside.hand_in].accounted.push_back(std::move(file));
  }
  return planned;
}

Planned ClassReader::by_folders(const std::vector<Entry>& list, const Named& argument) const {
  // A folder with one archive among several arguments is a student's.
  const Layout layout = layout_of(list, files_, argument.on_disk && arguments_.may_be_class());
  if (!layout.found && (argument.on_disk || !arguments_.several)) {
    std::string names;
    for (const std::string& file : files_) names += (names.empty() ? "" : ", ") + file;
    throw BadInput(
        argument.origin + ": there is no exercise file (" + names +
        ") and no archive in it, and no learning system's names; give a submission or a class of them");
  }
  Planned planned{.is_class = layout.is_class};
  std::set<std::size_t> mine;
  for (const Member& member : layout.members) {
    const Told* told = nullptr;
    std::optional<Told> by_name;
    if (!layout.is_class) by_name = told_by_name(argument.name, argument.on_disk);
    if (by_name) told = &*by_name;
    const std::string below = layout.is_class ? fs::path(member.path).filename().string() : argument.name;
    planned.drafts.push_back(
        new_draft(told ? told->named.owner : Owner{.name = std::string(without_archive_ending(below))},
                  argument, member.path));
    Submission& submission = planned.drafts.back().submission;
    if (layout.is_class) submission.origin = origin_text(kClass, legible(argument.path, kLongestPathShown));
    if (told) {
      submission.system = told->system->name;
      submission.handed_in = told->named.handed_in;
      submission.marked_late = told->named.late;
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

void ClassReader::say_what_it_is(const Planned& planned, const Named& argument) {
  const std::string names = some_of(names_in(planned.drafts));
  if (planned.is_class)
    intake_.taken_for.push_back(
        argument.origin + ": taken for a " +
        (planned.system ? "download from " + std::string(planned.system->shown) : "class") + ": " + names);
  else if (!arguments_.several)
    intake_.taken_for.push_back(argument.origin + ": taken for a hand-in of one student, " + names);
}

// Among several arguments it is one student's hand-in. A lone one may be a class, and then it would be everybody's.
void ClassReader::could_not_open(const Named& argument, const Refused& why) {
  if (arguments_.may_be_class())
    throw BadInput(
        argument.origin + ": nothing was graded: " + why.what() +
        (arguments_.several ? "" : " If it is one student's, put it into a folder, and grade that"));
  Draft draft = new_draft({.name = std::string(without_archive_ending(argument.name))}, argument, "");
  draft.refuse(why);
  drafts_.push_back(std::move(draft));
}

void ClassReader::read_argument(const fs::path& argument) {
  const Named named = checked(argument);
  std::unique_ptr<Container> container;
  std::vector<Entry> list;
  try {
    container = open(named);
    list = container->list();
  } catch (const Refused& why) {
    could_not_open(named, why);
    return;
  }
  for (std::string& line : settle_names(list, named.origin)) intake_.remarks.push_back(std::move(line));
  std::optional<Planned> planned = by_system(list, named);
  if (!planned && !from_.empty() && from_ != "folders")
    throw BadInput(named.origin + ": holds no name that " + std::string(system_called(from_)->shown) +
                   " gives, as " + std::string(system_called(from_)->example) + "; see --from");
  if (!planned) planned = by_folders(list, named);
  if (planned->is_class) {
    if (const std::string why =
            why_no_class({names_in(planned->drafts), planned->system != nullptr}, named.name, arguments_);
        !why.empty()) {
      if (!arguments_.several) throw BadInput(named.origin + ": " + why);
      intake_.notices.push_back(named.origin + ": " + why);
      drafts_.push_back(new_draft({.name = std::string(without_archive_ending(named.name))}, named, ""));
      drafts_.back().refuse(
          Refused("There are folders or archives of several people in it. Hand in only your own files."));
      return;
    }
    if (!named.on_disk && std::ranges::any_of(list, &Entry::encrypted))
      throw BadInput(named.origin +
                     ": nothing was graded: it has a password; unpack it, and give the folder");
  }
  say_what_it_is(*planned, named);
  for (std::size_t i = 0; i < planned->drafts.size(); ++i) {
    Draft& draft = planned->drafts[i];
    planned->shares[i].draft = &draft;
    for (const std::size_t entry : planned->shares[i].entries)
      if (list[entry].kind != Entry::Kind::folder)
        draft.accounted.push_back({named.origin + "/" + legible(list[entry].shown, kLongestPathShown),
                                   list[entry].replaced ? Accounted::As::older : Accounted::As::hand_in,
                                   list[entry].replaced ? "a later entry of this name counts" : "", ""});
  }
  std::ranges::move(planned->nobodys, std::back_inserter(intake_.accounted));
  HandInReader reader(open_archive_, limits_, files_);
  try {
    reader.take(*container, list, planned->shares);
  } catch (const Refused& why) {
    if (planned->is_class && !named.on_disk) could_not_open(named, why);
    for (Draft& draft : planned->drafts) draft.refuse(why);
  }
  std::ranges::move(planned->drafts, std::back_inserter(drafts_));
}

void ClassReader::read_hand_in(const fs::path& folder, const std::string& name) {
  Named argument = named(folder);
  argument.on_disk = true;
  Draft draft = new_draft({.name = name}, argument, "");
  try {
    const std::unique_ptr<Container> container = open(argument);
    std::vector<Entry> list = container->list();
    draft.remarks = settle_names(list, argument.origin);
    Share all{.draft = &draft, .entries = {}};
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!is_ignored(list[i].path)) all.entries.push_back(i);
    HandInReader(open_archive_, limits_, files_).take(*container, list, {all});
  } catch (const Refused& why) {
    draft.refuse(why);
  }
  drafts_.push_back(std::move(draft));
}

Intake ClassReader::finish() {
  for (const Accounted& file : intake_.accounted)
    if (file.as == Accounted::As::left_over) intake_.notices.push_back(line_about(file));
  for (Draft& draft : drafts_) draft.finish(files_);
  resolve_clashes(drafts_, intake_.notices);
  for (Draft& draft : drafts_) {
    for (Accounted& file : draft.accounted) file.whose = draft.submission.name;
    std::ranges::move(draft.accounted, std::back_inserter(intake_.accounted));
    for (const std::string& notice : draft.notices) intake_.whose_notice[notice] = draft.submission.name;
    std::ranges::move(draft.notices, std::back_inserter(intake_.notices));
    std::ranges::move(draft.remarks, std::back_inserter(intake_.remarks));
    intake_.submissions.push_back(std::move(draft.submission));
  }
  return std::move(intake_);
}

}  // namespace

Intake read_submissions(const std::vector<fs::path>& arguments, const Course& course,
                        const OpenArchive& open_archive, const IntakeLimits& limits,
                        const IntakeChoices& choices) {
  std::set<fs::path> different;
  for (const fs::path& argument : arguments) different.insert(fs::absolute(argument).lexically_normal());
  ClassReader reader(course, open_archive, limits, {different.size() > 1, choices.classes}, choices.from);
  for (const fs::path& argument : arguments) reader.read_argument(argument);
  return reader.finish();
}

Intake read_hand_in(const fs::path& folder, const std::string& name, const Course& course,
                    const OpenArchive& open_archive, const IntakeLimits& limits) {
  ClassReader reader(course, open_archive, limits, {}, "folders");
  reader.read_hand_in(folder, name);
  return reader.finish();
}

}  // namespace grader
