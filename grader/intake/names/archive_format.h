// STAFF ONLY. Recognises a file's format by its first bytes, and its kind by its name.
#pragma once

#include <string_view>

namespace grader::inline intake {

inline constexpr std::size_t kHeadBytes = 512;  // is a tar's header; the functions below look at no more

bool is_zip(std::string_view head);  // other zips are recognised by their end (zip_source.h)
bool is_gzip(std::string_view head);
bool is_tar(std::string_view head);

// Returns the name of another format: "a RAR archive"; "" for an unknown one.
std::string_view foreign_format(std::string_view head);

// True if `name` has an archive's extension, including archives that can't be read here ("x.rar"), so that a
// student who hands one in gets a message.
bool has_archive_ending(std::string_view name);
// Returns `name` without the extension of an archive or a document.
std::string_view without_archive_ending(std::string_view name);

// True if `name` is a document's, such as "x.pdf": a student handed in a report in place of an archive.
bool has_document_ending(std::string_view name);

}  // namespace grader::intake
