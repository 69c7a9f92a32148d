// STAFF ONLY. Opens records for commands, and makes files again after a change.
#include "grader/tool/commands/of_a_record.h"

#include <iostream>

#include "grader/class_folder/class_files.h"
#include "grader/class_folder/folder_of_grades.h"
#include "grader/course/input.h"
#include "grader/record/points/hand_ins.h"
#include "grader/tool/commands/command.h"

namespace grader::inline tool {

void add_folder(CLI::App& command, OfARecord& options) {
  command.add_option("--out", options.folder, "The folder of grades")->required();
  add_hand_in(command, options.hand_in);
}

void add_hand_in(CLI::App& command, std::string& hand_in) {
  command.add_option("--hand-in", hand_in, "Of a course with several hand-ins: the name of this one");
}

void add_name(CLI::App& command, OfARecord& options) {
  command.add_option("NAME", options.name, "A student, as the folders of reports are called")->required();
}

void add_place_of_words(CLI::App& command, std::string& place) {
  command
      .add_option(
          "PLACE", place,
          "An exercise, \"H2\"; its third category, \"H2.3\"; line 17 of its file, \"H2:17\"; or \"all\"")
      ->required();
}

namespace {

void check_record(const std::filesystem::path& folder) {
  if (!Record::is_in(folder))
    throw BadInput(printable(folder.string(), 4096) + ": has no " + kRecordFile +
                   "; name a folder that hairgrade grade has written, with --out");
}

}  // namespace

std::unique_ptr<Record> open_record(const std::filesystem::path& folder, const std::string& hand_in) {
  check_record(folder);
  auto record = std::make_unique<Record>(folder, hand_in);
  check_hand_in(hand_in, record->named_hand_ins(), printable(folder.string(), 4096));
  return record;
}

std::vector<std::unique_ptr<Record>> open_hand_ins(const std::filesystem::path& folder) {
  check_record(folder);
  std::vector<std::unique_ptr<Record>> all;
  for (const std::string& name : Record(folder).named_hand_ins())
    all.push_back(std::make_unique<Record>(folder, name));
  if (all.empty()) all.push_back(std::make_unique<Record>(folder));
  return all;
}

int change_record(const OfARecord& options, const std::function<void(Record&)>& change) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  change(*record);
  const std::optional<FolderLock> lock = FolderLock::take(options.folder, note_interruptions(), std::cerr);
  if (!lock) {
    std::cerr
        << "hairgrade: interrupted while it waited; the change is kept, and the next run writes the files\n";
    return 130;
  }
  write_class_files(options.folder, *record);
  return 0;
}

}  // namespace grader::tool
