// STAFF ONLY. The pictures that staff see, as files in DIR/staff/pictures. Each is named by the SHA-256 of its
// bytes: one that many results show, as they do the reference's, is there once, and damage shows.
#pragma once

#include <filesystem>
#include <string>

#include "grader/report/result.h"

namespace grader {

std::filesystem::path pictures_folder(const std::filesystem::path& dir);

std::string picture_name(const std::string& png);  // "HASH.png"; "" for no picture

// All of a result's, before the page and the record that name them.
void write_pictures(const std::filesystem::path& folder, const SubmissionResult& result);

// The bytes that have this name, "" for "". Throws BadInput if they are missing or others.
std::string read_picture(const std::filesystem::path& folder, const std::string& name);

// Removes what no staff/NAME.html shows any more. Pages decide, not this batch's results: `dir` may hold
// other submissions' reports, too.
void remove_unshown_pictures(const std::filesystem::path& dir);

}  // namespace grader
