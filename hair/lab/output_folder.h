// A run's folder: it appears whole, or not at all. Until then what is in it lies in a hidden folder beside it.
#pragma once

#include <filesystem>
#include <string>

namespace hair {

class OutputFolder {
 public:
  // Throws BadInput for a folder that can't be made, and for one that holds anything but a run's files: an
  // earlier run is replaced, and nothing else is.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();  // removes what was not kept
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  std::filesystem::path now(const std::string& name) const { return temporary_ / name; }  // where a file lies
  std::filesystem::path then(const std::string& name) const { return folder_ / name; }    // where it will be
  const std::filesystem::path& path() const { return folder_; }

  // Puts it in its place. Throws BadInput; an earlier run then stays.
  void keep();

 private:
  std::filesystem::path folder_, temporary_;
};

// "frame-0007.png"
std::string frame_name(int frame);

}  // namespace hair
