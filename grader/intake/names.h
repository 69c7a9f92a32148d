// STAFF ONLY. The names of submissions. They become names of files and folders, words of command lines and
// cells of tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

// The name of an archive or folder without its extension. Bytes other than letters, digits, '.', '_' and '-'
// become '_'. A name that begins with none of letters and digits gets an 'x' in front: programs take "-rf" for
// an option and skip ".name". A name that the class reports need ("staff") gets a '_' at its end.
std::string submission_name(std::string_view name);

// A name for one of several submissions that are called `name`. It depends on its path alone.
std::string name_among_equals(const std::string& name, std::string_view path);

// "alice, bob and 178 more": of many names the first ten.
std::string some_of(const std::vector<std::string>& names);

}  // namespace grader
