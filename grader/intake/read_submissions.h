// STAFF ONLY. Finds the exercise files in submissions. Nothing is unpacked to disk: archives are read in
// memory, and only files with an exercise's name are kept, so that paths and links can do no harm.
//
// A submission is a .zip, a .tar.gz, .tgz or .tar, or a folder. An argument is one submission or holds a
// class of them: a learning system's download (layouts/division.h), or folders and archives
// (layouts/folders.h). Archives are recognised by content, not by extension.
//
//   class.zip with alice.zip, bob.tar.gz, carol/   a class of three
//   class/ with alice/, bob/                       a class of two
//   class.zip with Jane Doe_4711_assignsubmission_file/...   a class, as Moodle exports it
//   class.zip with doejane_12_34_conj_grad.cpp, ...          a class, as Canvas exports single files
//   alice.zip with project/student/conj_grad.cpp   one submission with a whole project
//
// Each of several arguments is a hand-in of one student: a hand-in can look like a class, and must not act
// for others. One that looks so is refused, unless the caller says that there are classes. A lone argument is
// refused if it looks so and has a hand-in's name: that of a folder or archive in it, or one that a learning
// system gives.
//
// Nobody gets lost: an archive, or a document in the place of one, always gives a submission, and every file
// is accounted for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/intake/archives/archive.h"
#include "grader/intake/submission.h"

namespace grader::inline intake {

// Files of absent exercises are ignored. An error in one submission is reported in it and does not affect
// others. Throws BadInput for an argument that does not exist, for a single one that can't be read whole,
// that is neither an archive nor a folder, or that holds nothing known; and Question if all arguments look
// like classes and may be hand-ins.
Intake read_submissions(const std::vector<std::filesystem::path>& arguments, const Course& course,
                        const OpenArchive& open_archive, const IntakeLimits& limits = {},
                        const IntakeChoices& choices = {});

// Reads the folder of one student, who is called `name` whatever is in it: it is never a class. A folder
// without any exercise file is a submission with a problem.
Intake read_hand_in(const std::filesystem::path& folder, const std::string& name, const Course& course,
                    const OpenArchive& open_archive, const IntakeLimits& limits = {});

}  // namespace grader::intake
