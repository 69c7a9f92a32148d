// STAFF ONLY. Opens records for commands, and makes files again after a change.
#include "grader/tool/commands/of_a_record.h"

#include <iostream>

#include "grader/course/input.h"
#include "grader/tool/class_files.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/folder_of_grades.h"

namespace grader {

void add_folder(CLI::App& command, OfARecord& options) {
  command.add_option("--out", options.folder, "The folder of grades")->required();
}

void add_name(CLI::App& command, OfARecord& options) {
  command.add_option("NAME", options.name, "A student, as the folders of reports are called")->required();
}

std::unique_ptr<Record> open_record(const std::filesystem::path& folder) {
  if (!Record::is_in(folder))
    throw BadInput(printable(folder.string(), 4096) + ": has no " + kRecordFile +
                   "; name a folder that hairgrade grade has written, with --out");
  return std::make_unique<Record>(folder);
}

int change_record(const std::filesystem::path& folder, const std::function<void(Record&)>& change) {
  const std::unique_ptr<Record> record = open_record(folder);
  change(*record);
  const std::optional<FolderLock> lock = FolderLock::take(folder, note_interruptions(), std::cerr);
  if (!lock) {
    std::cerr
        << "hairgrade: interrupted while it waited; the change is kept, and the next run writes the files\n";
    return 130;
  }
  write_class_files(folder, *record);
  return 0;
}

}  // namespace grader
