// STAFF ONLY. Tests whole runs of the suite: they move as in one process with all objects, the student's
// process holds no reference, and an answer of any kind ends only the run, not the suite.
#include "grader/judge/run/played.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <utility>

#include "grader/course/course.h"
#include "grader/judge/run/whole_run.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/processes/processors.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;

const fs::path kKit = HAIR_KIT_DIR, kRunners = HAIR_RUNNERS, kHiddenScenes = HAIR_HIDDEN_SCENES;

std::vector<Exercise> exercises() {
  return read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises;
}

std::vector<std::string> played_exercises() {
  std::vector<std::string> ids;
  for (const Exercise& one : exercises())
    if (fs::exists(kHiddenScenes / (one.id + ".json"))) ids.push_back(one.id);
  return ids;
}

HiddenScene hidden_scene(const std::string& exercise, const std::string& seed = "a seed") {
  return read_hidden_scene(kHiddenScenes / (exercise + ".json"), seed);
}

// Runs the reference as a student's object, outside of the kit.
class StudentPlay : public testing::TestWithParam<std::string> {
 protected:
  StudentPlay() {
    fs::permissions(folder_, fs::perms(0755));
    signal(SIGPIPE, SIG_IGN);
    for (const Exercise& one : exercises())
      if (one.id == id()) setup_.provided = one.prerequisites;
    fs::copy(kKit / "lib" / (id() + ".so"), object());
    setup_.kit = kKit;
    setup_.exercise = id();
    setup_.objects = {object()};
    setup_.log = folder_ / "log";
    setup_.isolation = Isolation::none;
  }
  const std::string& id() const { return GetParam(); }
  fs::path runner() const { return kRunners / (id() + ".so"); }
  fs::path object() const { return folder_ / (id() + ".so"); }

  // Runs, and lets `reply` change each reply before the scene's code sees it.
  PlayResult play(const std::function<MessageReader(int call, MessageReader)>& reply) {
    Student student(setup_);
    Trial trial(student, Random("", ""));
    int calls = 0;
    PlayResult result;
    load_runner(runner())(
        hidden_scene(id()).scene,
        [&](const MessageWriter& request, const Products& products) {
          return reply(calls++, trial.ask(request, products));
        },
        result);
    return result;
  }

  Processors processors_;
  const Processors::Lease lease_{processors_};  // binds both ends to one processor, as grading does
  hair::TemporaryFolder temporary_{"student-play"};
  fs::path folder_ = temporary_.path();
  WorkerSetup setup_;
};

std::vector<std::byte> bytes_of(MessageReader reply) {
  std::vector<std::byte> bytes;
  try {
    for (;;) bytes.push_back(static_cast<std::byte>(reply.get<std::uint8_t>()));
  } catch (const MalformedMessage&) {
  }
  return bytes;
}

bool same_bits(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0;
}

TEST_P(StudentPlay, IsTheMotionOfAllObjectsInOneProcessToTheLastBit) {
  WorkerSetup together = setup_;
  together.exercise = "runs";
  together.provided.clear();
  together.objects.clear();
  for (const Exercise& one : exercises()) together.objects.push_back(kKit / "lib" / (one.id + ".so"));
  for (const char* seed : {"a seed", "another seed"}) {
    const HiddenScene hidden = hidden_scene(id(), seed);
    Student all(together), student(setup_);
    Trial in_one_process(all, Random("", "")), asked(student, Random("", ""));
    const Played expected = play_elsewhere(in_one_process, hidden.text, hidden.scene);
    const Played played = play_with_student(asked, runner(), hidden.scene);
    EXPECT_EQ(played.trouble, "");
    EXPECT_EQ(played.solver_steps, expected.solver_steps);
    EXPECT_EQ(played.correction_steps, expected.correction_steps);
    ASSERT_EQ(played.frames.size(), expected.frames.size());
    for (std::size_t i = 0; i < played.frames.size(); ++i) {
      ASSERT_TRUE(same_bits(played.frames[i].x, expected.frames[i].x)) << "positions of frame " << i;
      ASSERT_TRUE(same_bits(played.frames[i].v, expected.frames[i].v)) << "velocities of frame " << i;
    }
  }
}

pid_t parent_of(const fs::path& process) {
  std::ifstream status(process / "status");
  std::string word;
  while (status >> word && word != "PPid:") {
  }
  pid_t parent = 0;
  status >> parent;
  return parent;
}

