#include "hair/lab/run/run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/kept_file.h"
#include "hair/io/image/png.h"
#include "hair/lab/run/film.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/run/states_file.h"
#include "hair/render/camera.h"
#include "hair/render/drawing.h"
#include "hair/render/opengl/renderer.h"
#include "hair/render/view.h"
#include "hair/scene/scene_run.h"
#include "hair/scene_drawing/idle_guides.h"
#include "hair/scene_drawing/scene_drawing.h"
#include "hair/strand/energy_watch.h"
#include "solver/timing.h"

namespace hair {

namespace {

const Colour kRed(0.8f, 0.02f, 0.02f);               // linear
constexpr double kBorder = 0.95, kThickness = 5e-3;  // times half a picture, and the target's distance

// Makes a strand red, thick and visible: moves points outside of the view to its border. `strand`: its index
// in the drawing; dense hair has no such index.
void mark_broken(Drawing& drawing, int strand, const Camera& camera, double aspect) {
  const StrandsDrawing& hair = drawing.strands;
  if (strand < 0 || static_cast<std::size_t>(strand) >= hair.sizes.size()) return;
  const Vector3d back = camera.eye - camera.target;
  const double far = back.norm(), y = kBorder * std::tan(camera.field_of_view / 2), x = aspect * y;
  const Eigen::Matrix3d axes = view_axes(back / far, camera.up);
  const auto shown = [&](const Vector3d& point) -> Vector3d {
    Vector3d seen = axes * (point - camera.eye);
    seen.z() = std::clamp(seen.z(), -2 * far, -far / 2);
    seen.x() = std::clamp(seen.x(), seen.z() * x, -seen.z() * x);
    seen.y() = std::clamp(seen.y(), seen.z() * y, -seen.z() * y);
    return camera.eye + axes.transpose() * seen;
  };
  std::size_t first = 0;
  for (int s = 0; s < strand; ++s) first += static_cast<std::size_t>(hair.sizes[static_cast<std::size_t>(s)]);
  const auto count = static_cast<std::size_t>(hair.sizes[static_cast<std::size_t>(strand)]);
  for (std::size_t i = first; i + 1 < first + count; ++i)
    if (hair.points[i].allFinite() && hair.points[i + 1].allFinite())
      drawing.tubes.push_back({shown(hair.points[i]), shown(hair.points[i + 1]), kThickness * far / 2, kRed});
}

std::unique_ptr<SceneRun> assemble(const Scene& scene) {
  try {
    return std::make_unique<SceneRun>(scene);
  } catch (const std::invalid_argument& error) {
    throw BadInput(scene.name + ": " + error.what());
  }
}

// A renderer if pictures are asked for and this machine can draw; else the record gets the reason. It loads
// the OpenGL libraries, so runs without pictures don't.
std::unique_ptr<Renderer> prepare_renderer(const Scene& scene, const RunSettings& settings,
                                           const SceneDrawing& drawing, RunRecord& record,
                                           std::ostream& notes) {
  if (!scene.look) {
    record.no_pictures = "the scene has no \"render\"";
  } else if (!settings.render) {
    record.no_pictures = "--no-render";
  } else {
    try {
      auto renderer = std::make_unique<Renderer>(drawing.settings());
      record.opengl = renderer->about();
      return renderer;
    } catch (const NoOpenGl& error) {
      record.no_pictures = error.what();
      notes << "no pictures: " << error.what() << "\n";
    }
  }
  record.no_film = "there are no pictures";
  return {};
}

// The scene without dense hair, so that its drawing does not call H10.
Scene without_dense_hair(Scene scene) {
  scene.dense.clear();
  scene.still.clear();
  return scene;
}

// The kind of coordinates of all strands.
std::uint32_t kind_of(const std::vector<std::uint32_t>& coordinates) {
  const auto other =
      std::ranges::find_if(coordinates, [&](auto kind) { return kind != coordinates.front(); });
  return other == coordinates.end() ? coordinates.front() : kOfSeveralModels;
}

// Writes the frames of a run.
class FrameWriter {
 public:
  FrameWriter(const Scene& scene, const OutputFolder& folder, const SceneRun& scene_run,
              const SceneDrawing& drawing, Renderer* renderer, std::size_t most_points, RunRecord& record,
              timing::Laps& laps)
      : scene_(scene),
        folder_(folder),
        scene_run_(scene_run),
        drawing_(drawing),
        renderer_(renderer),
        record_(record),
        laps_(laps),
        dense_(!scene.dense.empty()),
        binary_(folder.now("states.bin"), folder.then("states.bin"), scene_run.sizes(),
                static_cast<int>(scene_run.state().x.size() / 3), kind_of(scene_run.coordinates())),
        csv_(folder.now("states.csv"), folder.then("states.csv"), record.strands),
        motion_(record.frames_asked + 1, most_points) {}

  // Adds the present frame.
  void add() {
    Seconds& seconds = record_.seconds;
    const particles::State state = scene_run_.state(), lines = scene_run_.centre_lines(state);
    const int frame = static_cast<int>(record_.frames.size());
    record_.frames.push_back({scene_run_.time(), scene_run_.measure(state), scene_run_.work()});
    laps_.book(seconds.measure);
    binary_.add(scene_run_.time(), state);
    csv_.add(scene_run_.time(), lines);
    laps_.book(seconds.write);
    last_ = drawing_.at(lines, scene_run_.obstacles(), scene_run_.time(), scene_run_.mesh_record());
    motion_.add(last_);
    laps_.book(seconds.lay_out);
    if (!renderer_) return;
    const Image image = renderer_->draw(last_, drawing_.camera());
    laps_.book(seconds.draw);
    if (dense_) record_.dense = drawing_.synthesised();
    record_.moved_out = drawing_.moved_out();
    write_whole(folder_, frame_name(frame), encode_png(image));
    laps_.book(seconds.png);
  }

