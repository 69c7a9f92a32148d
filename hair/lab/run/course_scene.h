// The scene that a command names, if the course has what it calls.
#pragma once

#include <string>

#include "hair/course/course.h"
#include "hair/scene/scene.h"

namespace hair {

// `name`: a file, or the name of a shipped scene. Throws BadInput for a scene that can't be read, and for one
// that calls an exercise that the course leaves out.
Scene read_course_scene(const std::string& name, const Course& course);

// The same, of a scene that is not played: with few of its strands.
Scene read_course_outline(const std::string& name, const Course& course);

}  // namespace hair
