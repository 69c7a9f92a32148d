#include "hair/lab/run/explain.h"

#include <algorithm>
#include <functional>
#include <locale>

#include "hair/io/files/kept_file.h"
#include "hair/lab/run/film.h"
#include "hair/lab/run/run_record.h"
#include "hair/mass_spring/force_parts.h"
#include "hair/scene_drawing/idle_guides.h"
#include "solver/not_implemented.h"

namespace hair {

namespace {

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string shown(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

std::string shown(const Vector3d& vector) {
  return "(" + shown(vector.x()) + ", " + shown(vector.y()) + ", " + shown(vector.z()) + ")";
}

struct Parts {
  std::vector<Part> all;

  void add(const std::string& name, bool used, const std::string& as, const std::string& why_not) {
    all.push_back({name, used, false, used ? as : why_not});
  }
};

std::size_t count_strands(const Scene& scene, const std::function<bool(const StrandStart&)>& holds) {
  return static_cast<std::size_t>(std::ranges::count_if(scene.hair.strands, holds));
}

std::size_t count_toys(const Scene& scene, const std::function<bool(const Toy&)>& holds) {
  return static_cast<std::size_t>(std::ranges::count_if(scene.toys, holds));
}

void explain_hair(const Scene& scene, Parts& parts) {
  const Description& hair = scene.hair;
  const bool any = has_strands(scene);
  const std::string none = "the scene has no hair";
  const auto of = [](std::size_t count) { return "of " + counted(count, "strand"); };
  const auto why_not = [&](const std::string& why) { return any ? why : none; };

  std::size_t particles = 0;
  for (const StrandStart& start : hair.strands) particles += static_cast<std::size_t>(start.strand.count());
  for (const ModelledStrand& strand : hair.modelled)
    particles += static_cast<std::size_t>(strand.spec.elements + 1);
  parts.add("hair", any,
            counted(hair.strands.size() + hair.modelled.size(), "strand") + ", " +
                counted(particles, "particle") +
                (scene.bald_roots > 0
                     ? ", without " + counted(static_cast<std::size_t>(scene.bald_roots), "bald root")
                     : ""),
            none);
  parts.add("method", any, std::string(row_of(hair.method).id) + ", a step of " + shown(hair.step) + " s",
            none);

  const std::string other = "its strands are of another model";
  const bool implicit = !row_of(hair.method).is_explicit;
  parts.add("preconditioner", !hair.strands.empty() && implicit && hair.preconditioner,
            "block Cholesky of the forces' band",
            why_not(!hair.modelled.empty() ? other
                    : implicit             ? "the scene asks for none"
                                           : "an explicit method solves nothing"));
  for (const ForcePart& part : force_parts()) {
    const auto count = count_strands(scene, part.acts);
    const std::string whose = *part.exercise == '\0' ? "given" : part.exercise;
    parts.add(part.name, count > 0, whose + ", " + part.how + " " + of(count),
              why_not(hair.modelled.empty() ? part.why_not(hair.strands) : other));
  }
  const std::size_t links = hair.mesh ? hair.mesh->links.size() : 0;
  parts.add("links", links > 0, "H9, " + counted(links, "link") + "; linked hair is one system",
            why_not("nothing links the strands, so each is stepped by itself"));
  parts.add("strips", hair.mesh && !hair.mesh->strips.empty(),
            "H9, " + counted(hair.mesh ? hair.mesh->strips.size() : 0, "strip") + " of triangles",
            why_not("no strips lie between hairs"));
  parts.add("collisions", any && !hair.obstacles.empty(), counted(hair.obstacles.size(), "obstacle"),
            why_not("the scene has no obstacles, and so no collision stage"));
  parts.add("key frames", !scene.riders.empty(), counted(scene.riders.size(), "motion"),
            "roots and obstacles stay where they are");
}

void explain_toys(const Scene& scene, Parts& parts) {
  const std::string none = "the scene has no toy";
  const bool any = !scene.toys.empty();
  std::size_t particles = 0, springs = 0;
  for (const Toy& toy : scene.toys) {
    particles += static_cast<std::size_t>(toy.particles.count());
    springs += toy.springs.size();
  }
  parts.add("toys", any, counted(scene.toys.size(), "toy") + ", " + counted(particles, "particle"), none);
  parts.add("toys' springs", springs > 0, counted(springs, "spring"), any ? "no toy has any" : none);
  const auto held = count_toys(scene, [](const Toy& toy) { return toy.constraints.rows() > 0; });
  parts.add("constraints", held > 0, "P2, rods and wires of " + counted(held, "toy"),
            any ? "no toy has rods or wires" : none);
}

// Forces on both hair and toys.
void explain_surroundings(const Scene& scene, Parts& parts) {
  const Description& hair = scene.hair;
  const bool any = has_strands(scene);
  const Vector3d none = Vector3d::Zero();
  const bool gravity = (any && hair.gravity != none) ||
                       count_toys(scene, [&](const Toy& toy) { return toy.gravity != none; }) > 0;
  parts.add("gravity", gravity, shown(hair.gravity) + " m/s^2", "it is 0");
  const bool drag =
      (any && hair.drag > 0) || count_toys(scene, [](const Toy& toy) { return toy.drag > 0; }) > 0;
  parts.add("drag", drag, "the air's", "it is 0");
  parts.add("wind", drag && hair.wind != none, shown(hair.wind) + " m/s",
            hair.wind == none ? "the air is at rest" : "without drag it moves nothing");
}

// Only dense hair that is drawn as fine hair is kept out of obstacles.
void explain_clearance(const Scene& scene, bool render, std::size_t strands, Parts& parts) {
  const std::size_t obstacles = scene.hair.obstacles.size();
  parts.add("strand clearance", strands > 0 && render && scene.look && scene.look->fine_hair && obstacles > 0,
            "up to " + counted(strands, "strand") + " out of " + counted(obstacles, "obstacle") +
                "; of each picture's strands only those that touch one are moved",
            strands == 0     ? "no dense hair is drawn"
            : !render        ? "--no-render"
            : obstacles == 0 ? "the scene has no obstacles, so nothing is looked at"
                             : "ribbons are drawn as they are made");
}

// The number of guides that are not simulated, if the exercise that finds it is written.
std::string guides_left_out(const Scene& scene) {
  try {
    const std::size_t idle = idle_guides(scene, SceneDrawing(scene, {}, cache_folder())).size();
    return idle > 0 ? counted(idle, "guide") + " that no picture shows" : "";
  } catch (const NotImplemented&) {
    return "";
  }
}

void explain_dense_hair(const Scene& scene, bool render, Parts& parts) {
  std::size_t strands = 0, guides = 0;
  for (const DenseHair& dense : scene.dense) {
    strands += dense.description.children.size();
    guides += dense.description.guides.size();
  }
  const bool drawn = strands > 0 && render;
  parts.add(
      "dense hair", drawn,
      "H10, " + counted(strands, "strand") + " of " + counted(guides, "guide") + ", less those out of view",
      strands > 0 ? "--no-render" : "strands are drawn as they are");
  explain_clearance(scene, render, strands, parts);
  const std::string idle = drawn ? guides_left_out(scene) : "";
  // Its part is the work that these guides would take.
  parts.add("unseen guides", drawn && idle.empty(),
            "none: all are simulated, for pictures may show each, or links couple them",
            drawn                 ? idle + " are not simulated"
            : scene.dense.empty() ? "no strand is a guide"
                                  : "--no-render: states are asked for, and all guides are simulated");
}

void explain_still_hair(const Scene& scene, bool render, Parts& parts) {
  std::size_t strands = 0;
  for (const StillHair& hair : scene.still) strands += static_cast<std::size_t>(hair.settings.strands);
  parts.add("still hair", strands > 0 && render,
            counted(strands, "strand") + " that go with a head, and only are drawn",
            strands > 0 ? "--no-render" : "all hair moves");
}

void explain_exercises(const Scene& scene, const Course& course, Parts& parts) {
  const std::vector<std::string> used = exercises_of(scene);
  for (const Exercise& exercise : course.exercises) {
    if (exercise.role == Role::absent) continue;
    const bool called = std::ranges::find(used, exercise.id) != used.end();
    const std::string name = "exercise " + exercise.id, file = "student/" + exercise.file;
    if (called && exercise.stub)
      parts.all.push_back({name, true, true, file + ", not written yet"});
    else
      parts.add(name, called, file, "nothing in this scene calls it");
  }
}

void explain_pictures(const Scene& scene, bool render, Parts& parts) {
  const bool used = scene.look && render;
  const std::string none = scene.look ? "--no-render" : "the scene has no \"render\"";
  const Look look = scene.look.value_or(Look{});
  parts.add("pictures", used, std::to_string(look.image_width) + " x " + std::to_string(look.image_height),
            none);
  parts.add("shadows", used && look.shadows, "of hair on hair and on what it falls on",
            used ? "\"shadows\" is false" : none);
  parts.add("OpenGL", used, "loaded when the first picture is drawn", none + ": no library is loaded");
  parts.add("film", used && find_ffmpeg(),
            "by ffmpeg, at " + shown(scene.frames_per_second) + " frames a second",
            used ? "ffmpeg is not on PATH (package ffmpeg brings it)" : none);
}

}  // namespace

std::vector<Part> explain(const Scene& scene, bool render, const Course& course) {
  Parts parts;
  explain_hair(scene, parts);
  explain_toys(scene, parts);
  explain_surroundings(scene, parts);
  explain_dense_hair(scene, render, parts);
  explain_still_hair(scene, render, parts);
  explain_exercises(scene, course, parts);
  explain_pictures(scene, render, parts);
  return std::move(parts.all);
}

std::string explanation(const std::vector<Part>& parts) {
  std::size_t widest = 0;
  for (const Part& part : parts) widest = std::max(widest, part.name.size());
  std::string text;
  for (const Part& part : parts)
    text += "  " + part.name + std::string(widest - part.name.size(), ' ') +
            (part.stub   ? "  stub      "
             : part.used ? "  used      "
                         : "  left out  ") +
            part.why + "\n";
  return text;
}

}  // namespace hair