// Lists the files that runs, children of our supervisors, have mapped, except the system's.
std::set<std::string> mapped_by_runs() {
  std::set<std::string> files;
  for (const fs::directory_entry& process : fs::directory_iterator("/proc")) {
    const pid_t supervisor = parent_of(process.path());
    if (supervisor <= 1 || parent_of("/proc/" + std::to_string(supervisor)) != getpid()) continue;
    std::ifstream maps(process.path() / "maps");
    for (std::string line; std::getline(maps, line);)
      if (const std::size_t path = line.find('/'); path != std::string::npos) {
        const std::string file = line.substr(path);
        if (!file.starts_with("/usr/lib") && !file.starts_with("/lib")) files.insert(file);
      }
  }
  return files;
}

TEST_P(StudentPlay, LeavesNoReferenceInTheStudentsProcess) {
  if (const std::string why = why_not(Isolation::namespaces); !why.empty())
    GTEST_SKIP() << why << "; a container's root may not ask which files another user's process has mapped";
  std::set<std::string> expected = {kKit / "worker", kKit / "serve" / (id() + ".so"), object()};
  for (const std::string& one : setup_.provided) expected.insert(kKit / "provided" / (one + ".so"));
  int looks = 0;
  play([&](int call, MessageReader reply) {
    if (call % 100 == 0) {
      EXPECT_EQ(mapped_by_runs(), expected);
      ++looks;
    }
    return reply;
  });
  EXPECT_GT(looks, 0);
}

TEST_P(StudentPlay, EndsAtAReplyOfAnotherForm) {
  // A single number has the right format whatever its bits are.
  const auto with = [&](const std::function<void(std::vector<std::byte>&)>& change) {
    return play([&, changed = false](int call, MessageReader reply) mutable {
      std::vector<std::byte> bytes = bytes_of(std::move(reply));
      if (call >= 7 && bytes.size() > sizeof(double) && !std::exchange(changed, true)) change(bytes);
      return MessageReader(bytes);
    });
  };
  EXPECT_EQ(with([](auto& bytes) { bytes.clear(); }).end, PlayEnd::malformed);
  EXPECT_EQ(with([](auto& bytes) { bytes.pop_back(); }).end, PlayEnd::malformed);
  EXPECT_EQ(with([](auto& bytes) { bytes.push_back(std::byte{0}); }).end, PlayEnd::malformed);
  EXPECT_EQ(with([](auto& bytes) { std::fill(bytes.begin(), bytes.end(), std::byte{0xff}); }).end,
            PlayEnd::malformed);
}

// The run ends whatever numbers are in replies of the right format.
TEST_P(StudentPlay, SurvivesAnyNumbers) {
  Random random("numbers", id());
  for (int round = 0; round < 8; ++round) {
    const int when = random.integer(0, 40), every = random.integer(1, 9);
    const bool nan = round % 2 == 0;
    play([&](int call, MessageReader reply) {
      std::vector<std::byte> bytes = bytes_of(std::move(reply));
      if (call >= when && call % every == 0) {
        // Changes bytes after the first length, in or between numbers; or all of a single number.
        const int eights = static_cast<int>(bytes.size()) / 8;
        const auto at =
            eights < 2 ? 0 : std::size_t{8} * static_cast<std::size_t>(random.integer(1, eights - 1));
        for (std::size_t i = at; i < std::min(at + 8, bytes.size()); ++i)
          bytes[i] = nan ? std::byte{0xff} : static_cast<std::byte>(random.integer(0, 255));
      }
      return MessageReader(bytes);
    });
  }
}

// Honest runs stay far below what an exercise may take of the budget.
TEST_P(StudentPlay, TakesLittleOfTheBudget) {
  play([](int, MessageReader reply) { return reply; });
  const Budget share = share_of(Budget(), 11), &spent = setup_.allowance->spent;
  EXPECT_LT(spent.messages, share.messages / 10);
  EXPECT_LT(spent.megabytes, share.megabytes / 10);
  EXPECT_LT(spent.worker_cpu_seconds, share.worker_cpu_seconds / 4);
  EXPECT_LT(spent.suite_cpu_seconds, share.suite_cpu_seconds / 2);  // holds for a build with sanitisers, too
  EXPECT_LT(spent.idle_seconds, share.idle_seconds / 2);
}

INSTANTIATE_TEST_SUITE_P(Of, StudentPlay, testing::ValuesIn(played_exercises()),
                         [](const auto& one) { return one.param; });

}  // namespace
}  // namespace grader::judge
