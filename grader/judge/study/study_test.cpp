// STAFF ONLY. Tests studies with runners of known speed and accuracy in place of workers, and
// their scenes.
#include "grader/judge/study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <thread>

#include "grader/judge/run/play_scene.h"
#include "grader/judge/study/scenes.h"
#include "grader/report/pages/pages.h"
#include "grader/report/pages/studies_section.h"
#include "hair/io/plot/test_parsed.h"
#include "hair/scene/scene_run.h"
#include "solver/test_refusal.h"

namespace grader::inline judge {
namespace {

using tests::says;

StudiedPart pendulum(const std::string& method) {
  for (const SceneText& text : studied_scenes())
    if (text.name == "pendulums")
      for (const StudiedPart& part : parts_of(text))
        if (part.name == "pendulums, " + method) return part;
  throw std::invalid_argument(method);
}

Truth truth_of(const StudiedPart& part) {
  static std::map<std::string, Truth> kept;
  const auto [place, is_new] = kept.try_emplace(part.name);
  if (is_new) place->second = true_motion(part, {});
  return place->second;
}

// Runs the reference in this process, by a clock of its own: `seconds_per_step` for each step.
struct Fake : Runner {
  double seconds_per_step = 1e-5;
  std::function<void(hair::Scene&)> change = [](hair::Scene&) {};
  std::function<void(Played&, int steps)> poison = [](Played&, int) {};
  int plays = 0;

