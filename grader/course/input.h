// STAFF ONLY. How files are read and written, and how bad input is reported, is the same for all of the
// project's programs.
#pragma once

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/strict_json.h"
#include "hair/io/files/write_file.h"

namespace grader {

using hair::BadInput, hair::JsonValue, hair::printable, hair::read_json, hair::write_file;

}  // namespace grader
