// STAFF ONLY. Divides an argument by its names alone into hand-ins and their entries. No file of them is read
// yet.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/draft.h"
#include "grader/intake/hand_in_reader.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

inline constexpr std::size_t kLongestPathShown = 4096;

// This is a file or folder of the command line.
struct Argument {
  std::filesystem::path file;
  std::string origin;    // as it was given
  std::string path;      // from the root on
  std::string name;      // is its last part
  std::string shown;     // has the last two parts, for people
  bool on_disk = false;  // is a folder
};
Argument argument_at(const std::filesystem::path& file);
// Throws BadInput for a file that can't be a submission.
Argument checked_argument(const std::filesystem::path& file);

// Makes a draft of the argument, or of a path `below` it.
Draft new_draft(const Owner& owner, const Argument& argument, const std::string& below,
                const IntakeLimits& limits);

struct Arguments {
  bool several = false;  // each argument is then one student's hand-in
  bool classes = false;  // the caller says that each may be a class
  bool may_be_class() const { return classes || !several; }
};

// Holds the drafts of an argument, and their parts of its container.
struct Planned {
  std::vector<Draft> drafts = {};
  std::vector<Share> shares = {};  // in the order of the drafts; they point to them at the end
  std::vector<Accounted> nobodys = {};
  bool is_class = false;
  const System* system = nullptr;
};

// Opens the archive that is this entry of a list. Throws Refused.
using OpenEntry = std::function<std::unique_ptr<Container>(std::size_t entry)>;

// Opens a class that comes as several downloads, one for each section, in a folder or an archive, as if they
// were folders. A hand-in can look like a download, so one student's archive must not decide: all archives
// are downloads, or none is opened. `outer` has the entries `list`, whose names are settled, as the result's
// are. Returns null unless at least `least` archives lie side by side and are downloads of one system: of
// `said`, if that is not null.
std::shared_ptr<Container> open_sections(std::shared_ptr<Container> outer, std::vector<Entry> list,
                                         std::size_t least, const System* said, const OpenEntry& open);

struct Planner {
  const FileNames& files;
  const IntakeLimits& limits;
  const Arguments& arguments;
  const IntakeChoices& choices;
  std::function<std::shared_ptr<Container>()> opened{};  // opens the argument once more, for its tables

  // Returns nothing if no learning system gives such names. Paths of flat names become folders in `list`.
  std::optional<Planned> by_system(std::vector<Entry>& list, const Argument& argument) const;
  // Throws BadInput if there is neither an exercise file nor an archive.
  Planned by_folders(const std::vector<Entry>& list, const Argument& argument) const;
};

}  // namespace grader::intake
