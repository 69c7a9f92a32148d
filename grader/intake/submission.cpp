// STAFF ONLY. Reads hand-ins and classes out of folders and archives.
#include "grader/intake/submission.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archive_format.h"
#include "grader/intake/clashes.h"
#include "grader/intake/draft.h"
#include "grader/intake/folder.h"
#include "grader/intake/layout.h"
#include "grader/intake/names.h"
#include "grader/intake/origin.h"
#include "grader/intake/several_people.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_nesting = 3;  // class.zip, Alice_1.zip in it, handin.tar.gz in that
constexpr std::size_t most_archives = 20;
constexpr std::size_t class_entries_factor = 50;
constexpr std::uintmax_t most_shrinking = 20;

std::vector<std::string> names_in(const std::vector<Draft>& drafts) {
  std::vector<std::string> names;
  for (const Draft& draft : drafts) names.push_back(draft.submission.name);
  return names;
}

// All that is counted, as one submission.
Member whole_of(const std::vector<Entry>& list) {
  Member member;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!is_ignored(list[i].path)) member.entries.push_back(i);
  return member;
}

class ClassReader {
 public:
  ClassReader(const Course& course, const OpenArchive& open_archive, const IntakeLimits& limits,
              const Arguments& arguments)
      : open_archive_(open_archive), limits_(limits), arguments_(arguments) {
    for (const Exercise& exercise : course.exercises) {
      if (exercise.role != Role::absent) files_.insert(exercise.file);
    }
  }

  void read_argument(const fs::path& argument);
  void read_hand_in(const fs::path& folder, const std::string& name);
  Intake finish();

 private:
  struct Named {
    std::string origin, path, name, shown;
  };
  // What of a container belongs to a draft.
  struct Share {
    Draft* draft;
    Member member;
  };
  // A file or an archive that is to be read.
  struct Wanted {
    Draft* draft;
    std::string file;     // the exercise file that it is; "": an archive
    std::string archive;  // its name in messages
  };
  using Plan = std::map<std::size_t, Wanted>;

  static Named named(const fs::path& argument);
  Draft new_draft(const std::string& name, const Named& argument, const std::string& below) const;
  std::unique_ptr<Container> open(const fs::path& argument, const Named& named, bool on_disk) const;

  void take(Container& container, const std::vector<Entry>& list, const std::vector<Share>& shares,
            const std::string& prefix, std::size_t depth);
  Plan plan_share(const std::vector<Entry>& list, const Share& share, const std::string& prefix,
                  std::size_t depth);
  void plan_files(const std::vector<Entry>& list, const Takings& takings, Draft& draft,
                  const std::string& prefix, Plan& plan);
  void take_archive(Draft& draft, std::string bytes, const std::string& shown, std::size_t depth);
  std::string file_names() const;

  const OpenArchive& open_archive_;
  IntakeLimits limits_;
  Arguments arguments_;
  FileNames files_;
  std::vector<Draft> drafts_;
  std::vector<std::string> notices_, taken_for_;
};

std::string ClassReader::file_names() const {
  return std::accumulate(
      files_.begin(), files_.end(), std::string(),
      [](const std::string& text, const auto& file) { return text + (text.empty() ? "" : ", ") + file; });
}

// Notes in the draft what is found and can't be taken, and adds to the plan what is to be read.
void ClassReader::plan_files(const std::vector<Entry>& list, const Takings& takings, Draft& draft,
                             const std::string& prefix, Plan& plan) {
  for (const auto& [i, name] : takings.files) {
    const std::string shown = printable(prefix + list[i].shown);
    if (list[i].encrypted) throw Unreadable(shown + " is encrypted. Pack it again without a password.");
    SourceFile& file = draft.submission.files[name];
    const auto [first, is_first] = draft.first_paths.try_emplace(name, shown);
    if (is_first) {
      file.problem = problem_of(list[i], shown);
      if (file.problem.empty()) plan[i] = {&draft, name, ""};
    } else {
      file = {"", "There is more than one " + name + ": " + first->second + " and " + shown +
                      ". Hand in only the one that counts."};
      std::erase_if(plan, [&, &taken = name](const auto& other) { return other.second.file == taken; });
    }
  }
  for (const std::size_t i : takings.outdated)
    draft.outdated.add(printable(prefix + list[i].shown) +
                       " is older than another one of its kind, and was left out");
  for (const std::size_t i : takings.left_shut)
    draft.shut.add(printable(prefix + list[i].shown) +
                   " was not opened, since there are exercise files beside it");
}

