// A folder that appears whole, or not at all. Until then what is in it lies in a hidden folder beside it; the folders
// above it are made, and go again if they are empty at the end.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// What a command writes into a folder, and knows it by: its own earlier output it replaces, and nothing else.
struct OutputKind {
  std::string_view command;             // "hairlab run"
  std::string_view record;              // "run.json": is always there
  std::string_view begin;               // how that file begins
  std::vector<std::string_view> files;  // beside it
  bool frames = false;                  // and frame_name(0), ...
};

// Of `hairlab run`.
const OutputKind& run_output();

class OutputFolder {
 public:
  // Throws BadInput for a folder that can't be made, and for one that holds anything but what `kind` says.
  explicit OutputFolder(const std::filesystem::path& folder, const OutputKind& kind = run_output());
  ~OutputFolder();  // removes what was not kept
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  std::filesystem::path now(const std::string& name) const { return temporary_ / name; }  // where a file lies
  std::filesystem::path then(const std::string& name) const { return folder_ / name; }    // where it will be
  const std::filesystem::path& path() const { return folder_; }

  // The record of the study that is there, to go on from. Throws BadInput if there is none.
  std::filesystem::path earlier_record() const;

  // Puts it in its place. Throws BadInput; what was there before then stays.
  void keep();

 private:
  void clean_up() const;

  OutputKind kind_;
  std::filesystem::path folder_, temporary_;
  std::vector<std::filesystem::path> above_;  // those that were not there, the innermost first
};

// A file of the folder at once. Throws BadInput if it can't be written.
void write_whole(const OutputFolder& folder, const std::string& name, std::string_view bytes);

// "frame-0007.png"
std::string frame_name(int frame);

}  // namespace hair
