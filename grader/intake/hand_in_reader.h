// STAFF ONLY. Takes the exercise files out of containers, also out of archives in them, for the submissions
// that share them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/intake/archives/archive.h"
#include "grader/intake/archives/container.h"
#include "grader/intake/draft.h"
#include "grader/intake/names/exercise_names.h"
#include "grader/intake/names/same_name.h"

namespace grader::inline intake {

// Holds a draft's part of a container.
struct Share {
  Draft* draft;
  std::vector<std::size_t> entries;  // are all counted entries; an archive or a document has only itself
  bool is_archive = false;           // its name is the submission's own
  bool is_document = false;          // stands in the place of an archive
  bool is_attached = false;          // has single files: archives beside exercise files are opened, too
};

// Holds all of a container that counts.
Share whole_share(Draft& draft, const std::vector<Entry>& list);

class HandInReader {
 public:
  HandInReader(const OpenArchive& open_archive, const IntakeLimits& limits, const FileNames& files)
      : open_archive_(open_archive), limits_(limits), files_(files) {}

  // `prefix` stands before names in messages; `depth` counts the archives around.
  void take(Container& container, const std::vector<Entry>& list, const std::vector<Share>& shares,
            const std::string& prefix = "", std::size_t depth = 0);

 private:
  // This is a file or an archive that must be read.
  struct Wanted {
    Draft* draft;
    std::string file;  // is the exercise file, or kAboutFile; "": an archive
    Found where;
  };
  using Plan = std::map<std::size_t, Wanted>;

  Plan plan_share(const std::vector<Entry>& list, const Share& share, const std::string& prefix,
                  std::size_t depth);
  void plan_files(const std::vector<Entry>& list, Draft& draft, const std::string& file,
                  std::vector<Candidate>& candidates, const std::string& prefix, Plan& plan);
  void plan_archives(const std::vector<Entry>& list, const Share& share,
                     const std::vector<std::size_t>& archives, const std::string& prefix, std::size_t depth,
                     Plan& plan);
  static void take_about(Draft& draft, const std::string& shown, const Container::Read& read);
  void take_archive(Draft& draft, std::string bytes, const std::string& shown, std::size_t depth);

  const OpenArchive& open_archive_;
  IntakeLimits limits_;
  const FileNames& files_;
};

}  // namespace grader::intake
