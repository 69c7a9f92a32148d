// STAFF ONLY. The names of submissions. They become names of files and folders, words of command lines and
// cells of tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grader/intake/names/owner.h"

namespace grader::inline intake {

// Returns the name of an archive or folder without its extension. Bytes other than letters, digits, '.', '_'
// and '-' become '_'. A name that begins with another character gets an 'x' in front: programs take "-rf" for
// an option and skip ".name". A name that the class reports need ("staff") gets a '_' at its end.
std::string submission_name(std::string_view name);

// Returns the same for an owner: name and id, as "Jane_Doe_4711". It stays for all hand-ins of this owner.
// Letters outside ASCII lose their marks; if nothing else is left of some and there is no id, a number
// made of the name replaces them.
std::string name_of_owner(const Owner& owner);

// Returns a name for one of several submissions called `name`. It depends on the path alone.
std::string name_among_equals(const std::string& name, std::string_view path);

// Writes "alice, bob and 178 more": at most ten names.
std::string some_of(const std::vector<std::string>& names);

// Names that operating systems leave behind and no student writes: they are skipped without a
// line, with all files below them, and use up no limit.
bool is_ignored(std::string_view path);

}  // namespace grader::intake
