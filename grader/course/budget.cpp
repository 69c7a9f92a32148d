// STAFF ONLY. Declares the fields of a budget, with their names in course files, and their least limits.
#include "grader/course/budget.h"

namespace grader::inline course {
namespace {

constexpr BudgetField kFields[] = {
    {"idle_seconds", "idle time", &Budget::idle_seconds},
    {"worker_cpu_seconds", "CPU time", &Budget::worker_cpu_seconds, 2},
    {"compiler_cpu_seconds", "the compiler's CPU time", &Budget::compiler_cpu_seconds},
    {"suite_cpu_seconds", "the suite's CPU time", &Budget::suite_cpu_seconds, 2},
    {"restarts", "restarts", &Budget::restarts},
    {"messages", "messages", &Budget::messages, 5e5},
    {"megabytes", "bytes of messages", &Budget::megabytes, 100},
    {"wall_seconds", "time by the clock", &Budget::wall_seconds},
};

}  // namespace

std::span<const BudgetField> budget_fields() {
  return kFields;
}

Budget share_of(const Budget& budget, int parts) {
  Budget share;
  for (const BudgetField& field : kFields) share.*field.value = budget.*field.value / parts;
  return share;
}

Budget nothing_spent() {
  Budget nothing;
  for (const BudgetField& field : kFields) nothing.*field.value = 0;
  return nothing;
}

const char* used_up(const Budget& spent, const Budget& limit) {
  for (const BudgetField& field : kFields)
    if (spent.*field.value > limit.*field.value) return field.name;
  return nullptr;
}

}  // namespace grader::course
