#include "hair/lab/run/motion_of_run.h"

#include <charconv>

namespace hair {

int strand_of(const std::string& blow_up) {
  constexpr std::string_view kWord = "strand ";
  int strand = -1;
  if (blow_up.starts_with(kWord))
    std::from_chars(blow_up.data() + kWord.size(), blow_up.data() + blow_up.size(), strand);
  return strand;
}

std::string motion_json(const Scene& scene, const RunRecord& record, const Camera& camera,
                        const MotionFrames& frames, bool measured) {
  MotionStory story{.name = scene.name,
                    .shows = scene.shows,
                    .ended = name_of(record.ending),
                    .blow_up = record.blow_up,
                    .broken_strand = strand_of(record.blow_up),
                    .camera = camera};
  const Look look = scene.look.value_or(Look());
  story.aspect = static_cast<double>(look.image_width) / look.image_height;
  MotionSeries energy{"energy", "J"}, kinetic{"kinetic energy", "J"}, stretch{"largest stretch", "%"},
      solver{"solver steps", ""}, corrections{"correction steps", ""}, contacts{"contacts", ""};
  Work before;
  for (const FrameRecord& frame : record.frames) {
    story.times.push_back(frame.time);
    energy.values.push_back(frame.measures.energy());
    kinetic.values.push_back(frame.measures.kinetic);
    stretch.values.push_back(100 * frame.measures.stretch);
    solver.values.push_back(static_cast<double>(frame.work.solver_steps - before.solver_steps));
    corrections.values.push_back(static_cast<double>(frame.work.correction_steps - before.correction_steps));
    contacts.values.push_back(static_cast<double>(frame.work.contacts - before.contacts));
    before = frame.work;
  }
  story.series = {energy, kinetic, stretch};
  // Only series of the scene's parts.
  if (before.solver_steps > 0) story.series.push_back(solver);
  if (before.correction_steps > 0) story.series.push_back(corrections);
  if (before.contacts > 0) story.series.push_back(contacts);
  if (!measured) story.series.clear();
  return frames.json(story);
}

}  // namespace hair
