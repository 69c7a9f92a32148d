// STAFF ONLY. The staff's pictures, as files in DIR/staff/pictures. Each file name is the SHA-256 of its
// bytes: a picture that many results show, such as the reference's, is stored once, and damage is detected.
#pragma once

#include <filesystem>
#include <string>

#include "grader/result/result.h"

namespace grader::inline report {

std::filesystem::path pictures_folder(const std::filesystem::path& dir);

std::string picture_name(const std::string& png);  // returns "HASH.png"; "" for no picture

// Writes all pictures of a result. Call it before writing the page and the JSON that name them.
void write_pictures(const std::filesystem::path& folder, const SubmissionResult& result);

// Removes pictures that no staff/NAME.html shows any more. It reads the pages, not this batch's results,
// because `dir` may hold reports of other submissions, too.
void remove_unshown_pictures(const std::filesystem::path& dir);

}  // namespace grader::report
