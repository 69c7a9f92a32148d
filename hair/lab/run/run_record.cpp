#include "hair/lab/run/run_record.h"

#include <iterator>
#include <locale>
#include <sstream>

#include "hair/io/files/json_text.h"

namespace hair {

namespace {

std::string text_of(const Vector3d& vector) {
  return json_list({json_text(vector.x()), json_text(vector.y()), json_text(vector.z())});
}

std::string text_or_null(const std::string& text) {
  return text.empty() ? "null" : json_text(text);
}

std::string text_of(const Work& work) {
  return json_object({{"strand_steps", json_text(work.strand_steps)},
                      {"solver_steps", json_text(work.solver_steps)},
                      {"plain_solves", json_text(work.plain_solves)},
                      {"correction_steps", json_text(work.correction_steps)},
                      {"solves", json_text(work.solves)},
                      {"unconverged", json_text(work.unconverged)},
                      {"contacts", json_text(work.contacts)},
                      {"unmended", json_text(work.unmended)},
                      {"kept_steps", json_text(work.kept_steps)},
                      {"penetration", json_text(work.penetration)}});
}

// The work since the previous frame.
std::string text_of(long k, const FrameRecord& frame, const Work& before) {
  return json_object({{"frame", json_text(k)},
                      {"time", json_text(frame.time)},
                      {"kinetic", json_text(frame.measures.kinetic)},
                      {"potential", json_text(frame.measures.potential)},
                      {"energy", json_text(frame.measures.energy())},
                      {"momentum", text_of(frame.measures.momentum)},
                      {"angular_momentum", text_of(frame.measures.angular_momentum)},
                      {"stretch", json_text(frame.measures.stretch)},
                      {"solver_steps", json_text(frame.work.solver_steps - before.solver_steps)},
                      {"correction_steps", json_text(frame.work.correction_steps - before.correction_steps)},
                      {"unconverged", json_text(frame.work.unconverged - before.unconverged)},
                      {"contacts", json_text(frame.work.contacts - before.contacts)}});
}

std::string text_of(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& one : warnings)
    text += (text.empty() ? "\n    " : ",\n    ") +
            json_object({{"concern", json_text(one.concern->id)},
                         {"body", json_text(std::string(one.body))},
                         {"strand", json_text(one.strand)},
                         {"step", json_text(one.step)},
                         {"strands", json_text(one.strands)},
                         {"size", json_text(one.size)},
                         {"bound", json_text(one.concern->bound)},
                         {"measure", json_text(one.concern->measure)},
                         {"solver", text_or_null(std::string(one.solver))}});
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

std::string text_of(const Seconds& seconds) {
  return json_object({{"read", json_text(seconds.read)},
                      {"assemble", json_text(seconds.assemble)},
                      {"prepare", json_text(seconds.prepare)},
                      {"simulate", json_text(seconds.simulate)},
                      {"measure", json_text(seconds.measure)},
                      {"write", json_text(seconds.write)},
                      {"lay_out", json_text(seconds.lay_out)},
                      {"draw", json_text(seconds.draw)},
                      {"png", json_text(seconds.png)},
                      {"film", json_text(seconds.film)},
                      {"total", json_text(seconds.total)}});
}

std::string dense_text(const RunRecord& record) {
  if (!record.dense) return "null";
  const SynthesisCounts& counts = *record.dense;
  return "{\"strands\": " + json_text(counts.children) +
         ", \"out_of_view\": " + json_text(counts.children_out_of_view) +
         ", \"moved_out\": " + json_text(record.moved_out) +
         ", \"guides\": " + json_text(counts.guides_used) +
         ", \"guides_idle\": " + json_text(counts.guides_idle) +
         ", \"guides_left_out\": " + json_text(static_cast<long>(record.guides_left_out)) + "}";
}

// states.bin holds the broken links and their steps.
std::string links_text(const RunRecord& record) {
  if (!record.links) return "null";
  const LinksFile& links = *record.links;
  return json_object({{"links", json_text(std::ssize(links.particles))},
                      {"broken", json_text(std::ssize(links.broken))},
                      {"first_broken", links.broken.empty() ? "null" : json_text(links.broken.front().step)},
                      {"worn_off", json_text(record.worn_off)}});
}

}  // namespace

const char* name_of(Ending ending) {
  constexpr const char* kNames[] = {"finished", "interrupted", "blow-up"};
  return kNames[static_cast<int>(ending)];
}

std::string warning_text(const std::vector<Warning>& warnings) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  const char* between = "";
  for (const Warning& one : warnings) {
    text << between << one.body << " " << one.strand;
    if (one.strands > 1) text << " (the first of " << one.strands << ")";
    text << " " << one.concern->says << ", from step " << one.step << " on: " << one.size << " "
         << one.concern->measure;
    if (!one.solver.empty()) text << " (" << one.solver << " asks, and ConjGrad of S1 solves)";
    between = "; ";
  }
  return text.str();
}

std::string run_json(const Scene& scene, const RunRecord& record) {
  const bool hair = has_strands(scene);
  const JsonMember head[] = {
      {"program", json_text("hairlab")},
      {"format", json_text(1)},
      {"scene", json_text(scene.name)},
      {"shows", json_text(scene.shows)},
      {"exercises", json_text(exercises_of(scene))},
      {"ended", json_text(name_of(record.ending))},
      {"blow_up", text_or_null(record.blow_up)},
      {"frames_asked", json_text(record.frames_asked + 1)},
      {"frames_written", json_text(std::ssize(record.frames))},
      {"frames_per_second", json_text(scene.frames_per_second)},
      {"steps_per_frame", json_text(scene.steps_per_frame)},
      {"step", json_text(scene.hair.step)},
      {"method", hair ? json_text(row_of(scene.hair.method).id) : "null"},
      {"strands", json_text(std::ssize(record.strands))},
      {"particles", json_text(record.particles)},
      {"no_pictures", json_text(record.no_pictures)},
      {"no_film", json_text(record.no_film)},
      {"opengl", text_or_null(record.opengl)},
      {"dense_hair", dense_text(record)},
      {"work", text_of(record.frames.empty() ? Work{} : record.frames.back().work)},
      {"links", links_text(record)},
      {"off_by", record.off_by ? json_text(*record.off_by) : "null"},
      {"warnings", text_of(record.warnings)},
  };
  std::string text = "{\n";
  for (const JsonMember& one : head) text += "  " + json_text(one.key) + ": " + one.value + ",\n";
  text += "  \"frames\": [";
  Work before;
  for (std::size_t k = 0; k < record.frames.size(); ++k) {
    const FrameRecord& frame = record.frames[k];
    text += (k == 0 ? "\n    " : ",\n    ") + text_of(static_cast<long>(k), frame, before);
    before = frame.work;
  }
  return text + "\n  ],\n  \"seconds\": " + text_of(record.seconds) + "\n}\n";
}

}  // namespace hair
