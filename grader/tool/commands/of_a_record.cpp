// STAFF ONLY. Opens records for commands, and makes files again after a change.
#include "grader/tool/commands/of_a_record.h"

#include <algorithm>
#include <iostream>
#include <set>

#include "grader/class_folder/class_files.h"
#include "grader/class_folder/folder_of_grades.h"
#include "grader/course/input.h"
#include "grader/intake/names/names.h"
#include "grader/record/points/hand_ins.h"
#include "grader/text/letters.h"
#include "grader/text/time_text.h"
#include "grader/tool/commands/command.h"

namespace grader::inline tool {
namespace {

void check_record(const std::filesystem::path& folder) {
  if (!Record::is_in(folder))
    throw BadInput(printable(folder.string(), 4096) + ": has no " + kRecordFile +
                   "; name a folder that hairgrade grade has written, with --out");
}

}  // namespace

void add_folder(CLI::App& command, OfARecord& options) {
  needed_elsewhere(command.add_option("--out", options.folder, "The folder of grades"), options.folder,
                   kGrades);
  add_hand_in(command, options.hand_in);
}

void add_hand_in(CLI::App& command, std::string& hand_in) {
  command.add_option("--hand-in", hand_in, "Of a course with several hand-ins: the name of this one");
}

void add_name(CLI::App& command, OfARecord& options) {
  command
      .add_option("NAME", options.name,
                  "A student: a folder of reports, or a name, id or e-mail address of the roster")
      ->required();
}

void add_place_of_words(CLI::App& command, std::string& place) {
  command
      .add_option(
          "PLACE", place,
          "An exercise, \"H2\"; its third category, \"H2.3\"; line 17 of its file, \"H2:17\"; or \"all\"")
      ->required();
}

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

std::string hand_in_called(Record& record, const std::string& name) {
  const std::vector<std::string> names = record.names();
  if (std::ranges::count(names, name) > 0 || record.is_blind()) return name;
  const NameKeys keys = keys_of(name);
  const std::string id = lowered(plain_id(name));
  std::set<std::string> meant;
  bool is_known = false;
  const auto add = [&](const NameKeys& theirs, const auto& ids, const std::vector<std::string>& hand_ins) {
    const bool by_name = !keys.as_spoken.empty() && (theirs == keys || theirs.as_spoken == keys.as_sorted);
    const auto is_theirs = [&](const std::string& one) {
      return !one.empty() && lowered(plain_id(one)) == id;
    };
    if (!by_name && std::ranges::none_of(ids, is_theirs)) return;
    is_known = true;
    meant.insert(hand_ins.begin(), hand_ins.end());
  };
  if (const std::optional<ClassList> list = record.class_list())
    for (const ClassList::Row& row : list->rows) add(row.person.keys, row.person.ids, row.hand_ins);
  for (const HandIn& hand_in : record.hand_ins()) {
    std::vector<Owner> owners = hand_in.owner.members;
    owners.push_back(hand_in.owner);
    for (const Owner& owner : owners)
      add(keys_of(owner.name), std::vector{owner.id, owner.email}, {hand_in.name});
  }
  if (meant.size() > 1)
    throw BadInput(printable(name) + ": may be " + some_of({meant.begin(), meant.end()}) +
                   "; write one of these");
  if (meant.empty() && is_known)
    throw BadInput(printable(name) +
                   ": handed in nothing, so there are no points to change; write them into the gradebook");
  return meant.empty() ? name : *meant.begin();
}

std::string without_time(Record& record, const std::vector<std::string>& names) {
  std::vector<std::string> unknown;
  for (const std::string& name : names)
    if (!read_time(record.handed_in(name))) unknown.push_back(name);
  return unknown.empty() ? "" : some_of(unknown);
}

int change_record(const OfARecord& options,
                  const std::function<void(Record&, const std::string& name)>& change) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  change(*record, hand_in_called(*record, options.name));
  const std::optional<FolderLock> lock = FolderLock::take(options.folder, note_interruptions(), std::cerr);
  if (!lock) {
    std::cerr
        << "hairgrade: interrupted while it waited; the change is kept, and the next run writes the files\n";
    return kInterrupted;
  }
  write_class_files(options.folder, *record);
  return 0;
}

}  // namespace grader::tool