ClassReader::Plan ClassReader::plan_share(const std::vector<Entry>& list, const Share& share,
                                          const std::string& prefix, std::size_t depth) {
  Draft& draft = *share.draft;
  draft.budget.charge(list, share.member.entries);
  for (const std::size_t i : share.member.entries) {
    if (list[i].closed)
      throw Unreadable("The folder " + printable(prefix + list[i].shown) + " can't be read.");
  }
  Plan plan;
  if (share.member.kind == Member::Kind::document) {
    throw Unreadable(printable(name_of(list[share.member.entries.front()])) +
                     " is no archive. Hand in a .zip or .tar.gz archive with the exercise files.");
  }
  const Takings takings = takings_of(list, share.member, files_);
  plan_files(list, takings, draft, prefix, plan);
  for (const std::size_t i : takings.archives) {
    const std::string shown = printable(prefix + list[i].shown);
    if (depth == deepest_nesting) {
      draft.shut.add(shown + " was not opened: it is an archive in " + std::to_string(depth) + " others");
      continue;
    }
    if (list[i].encrypted) throw Unreadable(shown + " is encrypted. Pack it again without a password.");
    if (const std::string problem = problem_of(list[i], shown); !problem.empty()) throw Refused(problem);
    // A submission's own archive is named without the class around it.
    const bool own = share.member.kind == Member::Kind::archive;
    plan[i] = {&draft, "", own ? printable(name_of(list[i])) : shown};
  }
  return plan;
}

void ClassReader::take_archive(Draft& draft, std::string bytes, const std::string& shown, std::size_t depth) {
  if (++draft.archives > most_archives) {
    throw Refused("More than " + std::to_string(most_archives) + " archives were handed in. Hand in one.");
  }
  const std::unique_ptr<Container> archive =
      open_archive_(std::move(bytes), shown, draft.budget.for_archive());
  const std::vector<Entry> list = archive->list();
  take(*archive, list, {{&draft, whole_of(list)}}, shown + "/", depth);
}

void ClassReader::take(Container& container, const std::vector<Entry>& list, const std::vector<Share>& shares,
                       const std::string& prefix, std::size_t depth) {
  Plan plan;
  for (const Share& share : shares) {
    try {
      plan.merge(plan_share(list, share, prefix, depth));
    } catch (const Refused& why) {
      share.draft->refuse(why);
    }
  }
  std::vector<std::size_t> indices;
  for (const auto& [index, wanted] : plan) indices.push_back(index);
  container.visit(indices, [&](std::size_t index, const Container::Read& read) {
    const Wanted& wanted = plan.at(index);
    Draft& draft = *wanted.draft;
    if (draft.refused()) return;
    if (!wanted.file.empty()) {
      SourceFile& file = draft.submission.files[wanted.file];
      try {
        file.text = read(limits_.file_bytes);
      } catch (const Refused& why) {
        file.problem = why.what();
      }
      return;
    }
    try {
      take_archive(draft, read(limits_.unpacked_bytes), wanted.archive, depth + 1);
    } catch (const Refused& why) {
      draft.refuse(why);
    }
  });
}

ClassReader::Named ClassReader::named(const fs::path& argument) {
  fs::path path = fs::absolute(argument).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  const std::string name = path.filename().string();
  return {printable(argument.string(), 4096), path.string(), name,
          printable((path.parent_path().filename() / name).string())};
}

Draft ClassReader::new_draft(const std::string& name, const Named& argument, const std::string& below) const {
  Draft draft{{submission_name(name), origin_text(kHandIn, printable(argument.path, 4096)), {}, {}},
              argument.origin,
              argument.path,
              argument.shown,
              IntakeBudget(limits_)};
  if (!below.empty()) {
    draft.origin += "/" + printable(below, 4096);
    draft.path += "/" + below;
    draft.shown = printable((fs::path(argument.name) / fs::path(below).filename()).string());
  }
  return draft;
}

std::unique_ptr<Container> ClassReader::open(const fs::path& argument, const Named& named,
                                             bool on_disk) const {
  const std::size_t most_entries = limits_.entries * class_entries_factor;
  if (on_disk) return std::make_unique<Folder>(argument, printable(named.name), most_entries);
  const std::uintmax_t size = std::min(fs::file_size(argument), std::uintmax_t{1} << 50);
  const std::size_t most_bytes = std::max<std::size_t>(limits_.unpacked_bytes, size * most_shrinking);
  return open_archive_(argument, printable(named.name), ArchiveLimits{most_bytes, most_entries});
}