  // Draws the last picture again, with the strand that broke after it in red.
  void show_broken(int strand) {
    if (!renderer_ || !scene_.dense.empty()) return;
    const RenderSettings settings = drawing_.settings();
    mark_broken(last_, strand, drawing_.camera(), static_cast<double>(settings.width) / settings.height);
    write_whole(folder_, frame_name(static_cast<int>(record_.frames.size()) - 1),
                encode_png(renderer_->draw(last_, drawing_.camera())));
  }

  // The simulated strands that the page does not show.
  std::vector<int> unseen() const {
    std::vector<int> unseen = motion_.unseen();
    std::erase_if(unseen, [&](int strand) { return strand >= static_cast<int>(record_.strands.size()); });
    return unseen;
  }

  std::pair<std::size_t, std::size_t> shown_of_all() const {
    const std::size_t all = motion_.strands_in_all();
    return {all - motion_.unseen().size(), all};
  }

  void close(bool measured) {
    if (record_.links) binary_.add(*record_.links);
    binary_.close();
    csv_.close();
    write_whole(folder_, kMotionFile, motion_json(scene_, record_, drawing_.camera(), motion_, measured));
    laps_.book(record_.seconds.write);
  }

 private:
  const Scene& scene_;
  const OutputFolder& folder_;
  const SceneRun& scene_run_;
  const SceneDrawing& drawing_;
  Renderer* renderer_;
  RunRecord& record_;
  timing::Laps& laps_;
  bool dense_;
  StatesWriter binary_;
  CsvWriter csv_;
  MotionFrames motion_;
  Drawing last_;
};

void play(SceneRun& scene_run, FrameWriter& frames, RunRecord& record, timing::Laps& laps,
          const std::atomic<bool>& interrupted, std::ostream* progress) {
  for (int k = 1; k <= record.frames_asked; ++k) {
    if (interrupted) {
      record.ending = Ending::interrupted;
      return;
    }
    if (progress) *progress << "\rframe " << k << " of " << record.frames_asked << std::flush;
    const std::optional<std::string> trouble = scene_run.advance();
    laps.book(record.seconds.simulate);
    if (trouble) {
      record.ending = Ending::blow_up;
      record.blow_up = *trouble;
      return;
    }
    frames.add();
  }
}

}  // namespace

RunResult run_scene(const Scene& scene, const RunSettings& settings, const std::atomic<bool>& interrupted,
                    std::ostream& notes, std::ostream* progress) {
  timing::Laps laps;
  OutputFolder folder(settings.out);
  RunRecord record;
  record.frames_asked = settings.frames.value_or(scene.frames);
  Seconds& seconds = record.seconds;
  seconds.read = settings.read_seconds;

  const std::unique_ptr<SceneRun> scene_run = assemble(scene);
  record.strands = scene_run->strands();
  record.particles = static_cast<int>(scene_run->centre_lines(scene_run->state()).x.size() / 3);
  laps.book(seconds.assemble);
  const bool pictures = settings.render && scene.look, draws = settings.for_page || pictures;
  const Scene bare = draws ? Scene() : without_dense_hair(scene);
  const SceneDrawing drawing(draws ? scene : bare, record.strands, cache_folder(),
                             pictures ? kCellsOfPicture : kCellsOfPage);
  const std::unique_ptr<Renderer> renderer = prepare_renderer(scene, settings, drawing, record, notes);
  if ((renderer || settings.for_page) && !scene.dense.empty()) {
    const std::vector<int> idle = idle_guides(scene, drawing);
    record.guides_left_out = idle.size();
    scene_run->leave_out(idle);
  }
  FrameWriter frames(scene, folder, *scene_run, drawing, renderer.get(), settings.most_points, record, laps);
  laps.book(seconds.prepare);
  frames.add();
  std::vector<int> unseen;
  if (settings.for_page && scene.dense.empty() && !scene.hair.mesh) unseen = frames.unseen();
  scene_run->leave_out(unseen);
  if (const auto [shown, all] = frames.shown_of_all(); shown < all)
    notes << scene.name << ": the page shows " << shown << " of " << all << " strands"
          << (unseen.empty() ? "" : ", and only these are computed") << std::endl;
  play(*scene_run, frames, record, laps, interrupted, progress);
  if (record.ending == Ending::blow_up) frames.show_broken(strand_of(record.blow_up));
  if (const MeshRecord* mesh = scene_run->mesh_record()) {
    record.links = LinksFile{{}, mesh->broken};
    for (const StaticLink& link : scene.hair.mesh->links) record.links->particles.push_back({link.a, link.b});
    record.worn_off = mesh->worn_off;
  }
  record.warnings = scene_run->warnings();
  if (scene.hair.strands.empty() || scene.hair.method != Method::implicit_euler)
    record.off_by = kOffByLoss * scene_run->watch().worst(Concern::loss);
  frames.close(unseen.empty());
  if (renderer) {
    if (progress) *progress << "\rfilm                       " << std::flush;
    record.no_film = make_film(folder.now(""), scene.frames_per_second);
    if (record.no_film) notes << (progress ? "\r" : "") << "no film: " << *record.no_film << "\n";
    laps.book(seconds.film);
  }
  if (progress) *progress << "\r                           \r" << std::flush;
  laps.book(seconds.write);
  seconds.total = seconds.read + laps.whole();
  write_whole(folder, "run.json", run_json(scene, record));
  folder.keep();
  return {std::move(record), folder.path()};
}

}  // namespace hair
