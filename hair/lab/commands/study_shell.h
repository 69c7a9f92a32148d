// The common shell of all studies: options, a folder, a line of progress, Ctrl-C, and the end.
#pragma once

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/plot/columns.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/run/output_folder.h"

namespace hair {

struct ShellOptions {
  std::filesystem::path out;
  bool writes = true;  // into `out`
  bool quick = false;
  std::string when_quick;  // the changes by --quick
};

// Adds a command with --out and --quick, which `quick` describes. --out is required, unless the command
// decides otherwise.
CLI::App* add_study(CLI::App& program, const OtherCommand& command, ShellOptions& options, const char* quick,
                    bool out_is_required = true);

// Ctrl-C leaves nothing of a study, or what is finished.
enum class WhenInterrupted { loses, keeps };

class StudyShell {
 public:
  // From here on Ctrl-C sets interrupted(). The record, a JSON file, begins with the command's name. Throws
  // BadInput as OutputFolder does.
  StudyShell(const ShellOptions& options, const std::string& command, const std::string& record,
             std::vector<std::string> files, WhenInterrupted leaves);
  ~StudyShell() { say(""); }
  StudyShell(const StudyShell&) = delete;
  StudyShell& operator=(const StudyShell&) = delete;

  const std::atomic<bool>& interrupted() const { return interrupted_; }
  const OutputFolder& folder() const { return *folder_; }

  // Shows a line that replaces the last one, only on a terminal.
  void say(const std::string& what) const;
  std::function<void(const std::string&)> teller() const {
    return [this](const std::string& what) { say(what); };
  }

  // Writes the record, the page and the tables (names and rows; none without rows) and moves the folder to
  // its place; each call replaces the results of the call before. Adds program, quick and machine at the
  // start of the record, unless it has them, and the machine and --quick to the page.
  void keep(const OrderedJson& record, Page page,
            const std::vector<std::pair<std::string, std::vector<Row>>>& tables);

  // Prints the page's path, if one was kept, followed by `more`, and the state after an interruption. Returns
  // the exit code.
  int end(bool finished, const std::string& more = "") const;

 private:
  ShellOptions options_;
  OutputKind kind_;
  const std::atomic<bool>& interrupted_;
  std::optional<OutputFolder> folder_;
  bool terminal_, kept_ = false;
};

// Returns those of `all` that are asked for, in the order of `all`; all, if `ids` is empty. Throws BadInput,
// which begins with `where`.
template <class One>
std::vector<One> chosen(std::vector<One> all, const std::vector<std::string>& ids, const std::string& where) {
  std::string known;
  for (const One& one : all) known += (known.empty() ? "" : ", ") + one.id;
  for (const std::string& id : ids)
    if (std::ranges::none_of(all, [&](const One& one) { return one.id == id; }))
      throw BadInput(where + ": there is no \"" + printable(id) + "\"; there are " + known);
  if (!ids.empty())
    std::erase_if(all, [&](const One& one) { return std::ranges::find(ids, one.id) == ids.end(); });
  return all;
}

}  // namespace hair
