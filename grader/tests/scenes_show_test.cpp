// STAFF ONLY. Tests that bugs are visible: each wrong sample of an exercise moves visibly wrong in a scene of
// that exercise, or grader/samples/unseen.txt says why no scene can show it. The environment's HAIR_EXERCISE
// names the exercise, and HAIR_SAMPLE a single sample. The scenes are that of show-X (exercises.json), and
// those in the file.
//
// A sample's file is compiled as for grading, and a worker runs the scene with it, with the reference's files
// for all other exercises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "grader/compile/compiler.h"
#include "grader/judge/run/played.h"
#include "grader/judge/run/run_comparison.h"
#include "grader/samples/sample.h"
#include "grader/samples/solution_files.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/tests/run_program.h"
#include "grader/tests/side_by_side.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;

// Is the distance of a particle from the reference's, in the scene's size, that one sees at a glance. Right
// solutions may differ, since a hair that just touches something slides off to either side by a rounding;
// there wrong ones must be farther by kFarther.
constexpr double kSeen = 0.02;
constexpr double kFarther = 5;

struct SceneShown {
  std::string name;
  int frames = 0;  // counts its first frames; 0: all
};

// Holds the lines of unseen.txt: "scene S1 rod-pendulum", or "scene H10 guides-to-hair 2" for its first two
// frames; "unseen S1 returns-norm WHY".
struct Unseen {
  std::vector<SceneShown> scenes;
  std::map<std::string, std::string> why;  // by sample
};

Unseen unseen_of(const std::string& exercise) {
  Unseen all;
  std::ifstream file(kProject / "grader/samples/unseen.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind, id, name, why;
    words >> kind >> id >> name;
    std::getline(words >> std::ws, why);
    if (id != exercise) continue;
    if (kind == "scene") all.scenes.push_back({name, why.empty() ? 0 : std::stoi(why)});
    if (kind == "unseen") all.why[name] = why;
  }
  return all;
}

// Lists files that lose points and run.
std::vector<SampleProgram> bugs_of(const Exercise& exercise) {
  const std::string only = environment("HAIR_SAMPLE", "");
  return programs_of(exercise, kProject, [&](const Sample& sample, const std::string& status) {
    return runs_and_loses_points(status) && (only.empty() || sample.name == only);
  });
}

struct Seen {
  double distance = 0;      // in the scene's size
  std::string ending = {};  // differs from the reference's

  // `right` is another right solution's distance.
  bool at_a_glance(double right) const {
    return distance > std::max(kSeen, kFarther * right) || !ending.empty();
  }
  std::string text() const {
    std::ostringstream text;
    text.precision(2);
    text << 100 * distance << " %" << (ending.empty() ? "" : ", " + ending);
    return text.str();
  }
};

class ScenesShow : public testing::Test {
 protected:
  const Course course_ = read_course(kProject / "handout/exercises.json");
  const std::string id_ = environment("HAIR_EXERCISE", "");
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  const Compiler compiler_{kit_, fs::path(HAIR_GRADED) / "class-cache", isolation_for_tests()};

  void SetUp() override {
    ASSERT_NE(course_.find(id_), nullptr) << "HAIR_EXERCISE must name an exercise; it is \"" << id_ << "\"";
    if (scenes().empty()) GTEST_SKIP() << "no scene calls " << id_;
  }

  std::vector<SceneShown> scenes() const {
    std::vector<SceneShown> all = unseen_of(id_).scenes;
    std::smatch found;
    if (std::regex_search(course_.find(id_)->show, found, std::regex("^view ([a-z-]+)")) &&
        std::ranges::find(all, found[1].str(), &SceneShown::name) == all.end())
      all.insert(all.begin(), {found[1].str()});
    return all;
  }

