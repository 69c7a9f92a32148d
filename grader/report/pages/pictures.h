// STAFF ONLY. Pictures of runs, for pages: a submission's picture, the reference's and the heat map of their
// difference, side by side.
#pragma once

#include <string>
#include <vector>

#include "grader/result/result.h"
#include "grader/roster/class_list.h"
#include "hair/io/plot/html.h"

namespace grader::inline report {

using hair::Html, hair::html, hair::html_page, hair::Pictures, hair::Scripts;

// Says where a page's pictures are: inside the page, or as files in this folder (picture_files.h). A
// student's are inside; pictures that are far off are coarse there (student_view.h).
struct PicturePlace {
  std::string folder = "";  // "pictures"; empty: inside the page
  std::string runs = "";    // is the folder of this person's pages of runs (run_page); empty: no links
  bool is_for_student = false;
};

// Writes an image element for a PNG file's bytes. `look` is a class of the style sheet, or "".
Html image(const std::string& png, const std::string& alt, const PicturePlace& place = {},
           const char* look = "");

// Writes a picture with its caption below.
Html figure(const Html& picture, const Html& caption);

enum class RunEnding { whole, breaks_off };

// Writes a row with its distances for each moment, under a heading that opens and closes. It starts open if a
// picture differs, or if the run breaks off: the pictures before that may be like the reference's, and the
// heading gives no distance. Empty without pictures. `whose` captions the submission's pictures: "Yours".
Html moments(const ExerciseResult& exercise, const std::string& heading, RunEnding ending,
             const std::string& whose, const PicturePlace& place);

// Writes a link to a place of a page of a run: "time=0.5" or "apart=1", as hair/view reads it. Empty without a page.
Html link_to_run(const ExerciseResult& exercise, const std::string& place, const std::string& runs,
                 const std::string& text);

// Writes a film (RunMotions::film) with a box that starts it; empty without one.
Html film(const std::string& png);

// Writes a section of the class page: submissions sorted by the distance of their pictures from the
// reference's, worst first, with small pictures of the worst.
Html pictures_by_distance(const std::vector<SubmissionResult>& results, const PicturePlace& place,
                          const NamesForPeople& people = {});

std::string shown_distance(double distance);  // writes three digits: "0.0123"

// Draws the colour scale of a heat map, with labels at its ends.
Html heat_scale();

}  // namespace grader::report
