// STAFF ONLY. What an argument holds, by its names alone: whose hand-ins there are, and which entries are
// whose. No file of them is read yet.
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
#include "grader/intake/several_people.h"

namespace grader::inline intake {

inline constexpr std::size_t kLongestPathShown = 4096;

// A file or folder that was given.
struct Argument {
  std::filesystem::path file;
  std::string origin;    // as it was given
  std::string path;      // from the root on
  std::string name;      // its last part
  std::string shown;     // the last two, for people
  bool on_disk = false;  // a folder
};
Argument argument_at(const std::filesystem::path& file);
// Throws BadInput for what can't be a submission.
Argument checked_argument(const std::filesystem::path& file);

// A hand-in of the argument, or of what lies `below` it.
Draft new_draft(const Owner& owner, const Argument& argument, const std::string& below,
                const IntakeLimits& limits);

// The drafts that an argument holds, and their parts of its container.
struct Planned {
  std::vector<Draft> drafts = {};
  std::vector<Share> shares = {};  // in the order of the drafts, which they point at in the end
  std::vector<Accounted> nobodys = {};
  bool is_class = false;
  const System* system = nullptr;
};

struct Planner {
  const FileNames& files;
  const IntakeLimits& limits;
  const Arguments& arguments;
  const IntakeChoices& choices;
  std::function<std::shared_ptr<Container>()> opened{};  // the argument once more, for tables in it

  // Empty if no learning system gives such names. Paths of flat names become folders in `list`.
  std::optional<Planned> by_system(std::vector<Entry>& list, const Argument& argument) const;
  // Throws BadInput if there is neither an exercise file nor an archive.
  Planned by_folders(const std::vector<Entry>& list, const Argument& argument) const;
};

}  // namespace grader::intake
