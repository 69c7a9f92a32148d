// STAFF ONLY.
#include "grader/intake/submission.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archive.h"
#include "grader/intake/folder.h"
#include "grader/intake/layout.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_nesting = 3;  // class.zip, Alice_1.zip in it, handin.tar.gz in that
constexpr std::size_t most_archives = 20;
constexpr std::size_t class_entries_factor = 50;
constexpr std::uintmax_t most_shrinking = 20;

std::string submission_name(std::string_view name) {
  constexpr std::size_t longest = 150;
  constexpr std::array<std::string_view, 7> taken{"staff",       "grades.csv", "index.html",  "junit.xml",
                                                  "timing.json", "costs.html", "made-by.json"};
  std::string safe(without_archive_ending(name).substr(0, longest));
  for (char& c : safe) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '_' || c == '-';
    if (!plain) c = '_';
  }
  if (safe.empty()) safe = "_";
  if (safe.front() == '.') safe.front() = '_';
  if (std::find(taken.begin(), taken.end(), safe) != taken.end()) safe += '_';
  return safe;
}

// What a submission has used of its limits.
class Budget {
 public:
  explicit Budget(const IntakeLimits& limits) : limits_(limits), bytes_left_(limits.unpacked_bytes) {}

  // Sizes are those that the container states; reading is limited again by what really comes.
  void charge(const std::vector<Entry>& list, const std::vector<std::size_t>& entries) {
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
  ArchiveLimits for_archive() const { return {limits_.unpacked_bytes, limits_.entries}; }

 private:
  IntakeLimits limits_;
  std::size_t bytes_left_;
  std::size_t entries_ = 0;
};

// A submission while it is read.
struct Draft {
  Submission submission;
  std::string origin;  // for people: which argument, and where in it
  Budget budget;
  std::map<std::string, std::string> first_paths;  // where each exercise file was found first
  std::size_t archives = 0;                        // opened in it

  void refuse(const std::string& why) {
    submission.files.clear();
    submission.problem = why;
  }
  bool refused() const { return !submission.problem.empty(); }
};

// Why an entry that should be a file is none, or must not be taken; "" if all is well.
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

class Intake {
 public:
  Intake(const Course& course, const IntakeLimits& limits) : limits_(limits) {
    for (const Exercise& exercise : course.exercises) {
      if (exercise.role != Role::absent) files_.insert(exercise.file);
    }
  }

  void read_argument(const fs::path& argument);
  std::vector<Submission> finish();

 private:
  struct Share {
    Draft* draft;
    std::vector<std::size_t> entries;
    bool is_archive = false;  // its entry is the submission's archive
  };

  Draft new_draft(const std::string& name, std::string origin) const {
    return {{submission_name(name), {}, {}}, std::move(origin), Budget(limits_), {}, 0};
  }
  void take(Container& container, const std::vector<Entry>& list, const std::vector<Share>& shares,
            const std::string& prefix, std::size_t depth);
  std::vector<std::size_t> plan_share(const std::vector<Entry>& list, const Share& share,
                                      const std::string& prefix, std::size_t depth);
  void take_archive(Draft& draft, std::string bytes, const std::string& shown, std::size_t depth);
  std::string file_names() const;

  IntakeLimits limits_;
  FileNames files_;
  std::vector<Draft> drafts_;
};

std::string Intake::file_names() const {
  return std::accumulate(
      files_.begin(), files_.end(), std::string(),
      [](const std::string& text, const auto& file) { return text + (text.empty() ? "" : ", ") + file; });
}

// Notes in the draft what is found and can't be taken; returns what is to be read.
std::vector<std::size_t> Intake::plan_share(const std::vector<Entry>& list, const Share& share,
                                            const std::string& prefix, std::size_t depth) {
  Draft& draft = *share.draft;
  draft.budget.charge(list, share.entries);
  for (const std::size_t i : share.entries) {
    if (list[i].closed) {
      throw Refused("The folder " + printable(prefix + list[i].shown) + " can't be read.");
    }
  }
  const Takings takings = takings_of(list, share.entries, files_);
  std::vector<std::size_t> wanted;
  for (const std::size_t i : takings.files) {
    const std::string name(name_of(list[i]));
    const std::string shown = printable(prefix + list[i].shown);
    if (list[i].encrypted) throw Refused(shown + " is encrypted. Pack it again without a password.");
    SourceFile& file = draft.submission.files[name];
    const auto [first, is_first] = draft.first_paths.try_emplace(name, shown);
    if (is_first) {
      file.problem = problem_of(list[i], shown);
      if (file.problem.empty()) wanted.push_back(i);
    } else {
      file = {"", "There is more than one " + name + ": " + first->second + " and " + shown +
                      ". Hand in only the one that counts."};
      std::erase_if(wanted, [&](std::size_t other) { return name_of(list[other]) == name; });
    }
  }
  if (depth == deepest_nesting) return wanted;
  for (const std::size_t i : takings.archives) {
    const std::string shown = printable(prefix + list[i].shown);
    if (list[i].encrypted) throw Refused(shown + " is encrypted. Pack it again without a password.");
    if (const std::string problem = problem_of(list[i], shown); !problem.empty()) throw Refused(problem);
    wanted.push_back(i);
  }
  return wanted;
}

void Intake::take_archive(Draft& draft, std::string bytes, const std::string& shown, std::size_t depth) {
  if (++draft.archives > most_archives) {
    throw Refused("More than " + std::to_string(most_archives) + " archives were handed in. Hand in one.");
  }
  Archive archive(std::move(bytes), shown, draft.budget.for_archive());
  const std::vector<Entry> list = archive.list();
  std::vector<std::size_t> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_ignored(list[i].path)) entries.push_back(i);
  }
  take(archive, list, {{&draft, entries}}, shown + "/", depth);
}

