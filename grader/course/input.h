// STAFF ONLY. The project's common functions for reading and writing files and for reporting bad input.
#pragma once

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/strict_json.h"
#include "hair/io/files/write_file.h"

namespace grader::inline course {

using hair::BadInput, hair::JsonValue, hair::printable, hair::read_json, hair::write_file;

}  // namespace grader::course
