// STAFF ONLY. Tests grading on a cluster from outside. Programs with the names of Slurm's run each task at
// once, but for the last job; grader/tests/slurm/test has a real cluster.
#include "grader/record/record.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

constexpr const char* kSbatch = R"(#!/bin/bash
for word; do
  case $word in
    --wrap=*) command=${word#--wrap=} ;;
    --array=0-*) last=${word#--array=0-} ;;
    --output=*) log=${word#--output=} ;;
    --dependency=*) last=-1 ;;
  esac
done
echo 7
export SLURMD_NODENAME=n1 SLURM_ARRAY_TASK_ID
for SLURM_ARRAY_TASK_ID in $(seq 0 "${last:-0}"); do
  if [ -e "${0%/*}/broken" ]; then
    echo "the node is lost" >>"${log/\%a/$SLURM_ARRAY_TASK_ID}"
    code=1
  else
    sh -c "$command" >>"${log/\%a/$SLURM_ARRAY_TASK_ID}" 2>&1
    code=$?
  fi
done
exit "${code:-0}"
)";

class OnACluster : public InAFolder {
 protected:
  OnACluster() : InAFolder(course_of({"S1", "S2"})) {
    program("sbatch", kSbatch);
    program("scontrol", "#!/bin/sh\necho MaxArraySize = 1\n");
    program("squeue", "#!/bin/sh\n");
    const string right = hair::bytes_of(fs::path(HAIR_PROJECT) / "reference/S1/conj_grad.cpp");
    write("class/ada/conj_grad.cpp", right);
    write("class/ben/conj_grad.cpp", right + "int x = ;\n");
    write("class/eve/conj_grad.cpp", "");
  }
  void program(const string& name, const string& text) const {
    fs::permissions(write("bin/" + name, text), fs::perms::owner_all);
  }
  ProgramRun hairgrade(const std::vector<string>& words) const {
    return run_hairgrade(words, {}, "PATH=" + path("bin") + ":$PATH");
  }
  ProgramRun send(const std::vector<string>& more = {}) const {
    std::vector<string> words = {
        "grade",    path("class"),       "--class",     "--out",   path("grades"), "--secret", path("secret"),
        "--course", path("course.json"), "--no-images", "--slurm", "--per-task",   "2"};
    words.insert(words.end(), more.begin(), more.end());
    return hairgrade(words);
  }
  // All results but the first are lost.
  void lose_results() const {
    std::vector<fs::path> lost;
    for (const auto& entry : fs::recursive_directory_iterator(path("grades")))
      if (entry.path().parent_path().filename() == "results" && entry.path().filename() != "0")
        lost.push_back(entry.path());
    for (const fs::path& one : lost) fs::remove(one);
  }
  std::map<string, string> timeless() const {
    std::map<string, string> files = files_in(path("grades"));
    for (const char* name : {"timing.json", "costs.html"}) files.erase(name);
    return files;
  }
};

TEST_F(OnACluster, IsGradedAsOnOneMachineAndSentAgainIfTasksAreLost) {
  ASSERT_EQ(grade({path("class"), "--class"}).code, 0);
  const std::map<string, string> here = timeless();
  fs::remove_all(path("grades"));

  write("bin/broken", "");
  expect_refused(send(), "and nothing was sent: the node is lost");
  EXPECT_FALSE(fs::exists(path("grades")));

  fs::remove(path("bin/broken"));
  const ProgramRun sent = hairgrade({"collect", path("grades")});
  expect_refused(sent, "none of its hand-ins are on a cluster");
  ASSERT_EQ(send().code, 0);
  EXPECT_TRUE(says(send().errors, "are on a cluster; hairgrade collect"));
  lose_results();
  program("squeue", "#!/bin/sh\nexit 1\n");
  expect_refused(hairgrade({"collect", path("grades")}), "squeue does not answer");
  program("squeue", "#!/bin/sh\n");
  write("bin/broken", "");
  const ProgramRun lost = hairgrade({"collect", path("grades")});
  EXPECT_EQ(lost.code, 3) << lost.errors;
  EXPECT_TRUE(says(lost.errors, "task 7_0 has not graded 1: "));
  EXPECT_TRUE(says(lost.output, "2 hand-ins in 1 tasks"));
  fs::remove(path("bin/broken"));
  const ProgramRun again = hairgrade({"collect", path("grades")});
  EXPECT_EQ(again.code, 3) << again.errors;
  EXPECT_TRUE(says(again.errors, "task 7_0 has not graded 2: the node is lost"));
  const ProgramRun all = hairgrade({"collect", path("grades")});
  EXPECT_EQ(all.code, 0) << all.errors;
  EXPECT_EQ(timeless(), here);

  const ProgramRun same = send({"--resume"});
  EXPECT_EQ(same.code, 0) << same.errors;
  EXPECT_TRUE(says(same.output, "0 graded, 3 kept from before"));
}

TEST_F(OnACluster, CancelsTheFirstTaskWhenItIsInterrupted) {
  program("sbatch", "#!/bin/sh\necho 7\nkill -INT $PPID\nexit 1\n");
  program("scancel", "#!/bin/sh\necho $* >" + path("cancelled") + "\n");
  const ProgramRun stopped = send();
  EXPECT_EQ(stopped.code, 130) << stopped.errors;
  EXPECT_TRUE(says(stopped.errors, "nothing was sent"));
  EXPECT_EQ(read("cancelled"), "7\n");
  EXPECT_FALSE(says(send().errors, "are on a cluster"));
}

TEST_F(OnACluster, LogsAResultOnceThoughSlurmTakesNoMoreAndItIsCollectedTwice) {
  ASSERT_EQ(grade({path("class"), "--class"}).code, 0);
  write("people.csv", "name,login\nAda,ada\nBen,ben\nEve,eve\n");
  write("times.csv", "login,time\nzoe,2027-03-01 10:00\n");
  const string no_last =
      string(kSbatch).insert(string(kSbatch).find("for word"), "[[ $* != *--dependency=* ]] || exit 1\n");
  program("sbatch", no_last);
  const ProgramRun sent =
      send({"--exercise", "S1", "--roster", path("people.csv"), "--times", path("times.csv")});
  EXPECT_EQ(sent.code, 2);
  EXPECT_TRUE(says(sent.errors, "sbatch does not take the job")) << sent.errors;
  EXPECT_TRUE(says(sent.errors, "hairgrade collect " + path("grades") + " takes what is graded"));
  EXPECT_TRUE(says(sent.errors, "zoe"));
  lose_results();
  program("sbatch", kSbatch);
  write("bin/broken", "");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(hairgrade({"collect", path("grades")}).code, 3);
  EXPECT_EQ(std::ranges::count(Record(path("grades")).log("ada"), "graded", &LogEntry::did), 2);
}

}  // namespace
}  // namespace grader
