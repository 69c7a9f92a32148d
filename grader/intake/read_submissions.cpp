// STAFF ONLY. Reads hand-ins and classes out of folders and archives.
#include "grader/intake/read_submissions.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grader/course/input.h"
#include "grader/intake/archives/container.h"
#include "grader/intake/draft.h"
#include "grader/intake/hand_in_reader.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"
#include "grader/intake/plan.h"
#include "grader/intake/submission.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

namespace fs = std::filesystem;

// Returns why an argument of this name, which holds submissions of these names, is no class: a part of a
// sentence for staff, which kSaysClass ends. Empty: it is a class.
std::string why_no_class(const std::vector<std::string>& names, std::string_view name,
                         const Arguments& arguments) {
  if (arguments.classes) return {};
  std::string why;
  if (arguments.several)
    why = "is one of several arguments";
  else if (names.size() > 1 && std::ranges::count(names, submission_name(name)) > 0)
    why = "is called as one of them";
  else if (told_by_name(name, false) || told_by_name(without_archive_ending(name), true))
    why = "is called as a learning system calls one student's";
  if (why.empty()) return {};
  return "was not graded: it holds hand-ins under people's names (" + some_of(names) + "), and " + why +
         ", so it may be one student's hand-in; if it is a class, say";
}

constexpr std::size_t kClassEntriesFactor = 10;
constexpr std::uintmax_t kMostShrinking = 20;

std::vector<std::string> names_in(const std::vector<Draft>& drafts) {
  std::vector<std::string> names;
  for (const Draft& draft : drafts) names.push_back(draft.submission.name);
  return names;
}

class ClassReader {
 public:
  ClassReader(const Course& course, const OpenArchive& open_archive, const IntakeLimits& limits,
              const Arguments& arguments, const IntakeChoices& choices)
      : open_archive_(open_archive), limits_(limits), arguments_(arguments), choices_(choices) {
    for (const Exercise& exercise : course.exercises) {
      if (exercise.role != Role::absent) files_.insert(exercise.file);
    }
  }

  void read_argument(const fs::path& argument);
  void read_hand_in(const fs::path& folder, const std::string& name);
  Intake finish();

 private:
  std::unique_ptr<Container> open(const Argument& argument) const;
  std::shared_ptr<Container> open_sections(const Argument& named, std::shared_ptr<Container> outer,
                                           const std::vector<Entry>& list) const;
  void say_what_it_is(const Planned& planned, const Argument& argument);
  void could_not_open(const Argument& argument, const Refused& why);

  const OpenArchive& open_archive_;
  IntakeLimits limits_;
  Arguments arguments_;
  IntakeChoices choices_;
  FileNames files_;
  std::vector<Draft> drafts_;
  std::vector<std::string> crowds_;  // has a line for each; its one draft is refused
  Intake intake_;
};

std::unique_ptr<Container> ClassReader::open(const Argument& named) const {
  const std::size_t most_entries = limits_.entries * kClassEntriesFactor;
  if (named.on_disk) return open_folder(named.file, printable(named.name), most_entries);
  const std::uintmax_t size = std::min(fs::file_size(named.file), std::uintmax_t{1} << 50);
  const std::size_t most_bytes = std::max<std::size_t>(limits_.stream_bytes, size * kMostShrinking);
  return open_archive_(named.file, printable(named.name), ArchiveLimits{most_bytes, most_entries});
}

// A hand-in is never a class of sections. Returns null then, and if there are no sections.
std::shared_ptr<Container> ClassReader::open_sections(const Argument& named, std::shared_ptr<Container> outer,
                                                      const std::vector<Entry>& list) const {
  if (!arguments_.may_be_class() || told_by_name(named.name, named.on_disk)) return {};
  const bool said = arguments_.classes || !choices_.from.empty();
  std::size_t bytes_left = limits_.stream_bytes;
  const auto open_entry = [&](std::size_t entry) {
    if (const fs::path file = named.file / list[entry].path; named.on_disk && fs::is_regular_file(file))
      return open(argument_at(file));
    std::string bytes;
    const std::unique_ptr<Container> again = open(named);
    again->list();
    again->visit({entry}, [&](std::size_t, const Container::Read& read) {
      bytes = read(std::min(bytes_left, limits_.unpacked_bytes));
    });
    bytes_left -= bytes.size();
    return open_archive_(std::move(bytes), printable(std::string(name_of(list[entry]))),
                         {limits_.stream_bytes, limits_.entries * kClassEntriesFactor});
  };
  return grader::open_sections(std::move(outer), list, said ? 1 : 2, system_called(choices_.from),
                               open_entry);
}