  Play play(const SceneText& /*text*/, const hair::Scene& scene, int times) override {
    ++plays;
    hair::Scene mine = scene;
    change(mine);
    Play play;
    play_scene(mine, play.played);
    const int steps = scene.frames * scene.steps_per_frame;
    poison(play.played, steps);
    play.seconds = times * steps * seconds_per_step;
    return play;
  }
};

constexpr double kTwin = 1.1;  // times the reference's time

PartStudy study(const std::string& method, Fake& student, const StudySettings& settings = {},
                const Asked& asked = {}) {
  const StudiedPart part = pendulum(method);
  Fake reference, twin;
  twin.seconds_per_step *= kTwin;
  return study_part(part, truth_of(part), student, reference, twin, settings, asked);
}

// Returns the order of a curve's last doubling of steps.
double last_order(const StudyCurve& curve) {
  const StudyPoint &one = curve.points.at(curve.points.size() - 2), &two = curve.points.back();
  return std::log2(one.error / two.error) / std::log2(static_cast<double>(two.steps) / one.steps);
}

TEST(Study, OfTheReferenceBesideItselfHasEqualErrorsAndRatioOne) {
  Fake student;
  const PartStudy part = study("midpoint", student);
  ASSERT_EQ(part.student.points.size(), part.reference.points.size());
  EXPECT_GE(part.student.points.size(), 6U);
  for (std::size_t i = 0; i < part.student.points.size(); ++i) {
    EXPECT_EQ(part.student.points[i].steps, part.reference.points[i].steps);
    EXPECT_EQ(part.student.points[i].error, part.reference.points[i].error);
  }
  ASSERT_TRUE(part.ratio);
  EXPECT_DOUBLE_EQ(part.ratio->median, 1);
  EXPECT_NEAR(part.noise.value().median, kTwin, 1e-9);
  EXPECT_EQ(part.student.stable_steps, part.reference.stable_steps);
  EXPECT_EQ(part.note, "");
}

TEST(Study, AsksInTurnsAndSwapsThem) {
  Fake student;
  std::vector<std::pair<bool, int>> asked;
  StudySettings settings;
  const PartStudy part = study("symplectic Euler", student, settings,
                               [&](bool is_student, int steps) { asked.emplace_back(is_student, steps); });
  const std::size_t levels = part.student.points.size();
  // These are the warm-up, the errors, the repetitions of the reference, and the rounds.
  ASSERT_EQ(asked.size(), 3 + 3 * levels + levels + 3 * levels * static_cast<std::size_t>(settings.rounds));
  for (std::size_t at = 0; at < 3 + 3 * levels; ++at) EXPECT_EQ(asked[at].first, at % 3 == 0) << at;
  std::size_t at = 3 + 4 * levels;
  for (int round = 0; round < settings.rounds; ++round)
    for (const StudyPoint& point : part.student.points)
      for (int turn = 0; turn < 3; ++turn, ++at) {
        EXPECT_EQ(asked[at].first, (round + turn) % 3 == 0) << at;
        EXPECT_EQ(asked[at].second, point.steps) << at;
      }
  for (const StudyCurve* curve : {&part.student, &part.reference})
    for (const StudyPoint& point : curve->points)
      EXPECT_EQ(point.seconds.size(), static_cast<std::size_t>(settings.rounds));
}

TEST(Study, TellsHowManyTimesOurTimeAnErrorTakes) {
  Fake slow;
  slow.seconds_per_step = 3e-5;
  const PartStudy part = study("midpoint", slow);
  ASSERT_TRUE(part.ratio);
  EXPECT_NEAR(part.ratio->median, 3, 1e-9);
  for (std::size_t i = 0; i < part.student.points.size(); ++i)
    EXPECT_EQ(part.student.points[i].error, part.reference.points[i].error);
}

// An error that stalls is no method's, and neither is a dip in which errors cancel.
TEST(Study, ComparesOnlyWhereBothErrorsFall) {
  Fake stalls;
  stalls.poison = [](Played& played, int) {
    for (particles::State& state : played.frames) state.x.tail<3>().array() += 0.02;
  };
  EXPECT_FALSE(study("midpoint", stalls).ratio);

  const Truth truth = truth_of(pendulum("midpoint"));
  const std::vector<StudyPoint> points = study("midpoint", *std::make_unique<Fake>()).student.points;
  Fake dips;
  dips.poison = [&, at = points[2].steps](Played& played, int steps) {
    const std::size_t stride = (truth.motion.states.size() - 1) / (played.frames.size() - 1);
    for (std::size_t k = 0; steps == at && k < played.frames.size(); ++k) {
      const Eigen::VectorXd& there = truth.motion.states[k * stride].x;
      played.frames[k].x = there + 1e-3 * (played.frames[k].x - there);
    }
  };
  const PartStudy part = study("midpoint", dips);
  EXPECT_LT(part.student.points[2].error, 0.01 * part.reference.points[2].error);
  EXPECT_NEAR(part.ratio.value().median, 1, 1e-9) << "the other runs are the reference's";
}

TEST(Study, SaysWhetherARatioIsMoreThanNoise) {
  Fake equal, slow;
  slow.seconds_per_step = 3e-5;
  const auto shown = [](const PartStudy& part) { return report::in_words(part); };
  EXPECT_EQ(shown(study("midpoint", equal)), "1, within the noise, 0.826 to 1.21");
  EXPECT_EQ(shown(study("midpoint", slow)), "3, beyond the noise, 0.826 to 1.21");
  PartStudy none = study("midpoint", equal);
  none.ratio.reset();
  SubmissionResult result;
  result.name = "somebody";
  result.exercises.resize(1);
  result.exercises[0].id = "P1";
  result.exercises[0].status = Status::partly;
  const std::string page = study_page(result, {{{"pendulums", "Pendulums", "", {"P1"}, {none}}}});
  EXPECT_TRUE(says(page, "not compared: P1 is partly"));
  const std::string all =
      report::studies_section({{"ann", {{{"pendulums", "", "", {}, {study("midpoint", slow)}}}}}}).text;
  EXPECT_TRUE(says(all, "ann: 3"));
  EXPECT_TRUE(says(all, "1 of 1"));
}

TEST(Study, ShowsALostOrder) {
  Fake student;  // answers with forward Euler instead of midpoint
  student.change = [](hair::Scene& scene) { scene.toys.front().method = hair::ToyMethod::forward_euler; };
  const PartStudy part = study("midpoint", student);
  EXPECT_NEAR(last_order(part.student), 1, 0.2);
  EXPECT_NEAR(last_order(part.reference), 2, 0.2);
  ASSERT_TRUE(part.ratio);
  EXPECT_GT(part.ratio->median, 4)
      << "where both reach an error, midpoint is there in a fraction of the steps";
  EXPECT_GT(part.student.stable_steps, part.reference.stable_steps);
}

TEST(Study, FindsWhereAMethodStopsBeingStable) {
  // Each run with less than 100 steps runs away; only multiples of 12 can be run around there, so the first
  // stable one is 108.
  Fake student;
  student.poison = [](Played& played, int steps) {
    if (steps < 100) played.frames.back().x[5] += 1e3;
  };
  const PartStudy part = study("symplectic Euler", student);
  EXPECT_EQ(part.student.stable_steps, 108);
  EXPECT_FALSE(part.student.stable_everywhere);
  EXPECT_TRUE(part.reference.stable_everywhere);
  EXPECT_EQ(part.reference.stable_steps, part.reference.points.front().steps);
  for (const StudyPoint& point : part.student.points)
    EXPECT_EQ(point.end, point.steps < 100 ? StudyEnd::ran_away : StudyEnd::finished) << point.steps;
}

TEST(Study, ShowsNoNumberThatIsNone) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300})
    for (const bool of_velocities : {false, true}) {
      if (of_velocities && std::isfinite(bad)) continue;  // positions count, not velocities
      Fake student;
      student.poison = [&](Played& played, int) {
        (of_velocities ? played.frames.back().v : played.frames.back().x)[3] = bad;
      };
      const PartStudy part = study("symplectic Euler", student);
      for (const StudyPoint& point : part.student.points) {
        EXPECT_EQ(point.end, StudyEnd::ran_away);
        EXPECT_EQ(point.error, 0);
        EXPECT_TRUE(point.seconds.empty());
      }
      EXPECT_EQ(part.student.stable_steps, 0);
      EXPECT_FALSE(part.ratio);
    }
}

