// STAFF ONLY. For tests of workers: one request to a ConjGrad.
#pragma once

#include <filesystem>
#include <vector>

#include "grader/compile/toolchain.h"
#include "grader/judge/student/student.h"
#include "reference/S1/calls.h"

namespace grader::inline grading {

// Returns the answer of a worker with this object for n = 4 and the identity.
inline Answer ask_conj_grad(WorkerSetup setup, const StagedKit& kit, const std::filesystem::path& object,
                            int steps) {
  setup.kit = kit.folder();
  setup.exercise = "S1";
  setup.objects = {object};
  Student student(setup);
  const std::vector<double> values = {1, 2, 3, 4};
  MessageWriter request;
  request.put(s1::Calls::number_of<s1::conj_grad>()).put(0).put(4).put(4);  // operator 0 and its size
  request.put(std::span<const double>(values)).put(std::span<const double>(values)).put(1e-10).put(steps);
  return student.ask(request, [](int, const std::vector<double>& v, std::vector<double>& y) {
    y = v;
    return true;
  });
}

}  // namespace grader::grading
