// STAFF ONLY. A question of PrairieLearn for each exercise that a course asks for, to be copied into its
// course: questions/hair-S1/, ..., and serverFilesCourse/hairgrade/ with the secret, which students don't see
// there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/course/course.h"

namespace grader::inline package {

struct PrairieLearnCourse {
  std::filesystem::path out;
  std::optional<std::filesystem::path> course, secret;
  std::string image;  // has the package (debian/Dockerfile), and so the reference
};

// Throws BadInput if `out` is there, or can't be written.
void write_prairielearn_course(const std::string& secret, const Course& course,
                               const PrairieLearnCourse& options);

}  // namespace grader::package