TEST(Study, RefusesARunThatIsShorterThanAskedFor) {
  Fake student;
  student.poison = [](Played& played, int) { played.frames.pop_back(); };
  const PartStudy part = study("symplectic Euler", student);
  EXPECT_TRUE(part.student.points.empty());
  EXPECT_TRUE(says(part.note, "a message that does not fit the request"));
  EXPECT_EQ(student.plays, 1);
}

TEST(Study, GoesOnWithoutAWorkerThatEnds) {
  Fake student;
  student.poison = [](Played&, int steps) {
    if (steps == 240) throw CaseFailed{Status::crashed, "the program ended in the middle of the call", ""};
  };
  const PartStudy part = study("symplectic Euler", student);
  ASSERT_FALSE(part.student.points.empty());
  EXPECT_EQ(part.student.points.back().steps, 240);
  EXPECT_EQ(part.student.points.back().end, StudyEnd::broke);
  EXPECT_TRUE(says(part.note, "the program ended"));
  EXPECT_GT(part.reference.points.size(), part.student.points.size());
  EXPECT_FALSE(part.ratio && part.ratio->median > 1.01);
  // The break there does not mean that the motion ran away before.
  EXPECT_TRUE(part.student.stable_everywhere);
  EXPECT_EQ(part.student.stable_steps, part.student.points.front().steps);
}

std::string page_of(const PartStudy& part) {
  SubmissionResult result;
  result.name = "somebody";
  const std::string page = study_page(result, {{{"pendulums", "Pendulums", "", {}, {part}}}});
  EXPECT_NO_THROW(hair::plot::parse(page));
  return page;
}

// Counts the runs of the student's code before it is measured.
int first_plays(const StudiedPart& part) {
  return 1 + static_cast<int>(grids_of(part.scene).size());
}

TEST(Study, ShowsNoTimesOfPlaysThatDontEndAsTheFirstDid) {
  const int first = first_plays(pendulum("symplectic Euler"));
  const std::vector<std::function<void(Played&)>> poisoned = {
      [](Played& played) {
        played.frames.resize(1);
        played.trouble = "enough";
      },
      [](Played& played) { played.frames.back().x[3] += 1e-6; },
      [](Played& played) { played.frames.back().x[3] = std::numeric_limits<double>::quiet_NaN(); }};
  for (const auto& poison : poisoned) {
    Fake student;
    student.poison = [&](Played& played, int) {
      if (student.plays <= first) return;
      student.seconds_per_step = 1e-9;
      poison(played);
    };
    const PartStudy part = study("symplectic Euler", student);
    EXPECT_EQ(static_cast<int>(part.student.points.size()), first - 1);
    for (const StudyPoint& point : part.student.points) {
      EXPECT_EQ(point.end, StudyEnd::broke) << point.steps;
      EXPECT_TRUE(says(point.note, "asked for again"));
      EXPECT_TRUE(point.seconds.empty());
    }
    EXPECT_FALSE(part.ratio);
  }
}

TEST(Study, SaysWhenCodeTakesFarLessTimeForWhatItWasAskedBefore) {
  const int first = first_plays(pendulum("midpoint"));
  Fake honest, remembers;
  remembers.poison = [&](Played&, int) {
    if (remembers.plays > first) remembers.seconds_per_step = 1e-7;
  };
  EXPECT_FALSE(says(page_of(study("midpoint", honest)), "it may remember"));
  EXPECT_TRUE(says(page_of(study("midpoint", remembers)), "it may remember"));

  // Both sides are slow in short runs at first, and the student's code finishes no others.
  PartStudy part = study("midpoint", honest);
  for (StudyCurve* curve : {&part.student, &part.reference})
    for (std::size_t i = 0; i < 2; ++i) curve->points[i].first_seconds *= 10;
  part.student.points.resize(2);
  EXPECT_FALSE(says(page_of(part), "it may remember"));
}

