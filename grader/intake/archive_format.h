// STAFF ONLY. What a file is, by its first bytes, and what its name says that it is.
#pragma once

#include <string_view>

namespace grader::inline intake {

inline constexpr std::size_t kHeadBytes = 512;  // a tar's header; all that the functions below look at

bool is_zip(
    std::string_view head);  // others begin with something else, and are zips by their end (zip_source.h)
bool is_gzip(std::string_view head);
bool is_tar(std::string_view head);

// The name of another format: "a RAR archive"; "" if it is not known.
std::string_view foreign_format(std::string_view head);

// Whether `name` has an archive's extension, including archives that can't be read here ("x.rar"), so that a
// student who hands one in gets a message.
bool has_archive_ending(std::string_view name);
// `name` without such an extension, or that of a document.
std::string_view without_archive_ending(std::string_view name);

// Whether `name` is a document's, such as "x.pdf": somebody handed in a report in place of an archive.
bool has_document_ending(std::string_view name);

}  // namespace grader::intake
