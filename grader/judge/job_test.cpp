// STAFF ONLY. Tests that a job survives being written and read.
#include "grader/judge/job.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/result/check_fields.h"

namespace grader::inline judge {
namespace {

// All members differ from their defaults.
SuiteJob job() {
  SuiteJob job;
  job.exercise = "H4";
  job.seed = "5eed";
  job.kit = "/tmp/kit";
  job.provided = {"S1", "P1"};
  job.objects = {"/tmp/a b/H4.so", "/tmp/ö.so"};
  job.log = "/tmp/log";
  job.isolation = Isolation::none;
  job.cpu_seconds = 7;
  job.allowance = {1, 2, 3, 4, 5, 6, 7};
  job.pictures = "/tmp/pictures";
  job.whole_run = {"/tmp/scene.json", "5eed2", "/tmp/runner.so", 9};
  job.left_out = {"H9", "H10"};
  job.unavailable = {{"H4", "does not compile"}};
  job.reference_objects = {"/tmp/lib/S1.so"};
  job.motions = "/tmp/motions";
  return job;
}

TEST(SuiteJob, ComesBackWhole) {
  for (const SuiteJob& one : {job(), SuiteJob{}}) {
    const std::string text = to_json(one);
    EXPECT_EQ(suite_job_from_json(text, "a.json"), one) << text;
    EXPECT_EQ(text.find('\n'), text.size() - 1);
  }
}

TEST(SuiteJob, EachOfItsFieldsIsChecked) {
  expect_each_field_checked(
      nlohmann::json::parse(to_json(job())),
      [](const std::string& text) { suite_job_from_json(text, "a.json"); },
      [](const std::string& place) { return place == "/unavailable/H4"; });
}

}  // namespace
}  // namespace grader::judge
