// STAFF ONLY. Commands that read or change the record of a folder of grades.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "grader/record/record.h"

namespace grader {

struct OfARecord {
  std::filesystem::path folder;
  std::string name;  // of a student
};

// The option and the argument that these commands share.
void add_folder(CLI::App& command, OfARecord& options);
void add_name(CLI::App& command, OfARecord& options);

// Throws BadInput, with a way out, for a folder without a record.
std::unique_ptr<Record> open_record(const std::filesystem::path& folder);

// Lets `change` change the record, then makes all files again. A hairgrade that grades into the folder is waited for after the
// change, so that an interruption loses none. Returns hairgrade's exit code.
int change_record(const std::filesystem::path& folder, const std::function<void(Record&)>& change);

}  // namespace grader