void ClassReader::say_what_it_is(const Planned& planned, const Argument& argument) {
  const std::string names = some_of(names_in(planned.drafts));
  if (planned.is_class)
    intake_.taken_for.push_back(
        argument.origin + ": taken for a " +
        (planned.system ? "download from " + std::string(planned.system->shown) : "class") + ": " + names);
  else if (!arguments_.several)
    intake_.taken_for.push_back(argument.origin + ": taken for a hand-in of one student, " + names);
}

// Among several arguments it is one student's hand-in. A single one may be a class, and then all students are
// affected.
void ClassReader::could_not_open(const Argument& argument, const Refused& why) {
  if (arguments_.may_be_class())
    throw BadInput(
        argument.origin + ": nothing was graded: " + why.what() +
        (arguments_.several ? "" : " If it is one student's, put it into a folder, and grade that"));
  Draft draft =
      new_draft({.name = std::string(without_archive_ending(argument.name))}, argument, "", limits_);
  draft.refuse(why);
  drafts_.push_back(std::move(draft));
}

void ClassReader::read_argument(const fs::path& argument) {
  const Argument named = checked_argument(argument);
  std::shared_ptr<Container> container;
  std::vector<Entry> list;
  try {
    container = open(named);
    list = container->list();
  } catch (const Refused& why) {
    could_not_open(named, why);
    return;
  }
  for (std::string& line : settle_names(list, named.origin)) intake_.remarks.push_back(std::move(line));
  const Planner planner{files_, limits_, arguments_, choices_, [&] { return open(named); }};
  std::optional<Planned> planned = planner.by_system(list, named);
  if (!planned && choices_.from != "folders")
    if (const std::shared_ptr<Container> sections = open_sections(named, container, list)) {
      const Planner of_sections{files_, limits_, arguments_, choices_,
                                [&] { return open_sections(named, open(named), list); }};
      std::vector<Entry> all = sections->list();
      planned = of_sections.by_system(all, named);
      if (planned) {
        container = sections;
        list = std::move(all);
      }
    }
  if (!planned && !choices_.from.empty() && choices_.from != "folders")
    throw BadInput(named.origin + ": holds no name that " + std::string(system_called(choices_.from)->shown) +
                   " gives, as " + std::string(system_called(choices_.from)->example) + "; see --from");
  if (!planned) planned = planner.by_folders(list, named);
  if (planned->is_class) {
    if (const std::string why = why_no_class(names_in(planned->drafts), named.name, arguments_);
        !why.empty()) {
      crowds_.push_back(named.origin + ": " + why);
      drafts_.push_back(
          new_draft({.name = std::string(without_archive_ending(named.name))}, named, "", limits_));
      drafts_.back().notices.push_back(crowds_.back() + " " + kSaysClass);
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
  Argument argument = argument_at(folder);
  argument.on_disk = true;
  Draft draft = new_draft({.name = name}, argument, "", limits_);
  try {
    const std::unique_ptr<Container> container = open(argument);
    std::vector<Entry> list = container->list();
    draft.remarks = settle_names(list, argument.origin);
    HandInReader(open_archive_, limits_, files_).take(*container, list, {whole_share(draft, list)});
  } catch (const Refused& why) {
    draft.refuse(why);
  }
  drafts_.push_back(std::move(draft));
}

Intake ClassReader::finish() {
  if (!crowds_.empty() && crowds_.size() == drafts_.size()) {
    std::string all;
    for (const std::string& crowd : crowds_) all += (all.empty() ? "" : "; and ") + crowd;
    throw Question(all, kSaysClass);
  }
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
  ClassReader reader(course, open_archive, limits, {different.size() > 1, choices.says_class()}, choices);
  for (const fs::path& argument : arguments) reader.read_argument(argument);
  return reader.finish();
}

Intake read_hand_in(const fs::path& folder, const std::string& name, const Course& course,
                    const OpenArchive& open_archive, const IntakeLimits& limits) {
  ClassReader reader(course, open_archive, limits, {}, {.from = "folders"});
  reader.read_hand_in(folder, name);
  return reader.finish();
}

}  // namespace grader::intake