TEST(Study, TakesTimesOfWholeRoundsOrElseOfFirstPlays) {
  const StudiedPart part = pendulum("symplectic Euler");
  int first = part.scene.frames * part.scene.steps_per_frame;  // are the steps that are not measured
  for (const TimeGrid& grid : grids_of(part.scene)) first += grid.steps();
  // A round adds at most these steps to the first runs: each grid with less repeats up to 2 ms.
  const int round = first + 200 * static_cast<int>(grids_of(part.scene).size());
  for (const int rounds : {0, 1}) {
    Fake student;
    StudySettings settings;
    settings.most_seconds = 1e-5 * (first + rounds * round + 0.25 * first);
    const PartStudy found = study("symplectic Euler", student, settings);
    EXPECT_EQ(found.rounds, rounds);
    EXPECT_NE(found.note, "");
    for (const StudyCurve* curve : {&found.student, &found.reference})
      for (const StudyPoint& point : curve->points) {
        ASSERT_EQ(point.seconds.size(), 1U) << point.steps;
        EXPECT_NEAR(point.seconds.front(), 1e-5 * point.steps, 1e-12);
      }
    EXPECT_TRUE(says(page_of(found), rounds == 0 ? "Times are those of first runs" : "medians of 1 round "));
  }
}

TEST(UntilItGivesUp, EndsWhatDozes) {
  const StudiedPart part = pendulum("midpoint");
  Fake dozes;
  dozes.poison = [](Played&, int) { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  UntilItGivesUp runner(dozes, 0.01);
  const auto play = [&] { runner.play(on_grid(part, {part.scene.frames, 1}), part.scene, 1); };
  EXPECT_NO_THROW(play());
  for (int i = 0; i < 2; ++i) EXPECT_THROW(play(), CaseFailed);
  EXPECT_EQ(dozes.plays, 1);
}

TEST(UntilItGivesUp, EndsWhatCrashesAgainAndAgain) {
  const StudiedPart part = pendulum("midpoint");
  Fake crashes;
  crashes.poison = [](Played&, int) { throw CaseFailed{Status::crashed, "gone", ""}; };
  UntilItGivesUp runner(crashes, 100);
  for (int i = 0; i < 2 * UntilItGivesUp::kMostCrashes; ++i)
    EXPECT_THROW(runner.play(on_grid(part, {part.scene.frames, 1}), part.scene, 1), CaseFailed);
  EXPECT_EQ(crashes.plays, UntilItGivesUp::kMostCrashes);
}

TEST(StudiedScenes, EachEndsSoundAndTogetherTheyNeedAllExercisesThatScenesCall) {
  std::set<std::string> all;
  for (const SceneText& text : studied_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    for (const std::string& id : exercises_of(scene)) all.insert(id);
    hair::SceneRun scene_run(scene);
    const particles::State start = scene_run.state();
    while (scene_run.frame() < scene.frames) ASSERT_FALSE(scene_run.advance()) << text.name;
    EXPECT_TRUE(scene_run.state().x.allFinite() && scene_run.state().v.allFinite()) << text.name;
    // Something must move by at least a tenth of a millimetre.
    EXPECT_GT((scene_run.state().x - start.x).norm(), 1e-4) << text.name;
  }
  EXPECT_EQ(all, (std::set<std::string>{"S1", "P1", "P2", "H1", "H2", "H3", "H4", "H5", "H6"}));
}

TEST(Parts, PlayTheSameMotionInOtherSteps) {
  for (const SceneText& text : studied_scenes())
    for (const StudiedPart& part : parts_of(text)) {
      const std::vector<TimeGrid> all = grids_of(part.scene);
      EXPECT_GE(all.size(), 6U) << part.name;
      bool own = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const SceneText other = on_grid(part, all[i]);
        const hair::Scene scene = hair::parse_scene(other.json, other.name);
        EXPECT_NEAR(scene.frames / scene.frames_per_second, part.scene.frames / part.scene.frames_per_second,
                    1e-15);
        EXPECT_EQ(scene.frames * scene.steps_per_frame, all[i].steps());
        EXPECT_EQ(part.scene.frames % scene.frames, 0) << part.name;
        EXPECT_TRUE(i == 0 || all[i].steps() == 2 * all[i - 1].steps()) << part.name;
        own = own || all[i].steps() == part.scene.frames * part.scene.steps_per_frame;
      }
      EXPECT_TRUE(own) << part.name;
    }
}

}  // namespace
}  // namespace grader::judge
