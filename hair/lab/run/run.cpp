#include "hair/lab/run/run.h"

#include <stdexcept>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/cache_folder.h"
#include "hair/io/image/png.h"
#include "hair/lab/run/film.h"
#include "hair/lab/run/output_file.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/run/pictures.h"
#include "hair/lab/run/states_csv.h"
#include "hair/lab/run/states_file.h"
#include "hair/lab/run/strip_pushes.h"
#include "hair/render/idle_guides.h"
#include "hair/scene/playback.h"
#include "solver/timing.h"

namespace hair {

namespace {

std::unique_ptr<Playback> assemble(const Scene& scene) {
  try {
    return std::make_unique<Playback>(scene);
  } catch (const std::invalid_argument& error) {
    throw BadInput(scene.name + ": " + error.what());
  }
}

// Pictures if they are asked for and this machine can draw; else why there are none.
std::unique_ptr<Pictures> prepare_pictures(const Scene& scene, const RunSettings& settings, RunRecord& record,
                                           std::ostream& notes) {
  if (!scene.look) {
    record.no_pictures = "the scene has no \"render\"";
  } else if (!settings.render) {
    record.no_pictures = "--no-render";
  } else {
    try {
      auto pictures = std::make_unique<Pictures>(scene, record.strands, cache_folder());
      record.opengl = pictures->about();
      return pictures;
    } catch (const NoOpenGl& error) {
      record.no_pictures = error.what();
      notes << "no pictures: " << error.what() << "\n";
    }
  }
  record.no_film = "there are no pictures";
  return {};
}

// Where frames go.
class FrameWriter {
 public:
  FrameWriter(const Scene& scene, const OutputFolder& folder, const Playback& playback, Pictures* pictures,
              RunRecord& record, timing::Laps& laps)
      : folder_(folder),
        playback_(playback),
        pictures_(pictures),
        record_(record),
        laps_(laps),
        dense_(!scene.dense.empty()),
        binary_(folder.now("states.bin"), folder.then("states.bin"), playback.sizes(),
                static_cast<int>(playback.state().x.size() / 3), playback.coordinates().front()),
        csv_(folder.now("states.csv"), folder.then("states.csv"), record.strands) {}

  // Where the playback is now.
  void add() {
    Seconds& seconds = record_.seconds;
    const particles::State state = playback_.state(), lines = playback_.centre_lines(state);
    const int frame = static_cast<int>(record_.frames.size());
    record_.frames.push_back({playback_.time(), playback_.measure(state), playback_.work()});
    laps_.book(seconds.measure);
    binary_.add(playback_.time(), state);
    csv_.add(playback_.time(), lines);
    laps_.book(seconds.write);
    if (!pictures_) return;
    const double rendered = rendering();
    const Image image =
        pictures_->draw(lines, playback_.obstacles(), playback_.time(), playback_.mesh_record());
    laps_.book(seconds.lay_out);
    seconds.lay_out -= rendering() - rendered;
    if (dense_) record_.dense = pictures_->synthesised();
    record_.moved_out = pictures_->moved_out();
    write_whole(folder_, frame_name(frame), encode_png(image));
    laps_.book(seconds.png);
  }

  // s, of all pictures so far.
  double rendering() const {
    const RenderTimes& times = pictures_->times();
    return times.upload + times.shadow + times.draw + times.read_back;
  }

  void close() {
    if (record_.links) binary_.add(*record_.links);
    binary_.close();
    csv_.close();
    laps_.book(record_.seconds.write);
  }

 private:
  const OutputFolder& folder_;
  const Playback& playback_;
  Pictures* pictures_;
  RunRecord& record_;
  timing::Laps& laps_;
  bool dense_;
  StatesWriter binary_;
  CsvWriter csv_;
};

void play(Playback& playback, FrameWriter& frames, RunRecord& record, timing::Laps& laps,
          const std::atomic<bool>& interrupted, std::ostream* progress) {
  frames.add();
  for (int k = 1; k <= record.frames_asked; ++k) {
    if (interrupted) {
      record.ending = Ending::interrupted;
      return;
    }
    if (progress) *progress << "\rframe " << k << " of " << record.frames_asked << std::flush;
    const std::optional<std::string> trouble = playback.advance();
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

  const std::unique_ptr<Playback> playback = assemble(scene);
  record.strands = playback->strands();
  record.particles = static_cast<int>(playback->centre_lines(playback->state()).x.size() / 3);
  if (const auto slow = too_thick_strips(scene)) notes << scene.name << ": " << *slow << std::endl;
  laps.book(seconds.assemble);
  const std::unique_ptr<Pictures> pictures = prepare_pictures(scene, settings, record, notes);
  if (pictures && !scene.dense.empty()) {
    const std::vector<int> idle = idle_guides(scene, pictures->drawing());
    record.guides_left_out = idle.size();
    playback->leave_out(idle);
  }
  FrameWriter frames(scene, folder, *playback, pictures.get(), record, laps);
  laps.book(seconds.prepare);
  play(*playback, frames, record, laps, interrupted, progress);
  if (const MeshRecord* mesh = playback->mesh_record()) {
    record.links = LinksFile{{}, mesh->broken};
    for (const StaticLink& link : scene.hair.mesh->links) record.links->particles.push_back({link.a, link.b});
    record.worn_off = mesh->worn_off;
  }
  frames.close();
  record.warnings = playback->warnings();
  if (pictures) {
    const RenderTimes& times = pictures->times();
    seconds.upload = times.upload;
    seconds.shadow = times.shadow;
    seconds.draw = times.draw;
    seconds.read_back = times.read_back;
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
