// hairlab from outside: its files, its messages, its exit codes.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hair/lab/test_read_states.h"
#include "hair/lab/test_run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const char* const kSwing = R"({"shows": "a hair swings down", "frames": 4, "frames_per_second": 60,
 "steps_per_frame": 4, "hair": [{"segments": 6, "length": 0.06, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}],
 "render": {"image_width": 64, "image_height": 48}})";

const char* const kPendulum = R"({"shows": "a pendulum", "frames": 60, "frames_per_second": 60,
 "steps_per_frame": 10, "toys": [{"particles": [{"position": [0, 0, 0], "mass": 1, "pinned": true},
 {"position": [1, 0, 0], "mass": 1}], "rods": [{"between": [0, 1]}],
 "feedback": {"stiffness": 100, "damping": 20}}]})";

// Stiff springs and a long step: an explicit method breaks.
const char* const kBlowUp = R"({"shows": "breaks", "frames": 400, "frames_per_second": 60,
 "steps_per_frame": 1, "method": "forward_euler", "hair": [{"segments": 4, "length": 0.04, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

// Too stiff for its steps: it stays level.
const char* const kWarns =
    R"({"shows": "warns", "frames": 10, "steps_per_frame": 1, "method": "implicit_euler",
 "hair": [{"segments": 30, "length": 0.3, "clamped": false, "material": {"stretch_factor": 1e6},
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

Json read_run(const fs::path& folder) {
  return Json::parse(bytes_of(folder / "run.json"));
}

class Hairlab : public testing::Test {
 protected:
  // Runs a scene into `out` of the test's folder.
  ProgramRun play(const char* scene, std::vector<std::string> options = {},
                  const ProgramSettings& settings = {}) const {
    const std::string file = folder_.write("scene.json", scene);
    options.insert(options.begin(), {"run", file, "--out", out_.string()});
    return run_hairlab(options, settings);
  }

  // Nothing stays hidden beside it, whatever happened.
  void TearDown() override {
    for (const std::string& name : folder_.names()) EXPECT_FALSE(name.starts_with(".hairlab")) << name;
  }

  TestFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(Hairlab, WritesStatesMeasuresAndNothingElseWithoutPictures) {
  const ProgramRun run = play(kSwing, {"--no-render"});
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  EXPECT_EQ(run.output, out_.string() + ": 5 frames, no pictures\n");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"out", "scene.json"}));
  EXPECT_EQ(folder_.names("out"),
            (std::vector<std::string>{"motion.json", "run.json", "states.bin", "states.csv"}));

  const StatesFile states = read_states(out_ / "states.bin");
  EXPECT_EQ(states.strands, std::vector<std::uint32_t>{7});
  EXPECT_EQ(states.particles, 7U);
  ASSERT_EQ(states.frames.size(), 5u);
  EXPECT_EQ(states.frames[4].time, 4.0 / 60);
  EXPECT_LT(states.frames[4].state.x[3 * 6 + 2], -0.01) << "the tip has not fallen";

  const Json record = read_run(out_);
  EXPECT_EQ(record["scene"], "scene");
  EXPECT_EQ(record["ended"], "finished");
  EXPECT_EQ(record["no_pictures"], "--no-render");
  EXPECT_EQ(record["frames_written"], 5);
  ASSERT_EQ(record["frames"].size(), 5u);
  long solver_steps = 0;
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(record["frames"][k]["time"], states.frames[k].time);
    solver_steps += record["frames"][k]["solver_steps"].get<long>();
  }
  EXPECT_EQ(record["work"]["solver_steps"], solver_steps);
  EXPECT_EQ(record["work"]["strand_steps"], 16);
  EXPECT_GT(record["seconds"]["simulate"], 0);
}

TEST_F(Hairlab, DoesTheSameTwice) {
  ASSERT_EQ(play(kSwing).code, 0);
  const std::vector<std::string> names = folder_.names("out");
  EXPECT_TRUE(std::ranges::find(names, "frame-0004.png") != names.end());
  fs::rename(out_, folder_ / "first");
  ASSERT_EQ(play(kSwing).code, 0);
  ASSERT_EQ(folder_.names("first"), names);
  for (const std::string& name : names) {
    if (name == "run.json") continue;
    EXPECT_EQ(bytes_of(folder_ / ("first/" + name)), bytes_of(out_ / name)) << name;
  }
  Json first = read_run(folder_ / "first"), second = read_run(out_);
  // Each moment belongs to one stage; the rest is rounding of a clock that counts from the machine's start.
  double sum = -first["seconds"]["total"].get<double>();
  for (const Json& stage : first["seconds"]) sum += stage.get<double>();
  EXPECT_NEAR(sum, first["seconds"]["total"], 1e-6) << first["seconds"];
  EXPECT_EQ(first.erase("seconds"), 1u);
  second.erase("seconds");
  EXPECT_EQ(first, second);
}

TEST_F(Hairlab, PlaysAsManyFramesAsAskedFor) {
  for (const int frames : {0, 1, 7}) {
    ASSERT_EQ(play(kSwing, {"--no-render", "--frames", std::to_string(frames)}).code, 0);
    EXPECT_EQ(read_states(out_ / "states.bin").frames.size(), frames + 1u);
    EXPECT_EQ(read_run(out_)["frames_asked"], frames + 1);
  }
}

// LD_DEBUG has the loader write each library's name.
TEST_F(Hairlab, LoadsOpenGlForPicturesAlone) {
  const ProgramSettings watched{.environment = {"LD_DEBUG=files"}};
  const auto loads = [](const ProgramRun& run) {
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(says(run.errors, "libc.so")) << "the loader says nothing";
    return says(run.errors, "OSMesa") || says(run.errors, "libEGL") || says(run.errors, "libGL");
  };
  EXPECT_TRUE(loads(play(kSwing, {}, watched)));
  EXPECT_FALSE(loads(play(kSwing, {"--no-render"}, watched)));
  EXPECT_FALSE(loads(play(kPendulum, {}, watched)));
  EXPECT_EQ(read_run(out_)["no_pictures"], "the scene has no \"render\"");
}

// Files that are no libraries are in the folder that the loader searches first.
TEST_F(Hairlab, WritesAllButPicturesWithoutOpenGl) {
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libEGL.so.1"}) folder_.write(name, "");
  const ProgramRun run = play(kSwing, {}, {.environment = {"LD_LIBRARY_PATH=" + folder_.path().string()}});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(says(run.errors, "no pictures: "));
  EXPECT_TRUE(says(run.errors, "libosmesa6"));
  EXPECT_EQ(lines_of(run.errors), 1) << run.errors;
  EXPECT_EQ(folder_.names("out"),
            (std::vector<std::string>{"motion.json", "run.json", "states.bin", "states.csv"}));
  EXPECT_TRUE(says(read_run(out_)["no_pictures"], "libosmesa6"));
}

TEST_F(Hairlab, KeepsWhatCameBeforeABlowUp) {
  const ProgramRun run = play(kBlowUp);
  EXPECT_EQ(run.code, 1);
  const Json record = read_run(out_);
  EXPECT_EQ(record["ended"], "blow-up");
  const std::string where = record["blow_up"];
  EXPECT_TRUE(where.starts_with("strand 0, step ")) << where;
  EXPECT_TRUE(where.ends_with(": integration")) << where;
  EXPECT_TRUE(run.errors.ends_with("hairlab: scene broke: " + where + "; what came before is kept\n"));
  const StatesFile states = read_states(out_ / "states.bin");
  EXPECT_GT(states.frames.size(), 1u);
  EXPECT_LT(states.frames.size(), 401u);
  EXPECT_EQ(record["frames"].size(), states.frames.size());
  for (const StateFrame& frame : states.frames) EXPECT_TRUE(frame.state.x.allFinite());
}

// Its numbers are finite and wrong: the warning is in the last line and in the record.
TEST_F(Hairlab, WarnsInItsLastLineAndInTheRecord) {
  const ProgramRun run = play(kWarns);
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(says(run.output, "; not compared with a finer step\n"));
  EXPECT_EQ(read_run(out_)["off_by"], nullptr);
  const Json warnings = read_run(out_)["warnings"];
  ASSERT_EQ(warnings.size(), 1U) << warnings;
  const Json& one = warnings[0];
  EXPECT_EQ(one["concern"], "stretching");
  EXPECT_EQ(one["strand"], 0);
  EXPECT_EQ(one["strands"], 1);
  EXPECT_GE(one["step"], 1);
  EXPECT_LE(one["step"], 10);
  EXPECT_GT(one["size"], one["bound"]);
  EXPECT_EQ(lines_of(run.errors), 1) << run.errors;
  EXPECT_TRUE(run.errors.starts_with("hairlab: scene: warning: strand 0 is held by stretched springs"))
      << run.errors;
  EXPECT_TRUE(says(run.errors, "from step " + one["step"].dump() + " on"));
  EXPECT_EQ(play(kWarns, {"--strict"}).code, 1);
  EXPECT_EQ(play(kSwing, {"--strict", "--no-render"}).code, 0);
}

TEST_F(Hairlab, KeepsWhatIsFinishedWhenItIsInterrupted) {
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    // Its hidden folder exists as soon as it runs.
    const fs::path playing = folder_ / (".hairlab-out-" + std::to_string(process));
    EXPECT_TRUE(wait_until([&] { return fs::exists(playing / "frame-0003.png"); }, process));
    EXPECT_FALSE(fs::exists(out_));
    kill(process, SIGINT);
  };
  const ProgramRun run = play(kSwing, {"--frames", "100000"}, settings);
  EXPECT_EQ(run.code, 130);
  EXPECT_TRUE(says(run.errors, "interrupted after "));
  const Json record = read_run(out_);
  EXPECT_EQ(record["ended"], "interrupted");
  const std::size_t frames = record["frames"].size();
  EXPECT_GE(frames, 4u);
  EXPECT_EQ(read_states(out_ / "states.bin").frames.size(), frames);
  std::size_t pictures = 0;
  for (const std::string& name : folder_.names("out")) pictures += name.starts_with("frame-");
  EXPECT_EQ(pictures, frames);
}

