// STAFF ONLY. What a run looked like, for pages: a submission's picture, the reference's and the heat map of
// their difference side by side.
#pragma once

#include <string>
#include <vector>

#include "grader/report/result.h"
#include "hair/io/plot/html.h"

namespace grader {

using hair::Html, hair::html, hair::html_page, hair::Pictures, hair::Scripts;

// Where a page has its pictures: in itself, or in a folder of files (picture_files.h) that is reached from it by
// this path.
struct PicturePlace {
  std::string folder = "";  // "pictures"; empty: in itself
};

// A PNG file's bytes, shown. `look` is a class of the style sheet, or "".
Html image(const std::string& png, const std::string& alt, const PicturePlace& place = {},
           const char* look = "");

// A picture with its caption below.
Html figure(const Html& picture, const Html& caption);

// A row for each moment, with its distances, under a heading that opens and closes. Open from the start if
// one is too far, or differs and is not scored. Nothing without pictures. `whose` captions the submission's:
// "Yours".
Html moments(const std::vector<PictureResult>& pictures, const std::string& heading, const std::string& whose,
             const PicturePlace& place);

// A section of the class's page: submissions by how far their pictures are from the reference's, worst first,
// and small pictures of the worst.
Html pictures_by_distance(const std::vector<SubmissionResult>& results, const PicturePlace& place);

std::string shown_distance(double distance);  // "0.0123"

// The colours of a heat map, with their ends named.
Html heat_scale();

}  // namespace grader
