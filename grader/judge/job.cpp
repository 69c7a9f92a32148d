// STAFF ONLY. Reads and writes the fields of a job.
#include "grader/judge/job.h"

#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"

namespace grader::inline judge {

const Rows<WholeRunJob>& rows_of(As<WholeRunJob>) {
  using T = WholeRunJob;
  static const Rows<T> all = {field("scene", &T::scene), field("seed", &T::seed), field("runner", &T::runner),
                              field("cpu_seconds", &T::cpu_seconds)};
  return all;
}

const Rows<SuiteJob>& rows_of(As<SuiteJob>) {
  using T = SuiteJob;
  static const Rows<T> all = {field("exercise", &T::exercise),
                              field("seed", &T::seed),
                              field("kit", &T::kit),
                              field("provided", &T::provided),
                              field("objects", &T::objects),
                              field("log", &T::log),
                              field("isolation", &T::isolation),
                              field("cpu_seconds", &T::cpu_seconds),
                              field("allowance", &T::allowance),
                              field("pictures", &T::pictures),
                              field("whole_run", &T::whole_run),
                              field("reproduce", &T::reproduce),
                              field("exercises", &T::exercises),
                              field("left_out", &T::left_out),
                              field("unavailable", &T::unavailable),
                              field("reference_objects", &T::reference_objects),
                              field("motions", &T::motions)};
  return all;
}

std::string to_json(const SuiteJob& job) {
  return json_text(job, -1);
}

SuiteJob suite_job_from_json(const std::string& text, const std::string& name) {
  return from_json_text<SuiteJob>(text, name);
}

}  // namespace grader::judge