TEST_F(Hairlab, NamesTheExerciseThatAStubIsOf) {
  const ProgramSettings student{.program = STUDENT_HAIRLAB};
  expect_refused(
      play(kSwing, {}, student), 3,
      "scene needs H1: student/stretch_springs.cpp, stretch_energy is not implemented yet; nor are S1 "
      "(student/conj_grad.cpp), H2 (student/angular_springs.cpp), H4 (student/implicit_euler.cpp), H5 "
      "(student/length_correction.cpp), H6 (student/predictor_corrector.cpp)\n");
  expect_refused(play(kPendulum, {}, student), 3, "scene needs P1: student/explicit_integrators.cpp, ");
  EXPECT_FALSE(fs::exists(out_));

  ASSERT_EQ(play(kSwing, {"--no-render"}).code, 0);
  const std::string before = bytes_of(out_ / "run.json");
  EXPECT_EQ(play(kSwing, {}, student).code, 3);
  EXPECT_EQ(bytes_of(out_ / "run.json"), before) << "an earlier run is lost";
}

// The message comes before anything is written, and names all stubs.
TEST_F(Hairlab, SaysWhichExercisesAreStubs) {
  const ProgramSettings student{.program = STUDENT_HAIRLAB};
  const std::string scene = folder_.write("scene.json", kPendulum);
  const ProgramRun alone = run_hairlab({}, student);
  EXPECT_EQ(alone.code, 0);
  EXPECT_EQ(alone.errors, "");
  EXPECT_TRUE(says(alone.output, "Not written yet: S1 (student/conj_grad.cpp), S2 ("));
  EXPECT_TRUE(says(alone.output, "Scenes that play without them: none\n"));
  EXPECT_EQ(run_hairlab({}).output, "");
  const std::string parts = run_hairlab({"run", scene, "--explain"}, student).output;
  EXPECT_TRUE(
      says(parts, "\n  exercise P1        stub      student/explicit_integrators.cpp, not written yet\n"));
  EXPECT_TRUE(says(parts, "\n  exercise H1        left out  "));
  EXPECT_FALSE(says(run_hairlab({"run", scene, "--explain"}).output, "stub"));
  EXPECT_TRUE(says(run_hairlab({"scenes"}, student).output, "(P1; stubs: P1)\n"));
  EXPECT_FALSE(says(run_hairlab({"scenes"}).output, "stubs"));
}

