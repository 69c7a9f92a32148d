// STAFF ONLY. Tests that a part of a batch that ended by wall time is graded once more at the end, before its
// result is reported.
#include "grader/class_folder/batch.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "grader/grading/settings_for_tests.h"
#include "grader/record/record.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/processes/identity.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

// S1 acts as on a machine that is busy at first: it sleeps until the test removes a pipe.
TEST(Batch, AsksOnceMoreForWhatTheClockEndedAlone) {
  const hair::TemporaryFolder folder("batch");
  const fs::path pipe = folder.path() / "pipe";
  GradingSettings settings = settings_for_tests();
  for (Exercise& exercise : settings.course.exercises)
    if (exercise.id != "S1" && exercise.id != "S2") exercise.role = Role::absent;
  settings.course.budget.idle_seconds = 1e4;
  settings.course.budget.wall_seconds = 16;  // half each
  settings.cache = HAIR_TEST_CACHE;
  settings.secret = "a secret for tests alone";
  settings.images = false;
  settings.isolation = Isolation::none;  // S1 sees the pipe

  const auto file = [&](const std::string& path, const std::string& before) {
    return SourceFile{before + hair::bytes_of(fs::path(HAIR_PROJECT) / "reference" / path), ""};
  };
  const std::string sleeps =
      "#include <fcntl.h>\n#include <unistd.h>\nstruct Sleeps { Sleeps() { if (open(\"" + pipe.string() +
      "\", O_RDONLY) >= 0) for (;;) sleep(1); } } sleeps;\n";
  Submission slow{.name = "slow", .origin = "slow"}, quick{.name = "quick", .origin = "quick"};
  slow.files = {{"conj_grad.cpp", file("S1/conj_grad.cpp", sleeps)},
                {"normal_equations.cpp", file("S2/normal_equations.cpp", "")}};
  quick.files = {{"normal_equations.cpp", file("S2/normal_equations.cpp", "")}};

  ASSERT_EQ(mkfifo(pipe.c_str(), 0644), 0);
  share_with_sandbox(folder.path(), false);
  fs::permissions(pipe, fs::perms(0644));
  const std::jthread watch([&](const std::stop_token& stop) {  // removes the pipe once S1 has opened it
    while (!stop.stop_requested() && !Descriptor(open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC)))
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    fs::remove(pipe);
  });
  const Grading grading(settings);
  BatchSettings batch;
  batch.out = folder.path() / "grades";
  batch.jobs = 2;
  fs::create_directory(batch.out);
  Record record(batch.out);
  Plan plan{{quick, slow}};
  enter_plan(plan, batch, record);
  const Batch graded = grade_batch(grader_here(grading), plan, batch, record, false);
  EXPECT_EQ(graded.graded, 2);
  EXPECT_EQ(graded.problems, std::vector<std::string>());
  const SubmissionResult result = record.find("slow").value().result;
  EXPECT_EQ(result.ended_by_the_clock, std::vector<std::string>());
  EXPECT_EQ(result.fingerprint, grading.fingerprint(slow));
  for (const ExerciseResult& exercise : result.exercises) {
    EXPECT_EQ(exercise.status, Status::passed) << exercise.id;
    EXPECT_EQ(exercise.feedback.find("not final"), std::string::npos) << exercise.feedback;
  }
}

}  // namespace
}  // namespace grader::class_folder