  Seen see(const fs::path& object, const std::string& name, const SceneShown& shown) const {
    std::string text = hair::bytes_of(kProject / "hair/scenes" / (shown.name + ".json"));
    if (shown.frames > 0)
      text = std::regex_replace(text, std::regex("\"frames\": [0-9]+"),
                                "\"frames\": " + std::to_string(shown.frames));
    const hair::Scene scene = hair::parse_scene(text, shown.name);
    WorkerSetup worker;
    worker.kit = kit_.folder();
    worker.exercise = "runs";
    worker.log = kit_.new_job(name + "-" + shown.name) / "log";
    worker.isolation = isolation_for_tests();
    worker.cpu_seconds = 60;
    for (const Exercise& exercise : course_.exercises)
      worker.objects.push_back(exercise.id == id_ ? object : kit_.folder() / "lib" / (exercise.id + ".so"));
    Student student(worker);
    try {
      Trial trial(student, Random("", shown.name));
      const Played theirs = play_elsewhere(trial, text, scene);
      const RunComparison run = compare_runs(scene, {}, theirs);
      Seen seen;
      for (const Moment& moment : run.moments)
        seen.distance = std::max(seen.distance, std::max(moment.apart, moment.dense_apart) / run.size);
      if (!run.finite || !theirs.trouble.empty()) seen.ending = "breaks";
      return seen;
    } catch (const CaseFailed& failure) {
      return {0, to_string(failure.status)};
    } catch (const MalformedMessage&) {
      return {0, "stops"};
    }
  }

  // Returns another right solution's distance in each scene. Distances mean something only if it ends as the
  // reference does, near it.
  std::vector<double> right_distances() const {
    const Exercise& exercise = *course_.find(id_);
    const fs::path plain = kProject / "reference" / exercise.id / "right/plain.cpp";
    const Compiled compiled = compiler_.compile(exercise, hair::bytes_of(plain), kit_.new_job("plain"), 600);
    EXPECT_FALSE(compiled.object.empty()) << compiled.log;
    std::vector<double> distances;
    for (const SceneShown& scene : scenes()) {
      const Seen shown = see(compiled.object, "plain", scene);
      EXPECT_LT(kFarther * shown.distance, 0.2) << scene.name << ": wrong solutions have to be too far away";
      EXPECT_EQ(shown.ending, "") << scene.name;
      std::printf("%s, a right solution; %s %s\n", id_.c_str(), scene.name.c_str(), shown.text().c_str());
      distances.push_back(shown.distance);
    }
    return distances;
  }
};

TEST_F(ScenesShow, EachBugOrTheFileSaysWhyNot) {
  const std::vector<double> right = right_distances();
  const std::vector<SampleProgram> bugs = bugs_of(*course_.find(id_));
  Unseen unseen = unseen_of(id_);
  std::vector<std::string> rows(bugs.size());
  std::vector<char> seen(bugs.size());
  side_by_side(bugs.size(), [&](std::size_t i) {
    const fs::path job = kit_.new_job(bugs[i].name);
    const Compiled compiled = compiler_.compile(*course_.find(id_), bugs[i].source, job, 600);
    ASSERT_FALSE(compiled.object.empty()) << bugs[i].name << " does not compile:\n" << compiled.log;
    for (std::size_t k = 0; const SceneShown& scene : scenes()) {
      const Seen shown = see(compiled.object, bugs[i].name, scene);
      rows[i] += "; " + scene.name + " " + shown.text();
      seen[i] = seen[i] || shown.at_a_glance(right[k++]);
    }
  });
  int count = 0;
  for (std::size_t i = 0; i < bugs.size(); ++i) {
    const auto why = unseen.why.find(bugs[i].name);
    const bool excused = why != unseen.why.end();
    std::printf("%s %s%s%s\n", id_.c_str(), bugs[i].name.c_str(), rows[i].c_str(),
                excused ? ("; unseen: " + why->second).c_str() : "");
    count += seen[i];
    EXPECT_TRUE(seen[i] ? !excused : excused)
        << bugs[i].name << rows[i]
        << (excused ? ": a scene shows it. Strike it off grader/samples/unseen.txt"
                    : ": no scene shows it. Let one do so, or say in grader/samples/unseen.txt why none can");
    if (excused) unseen.why.erase(why);
  }
  if (environment("HAIR_SAMPLE", "").empty())
    for (const auto& [name, why] : unseen.why)
      ADD_FAILURE() << "grader/samples/unseen.txt names " << name << ", which is no bug of " << id_;
  std::printf("%s: scenes show %d of %zu bugs\n", id_.c_str(), count, bugs.size());
}

}  // namespace
}  // namespace grader