// The reference's run replaces one that stubs can't run, and appears next to one that runs.
TEST_F(Hairlab, ViewsTheReferencesRunOfAScene) {
  const ProgramSettings student{.program = STUDENT_HAIRLAB};
  const fs::path page = folder_.path() / "page.html";
  ProgramRun run = run_hairlab({"view", "pendulum", "--out", page.string()}, student);
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(says(run.errors, "hairlab: pendulum needs P1: student/explicit_integrators.cpp, "));
  EXPECT_TRUE(says(run.errors, "; the page shows the reference's run\n"));
  EXPECT_TRUE(says(bytes_of(page), "data-name=\"pendulum by the reference\""));

  run = run_hairlab({"view", "pendulum", "--with", "reference", "--out", page.string()});
  EXPECT_EQ(run.code, 0) << run.errors;
  for (const char* name : {"data-name=\"pendulum\"", "data-name=\"pendulum by the reference\""})
    EXPECT_TRUE(says(bytes_of(page), name));
  const std::string own = folder_.write("own.json", kPendulum);
  expect_refused(run_hairlab({"view", own, "--out", page.string()}, student), 3, "own needs P1: ");
  expect_refused(run_hairlab({"view", own, "--with", "reference"}), 2,
                 "own: the reference's run does not come along");
  const std::string changed = folder_.write("pendulum.json", kPendulum);
  expect_refused(run_hairlab({"view", changed, "--with", "reference"}), 2,
                 "is another scene than the one that ships under this name");
}

