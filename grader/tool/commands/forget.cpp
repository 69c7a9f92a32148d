// STAFF ONLY. `hairgrade forget`: removes all data of a student from record, pages and pictures.
#include <iostream>

#include "grader/class_folder/class_files.h"
#include "grader/class_folder/folder_of_grades.h"
#include "grader/class_folder/shared_plan.h"
#include "grader/course/input.h"
#include "grader/report/report.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

int forget(const OfARecord& options) {
  const std::vector<std::unique_ptr<Record>> hand_ins = open_hand_ins(options.folder);
  const std::optional<FolderLock> lock = FolderLock::take(options.folder, note_interruptions(), std::cerr);
  if (!lock) {
    std::cerr << "hairgrade: interrupted while it waited; nothing was removed\n";
    return kInterrupted;
  }
  if (!options.name.empty()) {
    if (SharedPlan::in(options.folder))
      throw BadInput(options.folder.string() + ": its hand-ins are on a cluster, which would bring " +
                     printable(options.name) + " back; hairgrade collect first");
    hand_ins.front()->forget(options.name);
    for (const std::unique_ptr<Record>& one : hand_ins) remove_reports(one->pages(), options.name);
  }
  for (const std::unique_ptr<Record>& one : hand_ins) write_class_files(options.folder, *one);
  hand_ins.front()->shred();
  if (!SharedPlan::in(options.folder)) SharedPlan::clear(options.folder);
  std::cout
      << "record, pages and pictures hold nothing of "
      << (options.name.empty() ? "those who were forgotten" : options.name)
      << " any more; archives, copies of this folder and the cache of compiled objects are yours to delete\n";
  return 0;
}

}  // namespace

Command add_forget(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  CLI::App* command =
      hairgrade.add_subcommand("forget", "Remove all of a student from record, pages and pictures");
  command->add_option("NAME", options->name,
                      "The student; without one, what an interrupted forget has left is cleared");
  command
      ->add_option("--out", options->folder, "The folder of grades; all of its hand-ins are looked through")
      ->required();
  return {command, [options] { return forget(*options); }};
}

}  // namespace grader::tool
