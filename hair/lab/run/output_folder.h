// A folder that appears complete or not at all. Until then its files lie in a hidden folder next to it.
// Missing parent folders are made, and removed again if they are empty at the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// Recognises the output of a command in a folder. A command replaces only its own earlier output.
struct OutputKind {
  std::string command;             // "hairlab run"
  std::string record;              // this file always exists
  std::string begin;               // the first bytes of that file
  std::vector<std::string> files;  // the other files
  bool frames = false;             // also frame_name(0), ...
};

// The output of `hairlab run`.
const OutputKind& run_output();

class OutputFolder {
 public:
  // Throws BadInput if the folder can't be made, or if it holds anything other than output of this kind.
  explicit OutputFolder(const std::filesystem::path& folder, const OutputKind& kind = run_output());
  ~OutputFolder();  // removes the files unless keep() was called
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  std::filesystem::path now(const std::string& name) const { return temporary_ / name; }  // until keep()
  std::filesystem::path then(const std::string& name) const { return folder_ / name; }    // afterwards
  const std::filesystem::path& path() const { return folder_; }

  // Moves the output to its final place. If it throws BadInput, the earlier content stays.
  void keep();

 private:
  void clean_up() const;

  OutputKind kind_;
  std::filesystem::path folder_, temporary_;
  std::vector<std::filesystem::path> above_;  // the folders that were made, the innermost first
};

// Writes a whole file of the folder at once. Throws BadInput if it can't be written.
void write_whole(const OutputFolder& folder, const std::string& name, std::string_view bytes);

// "frame-0007.png"
std::string frame_name(int frame);

// A file that is written piece by piece. It lies in a run's temporary folder; errors name its final path.
class OutputFile {
 public:
  // All functions throw BadInput with `shown` and the reason.
  OutputFile(const std::filesystem::path& file, std::filesystem::path shown);
  void write(std::string_view bytes);
  void overwrite(std::uint64_t at, std::string_view bytes);  // replaces bytes that were written before
  void close();

  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path shown_;
  int descriptor_;
  std::string buffer_;
};

}  // namespace hair