TEST_F(Hairlab, ViewsASceneThoughAFolderHasItsName) {
  fs::create_directory(folder_ / "pendulum");
  const auto view = [&] {
    return run_hairlab({"-c", "cd '" + folder_.path().string() + "' && exec '" HAIRLAB "' view pendulum"},
                       {.program = "/bin/sh"});
  };
  EXPECT_EQ(view().output, "pendulum.html: open it in a browser\n");
  folder_.write("pendulum/motion.json", "no motion");
  EXPECT_EQ(view().code, 2) << "a run, then";
}

// The last picture is compared with the same frame of a run that ends there.
TEST_F(Hairlab, TheLastPictureOfARunThatBrokeShowsTheStrand) {
  Json scene = Json::parse(kBlowUp);
  scene["render"] = {{"image_width", 64}, {"image_height", 48}};
  ASSERT_EQ(play(scene.dump().c_str()).code, 1);
  const std::size_t last = read_run(out_)["frames"].size() - 1;
  char name[32];
  std::snprintf(name, sizeof name, "frame-%04zu.png", last);
  const std::string broken = bytes_of(out_ / name);
  ASSERT_EQ(play(scene.dump().c_str(), {"--frames", std::to_string(last)}).code, 0);
  EXPECT_NE(bytes_of(out_ / name), broken);
}

