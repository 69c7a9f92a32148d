#include "hair/live/runner.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "hair/io/files/bad_input.h"
#include "hair/io/files/json_text.h"
#include "hair/io/files/kept_file.h"
#include "hair/io/files/printable.h"
#include "hair/lab/commands/exit_codes.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/stub.h"
#include "hair/live/commands_in.h"
#include "hair/live/hand.h"
#include "hair/live/live_settings.h"
#include "hair/live/whereabouts.h"
#include "hair/scene/scene_run.h"
#include "hair/scene_drawing/scene_drawing.h"
#include "solver/not_in_course.h"

namespace hair {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostLivePoints = 60'000;
constexpr int kCells = 30;  // fewer than in other pages: without a graphics card a triangle takes some 3 us
constexpr auto kSignOfLife = std::chrono::milliseconds(500);

class Lines {
 public:
  explicit Lines(int descriptor) : descriptor_(descriptor) {}

  void write(std::string line) {
    line += '\n';
    for (std::size_t at = 0; at < line.size();) {
      const ssize_t size = ::write(descriptor_, line.data() + at, line.size() - at);
      if (size <= 0) std::_Exit(0);  // nobody reads
      at += static_cast<std::size_t>(size);
    }
    last_ = Clock::now();
  }

  void trouble(const std::string& text) {
    write(json_object({{"kind", json_text("trouble")}, {"text", json_text(printable(text, 400))}}));
  }

  void heartbeat(long steps) {
    if (Clock::now() - last_ > kSignOfLife) write(". " + std::to_string(steps));
  }

 private:
  int descriptor_;
  Clock::time_point last_ = Clock::now();
};

std::vector<MotionSeries> series_of(const FrameMeasures& measures, const Work& since) {
  return {{"energy", "J", {measures.energy()}},
          {"kinetic energy", "J", {measures.kinetic}},
          {"largest stretch", "%", {100 * measures.stretch}},
          {"solver steps", "", {static_cast<double>(since.solver_steps)}}};
}

// Returns the mean of all roots; the origin without any.
Vector3d middle_of_roots(const SceneRun& run) {
  const particles::State lines = run.centre_lines(run.state());
  Vector3d sum = Vector3d::Zero();
  Eigen::Index at = 0;
  for (const int points : run.strands()) {
    sum += lines.x.segment<3>(at);
    at += 3 * points;
  }
  return sum / std::max<double>(1, static_cast<double>(run.strands().size()));
}

class Runner {
 public:
  Runner(Scene scene, const Scene& as_it_is, const Course& course, Lines& lines)
      : scene_(std::move(scene)),
        frame_seconds_(1 / as_it_is.frames_per_second),
        whole_(as_it_is.frames * frame_seconds_),
        scene_run_(scene_),
        drawing_(scene_, scene_run_.strands(), cache_folder(), kCells),
        hand_(middle_of_roots(scene_run_)),
        motion_(1, kMostLivePoints),
        lines_(lines) {
    add_drawing();
    MotionStory story;
    story.name = scene_.name;
    story.shows = scene_.shows;
    story.camera = drawing_.camera();
    const Look look = scene_.look.value_or(Look());
    story.aspect = static_cast<double>(look.image_width) / look.image_height;
    story.times = {0.0};
    story.series = series_of(scene_run_.measure(scene_run_.state()), {});
    std::string methods;
    for (const MethodRow* row : methods_for(as_it_is, course))
      methods += (methods.empty() ? "" : ",") +
                 json_object({{"id", json_text(row->id)}, {"name", json_text(row->name)}});
    const MethodRow* method = method_of(scene_);
    lines_.write(json_object({{"kind", json_text("start")},
                              {"motion", one_line(motion_.json(story))},
                              {"step", json_text(scene_.hair.step)},
                              {"whole", json_text(whole_)},
                              {"has_roots", has_strands(scene_) ? "true" : "false"},
                              {"method", json_text(method ? method->id : "")},
                              {"methods", "[" + methods + "]"}}));
    say_frame();
    say_state();
  }

  void play(CommandsIn& commands) {
    start_again();
    while (commands.open()) {
      const auto now = Clock::now();
      const bool waits = over_ || !going_;
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(due_ - now).count();
      if (const auto line = commands.next(waits ? 400 : static_cast<int>(std::clamp<long>(left, 0, 400)))) {
        obey(*line);
        continue;
      }
      lines_.heartbeat(scene_run_.steps());
      if (over_ || !going_ || Clock::now() < due_) continue;
      const long frame = static_cast<long>((scene_run_.time() + scene_.hair.step / 2) / frame_seconds_) + 1;
      const double before = scene_run_.time();
      while (!over_ && scene_run_.time() + scene_.hair.step / 2 < static_cast<double>(frame) * frame_seconds_)
        step();
      if (!blown_up()) say_frame();
      if (over_) say_state();
      // A step may be longer than a frame.
      due_ += std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double>((scene_run_.time() - before) / rate_));
      if (due_ + std::chrono::milliseconds(200) < Clock::now()) start_again();  // it is slow
    }
  }

