// STAFF ONLY. How a request to a student's worker ended.
#pragma once

namespace grader::inline judge {

enum class Outcome {
  done,
  stopped,  // the suite stopped it after enough products
  not_implemented,
  threw,
  out_of_memory,
  crashed,
  timed_out,
  broke_rules,
  cannot_load,
  memory_error,  // the reply is a memory error, see grader/wire/memory_error.h
};

}  // namespace grader::judge