void ClassReader::read_argument(const fs::path& argument) {
  const Named argument_name = named(argument);
  const std::string& origin = argument_name.origin;
  std::error_code error;
  const fs::file_status status = fs::status(argument, error);
  if (!fs::exists(status))
    throw BadInput(origin + ": there is no such file or folder; give a submission or a class");
  const bool on_disk = fs::is_directory(status);
  const bool is_document = !on_disk && has_document_ending(argument_name.name);
  if (!on_disk && (!fs::is_regular_file(status) ||
                   !(is_document || has_archive_ending(argument_name.name) || has_archive_content(argument))))
    throw BadInput(origin + ": is neither an archive nor a folder; give a .zip, a .tar.gz or a folder");

  std::vector<Draft> drafts;
  drafts.push_back(new_draft(argument_name.name, argument_name, ""));
  std::unique_ptr<Container> container;
  std::vector<Entry> list;
  try {
    container = open(argument, argument_name, on_disk);
    list = container->list();
  } catch (const Refused& why) {
    drafts.front().refuse(why);
    drafts_.push_back(std::move(drafts.front()));
    return;
  }
  // A folder with one archive among several arguments is a student's.
  const Layout layout = layout_of(list, files_, on_disk && arguments_.may_be_class());
  if (!layout.found && on_disk) {
    throw BadInput(origin + ": there is no exercise file (" + file_names() +
                   ") and no archive in this folder; give a submission or a folder of them");
  }
  if (const std::string why = why_no_class(layout, argument_name.name, arguments_); !why.empty()) {
    if (!arguments_.several) throw BadInput(origin + ": " + why);
    notices_.push_back(origin + ": " + why);
    drafts.front().refuse(
        Refused("There are folders or archives of several people in it. Hand in only your own files."));
    drafts_.push_back(std::move(drafts.front()));
    return;
  }
  for (const std::string& stray : layout.strays)
    notices_.push_back(
        origin + "/" + printable(stray, 4096) +
        ": was not graded, since it belongs to nobody: it lies beside the submissions of a class");
  for (const auto& [files, archive] : layout.of_one_student)
    notices_.push_back(origin + "/" + printable(files) + " and " + printable(archive) +
                       " are of one student of Canvas's, and two submissions here");
  std::vector<Share> shares;
  const std::string_view kind = has_names_of_a_learning_system(layout) ? kLearningSystem : kClass;
  if (layout.is_class) drafts.clear();
  for (const Member& member : layout.members) {
    if (layout.is_class) {
      drafts.push_back(new_draft(fs::path(member.path).filename().string(), argument_name, member.path));
      drafts.back().submission.origin = origin_text(kind, printable(argument_name.path, 4096));
    }
    shares.push_back({nullptr, member});
  }
  for (std::size_t i = 0; i < drafts.size(); ++i) shares[i].draft = &drafts[i];
  if (layout.is_class)
    taken_for_.push_back(origin + ": taken for a " + std::string(kind) + ": " + some_of(names_in(drafts)));
  else if (!arguments_.several)
    taken_for_.push_back(origin + ": taken for a hand-in of one student, " + drafts.front().submission.name);
  try {
    take(*container, list, shares, "", 0);
  } catch (const Refused& why) {
    for (Draft& draft : drafts) draft.refuse(why);
  }
  std::move(drafts.begin(), drafts.end(), std::back_inserter(drafts_));
}

void ClassReader::read_hand_in(const fs::path& folder, const std::string& name) {
  const Named argument = named(folder);
  drafts_.push_back(new_draft(name, argument, ""));
  Draft& draft = drafts_.back();
  try {
    const std::unique_ptr<Container> container = open(folder, argument, true);
    const std::vector<Entry> list = container->list();
    take(*container, list, {{&draft, whole_of(list)}}, "", 0);
  } catch (const Refused& why) {
    draft.refuse(why);
  }
}

Intake ClassReader::finish() {
  Intake intake;
  intake.taken_for = std::move(taken_for_);
  for (Draft& draft : drafts_) {
    if (!draft.refused() && draft.submission.files.empty()) {
      draft.refuse(Refused("None of the exercise files is in it (" + file_names() +
                           "). Check their names, and pack them again."));
    }
  }
  resolve_clashes(drafts_, notices_);
  for (Draft& draft : drafts_) {
    const std::vector<std::string> notices = draft.all_notices();
    intake.notices.insert(intake.notices.end(), notices.begin(), notices.end());
    intake.submissions.push_back(std::move(draft.submission));
  }
  intake.notices.insert(intake.notices.end(), notices_.begin(), notices_.end());
  return intake;
}

}  // namespace

Intake read_submissions(const std::vector<fs::path>& arguments, const Course& course,
                        const OpenArchive& open_archive, const IntakeLimits& limits, bool classes) {
  std::set<fs::path> different;
  for (const fs::path& argument : arguments) different.insert(fs::absolute(argument).lexically_normal());
  ClassReader reader(course, open_archive, limits, {different.size() > 1, classes});
  for (const fs::path& argument : arguments) reader.read_argument(argument);
  return reader.finish();
}

Intake read_hand_in(const fs::path& folder, const std::string& name, const Course& course,
                    const OpenArchive& open_archive, const IntakeLimits& limits) {
  ClassReader reader(course, open_archive, limits, {});
  reader.read_hand_in(folder, name);
  return reader.finish();
}

}  // namespace grader