 private:
  static std::string one_line(std::string json) {
    std::erase(json, '\n');
    return json;
  }

  bool blown_up() const { return !trouble_.empty(); }
  void start_again() { due_ = Clock::now(); }

  void step() {
    if (hand_.leads()) {
      const Way hand = hand_.after(scene_.hair.step);
      scene_run_.lead(hand);
      drawing_.lead(hand);
    }
    if (const auto trouble = scene_run_.advance()) trouble_ = *trouble;
    over_ = blown_up() || (!hand_.leads() && scene_run_.time() + scene_.hair.step / 2 > whole_);
    lines_.heartbeat(scene_run_.steps());
  }

  void obey(const std::string& line) {
    if (line == "go" || line == "pause") {
      going_ = line == "go";
      start_again();
    } else if (line.starts_with("rate ")) {
      rate_ = std::clamp(std::atof(line.c_str() + 5), 0.01, 100.0);
    } else if (line.starts_with("hand ")) {
      std::istringstream in(line.substr(5));
      Vector3d offset = Vector3d::Zero();
      double turn = 0;
      if (in >> offset.x() >> offset.y() >> offset.z() >> turn) hand_.go_to(offset, turn);
      if (!over_ || blown_up()) return;
      over_ = false;  // it goes on beyond its end
      start_again();
    } else if (line == "step" && !over_) {
      going_ = false;
      step();
      if (!blown_up()) say_frame();
    }
    say_state();
  }

  void add_drawing() {
    const particles::State lines = scene_run_.centre_lines(scene_run_.state());
    motion_.add(drawing_.at(lines, scene_run_.obstacles(), scene_run_.time(), scene_run_.mesh_record()));
    motion_.keep_last();
  }

  void say_frame() {
    if (scene_run_.steps() > 0) add_drawing();
    Work since = scene_run_.work();
    const long solver_steps = since.solver_steps;
    since.solver_steps -= solver_steps_;
    solver_steps_ = solver_steps;
    std::string values;
    for (const MotionSeries& one : series_of(scene_run_.measure(scene_run_.state()), since))
      values += (values.empty() ? "" : ",") + json_text(one.values.front());
    lines_.write(json_object({{"kind", json_text("frame")},
                              {"time", json_text(scene_run_.time())},
                              {"steps", json_text(scene_run_.steps())},
                              {"values", "[" + values + "]"},
                              {"last", motion_.last_json()}}));
  }

  void say_state() {
    const std::string blow_up =
        blown_up() ? json_object({{"text", json_text(trouble_)}, {"strand", json_text(strand_of(trouble_))}})
                   : "null";
    lines_.write(json_object({{"kind", json_text("state")},
                              {"going", going_ && !over_ ? "true" : "false"},
                              {"ended", over_ ? json_text(blown_up() ? "blow_up" : "finished") : "null"},
                              {"steps", json_text(scene_run_.steps())},
                              {"blow_up", blow_up}}));
  }

  Scene scene_;
  double frame_seconds_, whole_;  // s, of the simulation
  SceneRun scene_run_;
  SceneDrawing drawing_;
  Hand hand_;
  MotionFrames motion_;
  Lines& lines_;
  double rate_ = 1;
  bool going_ = true, over_ = false;
  std::string trouble_;
  long solver_steps_ = 0;
  Clock::time_point due_;
};

int play(const std::string& name, const Course& course, CommandsIn& commands, Lines& lines) try {
  const auto settings = commands.next(-1);
  if (!settings) return 0;
  const Scene as_it_is = read_course_scene(name, course);
  Scene scene = as_it_is;
  change(scene, read_settings(*settings), course);
  Runner(std::move(scene), as_it_is, course, lines).play(commands);
  return 0;
} catch (const NotImplemented& stub) {
  lines.trouble("This needs " + missing_part(stub) + ".");
  return kNotWritten;
} catch (const NotInCourse& left_out) {
  lines.trouble(std::string(left_out.what()) + ".");
  return kBadInput;
} catch (const BadInput& error) {
  lines.trouble(std::string(error.what()) + ".");
  return kBadInput;
} catch (const std::exception& error) {
  lines.trouble("The code threw an exception: " + std::string(error.what()) + ".");
  return kBroke;
} catch (...) {
  lines.trouble("The code threw something that is no std::exception.");
  return kBroke;
}

}  // namespace

int play_for_page(const std::string& scene, const Course& course) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // an endless loop does not read that its input ended
#endif
  signal(SIGPIPE, SIG_IGN);
  signal(SIGINT, SIG_IGN);  // the terminal sends it to both; the server ends this process
  const int out = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  say_whereabouts(out);
  Lines lines(out);
  CommandsIn commands(STDIN_FILENO);
  return play(scene, course, commands, lines);
}

}  // namespace hair