void Intake::take(Container& container, const std::vector<Entry>& list, const std::vector<Share>& shares,
                  const std::string& prefix, std::size_t depth) {
  std::map<std::size_t, const Share*> owners;
  for (const Share& share : shares) {
    try {
      for (const std::size_t i : plan_share(list, share, prefix, depth)) owners[i] = &share;
    } catch (const Refused& why) {
      share.draft->refuse(why.what());
    }
  }
  std::vector<std::size_t> indices;
  for (const auto& [index, share] : owners) indices.push_back(index);
  container.visit(indices, [&](std::size_t index, const Container::Read& read) {
    const Share& share = *owners.at(index);
    Draft& draft = *share.draft;
    if (draft.refused()) return;
    const std::string name(name_of(list[index]));
    if (!share.is_archive && files_.count(name) > 0) {
      SourceFile& file = draft.submission.files[name];
      try {
        file.text = read(limits_.file_bytes);
      } catch (const Refused& why) {
        file.problem = why.what();
      }
      return;
    }
    try {
      // A submission's own archive is named without the class around it.
      const std::string shown = printable(share.is_archive ? name : prefix + list[index].shown);
      take_archive(draft, read(limits_.unpacked_bytes), shown, depth + 1);
    } catch (const Refused& why) {
      draft.refuse(why.what());
    }
  });
}

void Intake::read_argument(const fs::path& argument) {
  const std::string origin = printable(argument.string(), 4096);
  std::error_code error;
  const fs::file_status status = fs::status(argument, error);
  if (!fs::exists(status))
    throw BadInput(origin + ": there is no such file or folder; give a submission or a class");
  const bool on_disk = fs::is_directory(status);

  fs::path named = fs::absolute(argument).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();
  const std::string name = named.filename().string();

  std::unique_ptr<Container> container;
  const std::size_t most_entries = limits_.entries * class_entries_factor;
  if (on_disk) {
    container = std::make_unique<Folder>(argument, printable(name), most_entries);
  } else {
    if (!fs::is_regular_file(status) || !(has_archive_ending(name) || has_archive_content(argument))) {
      throw BadInput(origin + ": is neither an archive nor a folder; give a .zip, a .tar.gz or a folder");
    }
    const std::uintmax_t size = std::min(fs::file_size(argument), std::uintmax_t{1} << 50);
    const std::size_t most_bytes = std::max<std::size_t>(limits_.unpacked_bytes, size * most_shrinking);
    container = std::make_unique<Archive>(argument, printable(name), ArchiveLimits{most_bytes, most_entries});
  }

  std::vector<Entry> list;
  try {
    list = container->list();
  } catch (const Refused& why) {
    drafts_.push_back(new_draft(name, origin));
    drafts_.back().refuse(why.what());
    return;
  }
  const Layout layout = layout_of(list, files_, on_disk);
  if (!layout.found && on_disk) {
    throw BadInput(origin + ": there is no exercise file (" + file_names() +
                   ") and no archive in this folder; give a submission or a folder of them");
  }
  std::vector<Draft> drafts;
  for (const Member& member : layout.members) {
    drafts.push_back(layout.is_class ? new_draft(fs::path(member.path).filename().string(),
                                                 origin + "/" + printable(member.path))
                                     : new_draft(name, origin));
  }
  std::vector<Share> shares;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    shares.push_back({&drafts[i], layout.members[i].entries, layout.members[i].archive});
  }
  try {
    take(*container, list, shares, "", 0);
  } catch (const Refused& why) {
    for (Draft& draft : drafts) draft.refuse(why.what());
  }
  std::move(drafts.begin(), drafts.end(), std::back_inserter(drafts_));
}

std::vector<Submission> Intake::finish() {
  std::stable_sort(drafts_.begin(), drafts_.end(),
                   [](const Draft& a, const Draft& b) { return a.submission.name < b.submission.name; });
  std::vector<Submission> submissions;
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    Draft& draft = drafts_[i];
    if (i > 0 && submissions.back().name == draft.submission.name) {
      throw BadInput(drafts_[i - 1].origin + " and " + draft.origin + " are both the submission \"" +
                     draft.submission.name + "\"; rename one of them");
    }
    if (!draft.refused() && draft.submission.files.empty()) {
      draft.refuse("None of the exercise files is in it (" + file_names() +
                   "). Check their names, and pack them again.");
    }
    submissions.push_back(std::move(draft.submission));
  }
  return submissions;
}

}  // namespace

std::vector<Submission> read_submissions(const std::vector<fs::path>& arguments, const Course& course,
                                         const IntakeLimits& limits) {
  Intake intake(course, limits);
  for (const fs::path& argument : arguments) intake.read_argument(argument);
  return intake.finish();
}

}  // namespace grader
