// STAFF ONLY. Runs the hidden scene and compares the submission's run with the reference's.
#include "grader/judge/run/whole_run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grader/compare/compare.h"
#include "grader/course/input.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/run/played.h"
#include "solver/timing.h"

namespace grader::inline judge {
namespace {

std::string at(const Moment& moment) {
  std::ostringstream text;
  text << "at " << moment.time << " s: energy " << moment.theirs.energy() << " J, ours "
       << moment.ours.energy() << " J; stretch " << moment.theirs.stretch << ", ours " << moment.ours.stretch
       << "; particles apart by " << moment.apart << " m, held ones by " << moment.held_apart
       << " m, dense hair by " << moment.dense_apart << " m";
  return text.str();
}

// Says "It breaks off after 0.35 s (strand 0, step 42: filter)." The last moment is a frame's.
std::string where_it_breaks_off(const RunComparison& run, const std::string& trouble) {
  if (run.moments.empty()) return "";
  std::ostringstream text;
  text.precision(3);
  text << "It breaks off after " << run.moments.back().time << " s"
       << (trouble.empty() ? "" : " (" + trouble + ")") << ".";
  return text.str();
}

}  // namespace

WholeRun::WholeRun(WorkerSetup worker, std::filesystem::path runner, HiddenScene scene,
                   std::optional<std::filesystem::path> kept_pictures, Student& cases)
    : student_(std::move(worker)),
      runner_(std::move(runner)),
      hidden_(std::move(scene)),
      kept_pictures_(std::move(kept_pictures)),
      cases_(cases) {}

Category WholeRun::category(const std::string& exercise) {
  return category_of(exercise, "WholeRun", [this](Trial& trial) { judge(trial); });
}

Played WholeRun::play(Trial& trial) {
  const double before = student_.spent().messages;
  try {
    return play_with_student(trial, runner_, hidden_.scene);
  } catch (CaseFailed& failure) {
    if (failure.status == Status::timed_out && student_.spent().messages - before > kManyMessages)
      failure = {Status::wrong, "the run takes many times the calls and products of ours", failure.detail};
    throw;
  }
}

Played WholeRun::play_unless_given_up(Trial& trial) {
  // Its cost is charged before another worker uses the same allowance.
  cases_.finish();
  // Code that never answers would use up its limits once more.
  if (cases_.gave_up()) trial.reply_of(*cases_.gave_up());
  return play(trial);
}

// A person wants to see a wrong run, too: it is drawn before it is judged.
void WholeRun::judge(Trial& trial) {
  trial.describe(hidden_.scene.name);
  const Played theirs = play_unless_given_up(trial);
  const RunComparison run = compare_runs(hidden_.scene, hidden_.pictures, theirs);
  if (kept_pictures_) draw(run);
  judge_run(trial, run, theirs.trouble);
  if (kept_pictures_) judge_pictures(trial);
}

void WholeRun::draw(const RunComparison& run) {
  const double start = timing::process_cpu_seconds();
  pictures_ = draw_shots(run.shots, run.camera, *kept_pictures_);
  motions_ = {run.their_motion, run.our_motion, run.film.empty() ? "" : draw_film(run.film, run.camera)};
  picture_seconds_ = timing::process_cpu_seconds() - start;
}

void WholeRun::judge_run(Trial& trial, const RunComparison& run, const std::string& trouble) const {
  if (!run.finite)
    trial.fail(Status::wrong, "numbers that are not finite", "", where_it_breaks_off(run, "not a number"),
               kNoNumber);
  trial.require(trouble.empty() && run.moments.size() == hidden_.scene.frames + std::size_t{1},
                "the run breaks off", trouble, where_it_breaks_off(run, trouble));
  trial.expect(run.moments.front().apart == 0, "the run does not start where the scene does");
  for (const Moment& moment : run.moments) {
    trial.expect_at_most(moment.held_apart, kHeld * run.size,
                         "the distance of held particles from their places", at(moment));
    trial.expect_at_most(std::abs(moment.theirs.energy() - moment.ours.energy()), kEnergy * run.kinetic,
                         "the difference of the energy from ours", at(moment));
    trial.expect_at_most(moment.theirs.stretch, std::max(kStretch * moment.ours.stretch, kLeastStretch),
                         "the stretch", at(moment));
    trial.expect_at_most(moment.dense_apart, kDense * run.size, "the distance of dense hair from ours",
                         at(moment));
  }
}

void WholeRun::judge_pictures(Trial& trial) const {
  for (const PictureResult& picture : pictures_) {
    std::ostringstream scores;
    scores << "at " << picture.name << ": blurred RMSE " << picture.blurred_rmse << ", FLIP " << picture.flip;
    trial.expect_at_most(picture.blurred_rmse, kBlurredRmse,
                         "the difference of the blurred pictures at " + picture.name, scores.str());
    trial.expect_at_most(picture.flip, kFlip, "the visible difference of the pictures at " + picture.name,
                         scores.str());
  }
  trial.expect(pictures_.size() == hidden_.pictures.size() && !pictures_.back().breaks_off,
               "the run ends before its last picture");
}

HiddenScene read_hidden_scene(const std::filesystem::path& file, const std::string& seed) {
  const nlohmann::json document = read_json(file);
  const JsonValue value(document, file);
  value.check_keys({"canary", "scene", "vary", "pictures"});

  nlohmann::json scene = document["scene"];
  const JsonValue vary = value["vary"];
  for (const std::string& place : vary.keys()) {
    const double most = vary[place].number(0, 1e3), part = Random(seed, place).uniform(-1, 1);
    try {
      nlohmann::json& number = scene.at(nlohmann::json::json_pointer(place));
      number = number.get<double>() + most * part;
    } catch (const nlohmann::json::exception&) {
      vary[place].fail("the scene has no number there; expected a JSON pointer to one");
    }
  }

  HiddenScene hidden{scene.dump(), {}, {}};
  hidden.scene = hair::parse_scene(hidden.text, file.string());
  for (const JsonValue& frame : value["pictures"].items())
    hidden.pictures.push_back(static_cast<int>(frame.number(0, hidden.scene.frames)));
  return hidden;
}

}  // namespace grader::judge
