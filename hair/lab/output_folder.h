// A folder that appears whole, or not at all. Until then what is in it lies in a hidden folder beside it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// What a command writes into a folder, and knows it by: its own earlier output it replaces, and nothing else.
struct OutputKind {
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

  // Puts it in its place. Throws BadInput; what was there before then stays.
  void keep();

 private:
  OutputKind kind_;
  std::filesystem::path folder_, temporary_;
};

// "frame-0007.png"
std::string frame_name(int frame);

}  // namespace hair