TEST_F(Hairlab, RefusesWrongUsageAndBadScenes) {
  const std::string scene = folder_.write("good.json", kSwing), out = out_.string();
  std::string negative = kPendulum;
  negative.replace(negative.find("\"mass\": 1}]"), 9, "\"mass\": -1");
  expect_refused(play(negative.c_str()), 2, "scene.json: toys[0].particles[1].mass: ");
  const struct {
    std::vector<std::string> words;
    std::string says;
  } refused[] = {{{}, ""},
                 {{"play"}, ""},
                 {{"run"}, "SCENE"},
                 {{"run", scene}, "--out"},
                 {{"run", scene, "--out", out, "--frames", "-1"}, "--frames"},
                 {{"run", scene, "--out", out, "--frames", "1000001"}, "--frames"},
                 {{"run", scene, "--out", out, "--fast"}, "--fast"},
                 {{"run", "no-such-scene", "--out", out}, "no-such-scene: there is no such file"},
                 {{"run", folder_.path().string(), "--out", out}, "is a folder"},
                 {{"run", scene, "--out", folder_.path().string()}, "is not empty, and not from hairlab"}};
  for (const auto& [words, says] : refused) expect_refused(run_hairlab(words), 2, says);
  EXPECT_FALSE(fs::exists(out_));
}

// A limit on the size of files acts like a full disk, which affects the table of states first.
TEST_F(Hairlab, WritesNothingOnAFullDisk) {
  for (const int limit : {0, 1, 8}) {
    const ProgramRun run = play(kSwing, {"--no-render", "--frames", "40"}, {.file_limit = limit});
    // With a limit of 0 its messages can't be written, either.
    if (limit == 0)
      EXPECT_EQ(run.code, 2);
    else
      expect_refused(run, 2, "can't be written (File too large)");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
  }
  const ProgramRun run = play(kSwing, {}, {.file_limit = 2});
  expect_refused(run, 2, out_.string() + "/");
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
}

TEST_F(Hairlab, ResultsThatAreLostAreNotASuccess) {
  const std::string scene = folder_.write("scene.json", kSwing);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"run", scene, "--explain"},
           {"scenes"},
           {"--help"},
           {"run", scene, "--no-render", "--frames", "1", "--out", out_.string()}})
    expect_refused(
        run_hairlab(arguments, {.output = "/dev/full"}), 2,
        "hairlab: the standard output can't be written (No space left on device), so that results are lost");
}

TEST_F(Hairlab, ExplainsWithoutRunning) {
  const std::string scene = folder_.write("scene.json", kSwing);
  const ProgramRun run = run_hairlab({"run", scene, "--explain"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.errors, "");
  EXPECT_TRUE(run.output.starts_with("scene: a hair swings down\n")) << run.output;
  EXPECT_TRUE(says(run.output, "\n  bending            used      H2, "));
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"scene.json"});
  const ProgramRun both = play(kSwing, {"--explain", "--no-render"});
  EXPECT_TRUE(says(both.output, "\n  OpenGL             left out  --no-render: no library is loaded\n"));
  EXPECT_TRUE(fs::exists(out_ / "run.json"));
}

TEST_F(Hairlab, ListsTheScenesThatComeAlong) {
  const ProgramRun run = run_hairlab({"scenes"});
  EXPECT_EQ(run.code, 0) << run.errors;
  std::ptrdiff_t scenes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(HAIR_SCENES_DIR))
    if (entry.path().extension() == ".json") {
      ++scenes;
      EXPECT_TRUE(says("\n" + run.output, "\n" + entry.path().stem().string() + ": ")) << run.output;
    }
  EXPECT_GT(scenes, 0);
  EXPECT_EQ(lines_of(run.output), scenes);
  const ProgramRun missing = run_hairlab({"run", "strand-swnig", "--explain"});
  EXPECT_TRUE(says(missing.errors, "strand-swing, "));
  EXPECT_EQ(run_hairlab({"run", "strand-swing", "--explain"}).code, 0);
  const ProgramRun keys = run_hairlab({"scenes", "--keys"});
  EXPECT_EQ(keys.code, 0) << keys.errors;
  EXPECT_TRUE(says(keys.output, "\n## `hair[].roots.line`\n"));
}

}  // namespace
}  // namespace hair
