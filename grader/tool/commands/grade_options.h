// STAFF ONLY. The options of hairgrade grade, and the parts of its work.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/class_folder/batch.h"
#include "grader/class_folder/shared_plan.h"
#include "grader/roster/times.h"
#include "grader/tool/commands/grade_settings.h"

namespace grader::inline tool {

struct SlurmOptions {
  bool asked = false;
  std::string sbatch, prefix;     // are words for sbatch, and in front of a node's command
  std::size_t per_task = 0;       // counts hand-ins; 0: as many as last some ten minutes
  std::vector<std::string> step;  // is the part of a plan that this process does: its name, the plan, numbers
  std::string node;               // is the one that it does it on
};

struct GradeOptions {
  std::vector<std::filesystem::path> submissions;
  std::optional<std::filesystem::path> roster, times;
  GradeSettings settings;
  BatchSettings batch;
  SlurmOptions slurm;
  bool junit = false;
};

// Prints results and all that a person must look at. Returns hairgrade's exit code.
int say_graded(Isolation isolation, const GradeOptions& options, const Plan& plan, const Batch& batch,
               Record& record);

// Writes the plan for a cluster, tries one node, and sends tasks, unless all results stay. Returns
// hairgrade's exit code. Throws BadInput, and leaves nothing, if the node lacks a part.
int hand_over(const GradeOptions& options, const Plan& plan, const GradingSettings& settings, Record& record,
              const std::atomic<bool>& interrupted);

// Does a step: "first" and "share" on a node, "collect" and "last" where the record is.
int do_step(GradeOptions options);
int collect(GradeOptions options);

}  // namespace grader::tool
