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
// system gives. See several_people.h.
//
// Nobody gets lost: an archive, or a document in the place of one, always gives a submission, and every file
// is accounted for.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/intake/archives/accounted.h"
#include "grader/intake/archives/archive.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/names/owner.h"

namespace grader::inline intake {

struct SourceFile {
  std::string text;  // are the file's bytes
  std::string problem =
      {};  // not empty: the reason of its rejection, a sentence for the student; then `text` is empty
  std::string choice =
      {};  // not empty: a sentence for the student about the chosen one of several files, or another name
};

struct Submission {
  std::string name;                              // see names.h
  std::string origin;                            // see origin.h; "": a name that clashes
  std::map<std::string, SourceFile> files = {};  // by exercise file ("conj_grad.cpp"); only handed-in files
  std::string problem = {};  // not empty: why the whole submission is rejected, for the student
  bool unreadable = false;   // has a problem: an unknown format, or a damaged or encrypted archive
  Owner owner = {};
  std::string system = {};  // is the layout's name, as --from takes it: "canvas", "folders"
  std::string handed_in =
      {};  // as in the download (text/time_text.h); "": it has no time; "-": a table has an empty cell
  bool marked_late = false;     // by the learning system
  std::string about = {};       // is the text of about.txt, a student's answers on the course; "": none
  std::string known_as = {};    // is the name in the download if `name` is a code (class_folder/blind.h)
  std::string drawn_from = {};  // is the name for random inputs, from the class's record; "": `name`
};
inline const std::string& drawn_from(const Submission& submission) {
  return submission.drawn_from.empty() ? submission.name : submission.drawn_from;
}

struct Intake {
  std::vector<Submission> submissions;  // sorted by name; each has a name of its own
  // Describe each argument to staff in a line: a hand-in or a class. Of several arguments only classes.
  std::vector<std::string> taken_for;
  // Are lines for staff that a person must look at: files that belong to nobody, archives that could not be
  // opened, names that clash.
  std::vector<std::string> notices;
  std::map<std::string, std::string> whose_notice = {};  // maps a notice to its submission, if it has one
  // Are lines for staff about guessed names, files taken under other names, and students without a hand-in
  // that counts.
  std::vector<std::string> remarks;
  std::vector<Accounted> accounted;  // each file of the input, except those in ignored.h
};

// Limits the reading of one submission. Names of operating systems (ignored.h) use up nothing. A whole
// argument may have 10 times the entries, and its stream may unpack to 20 times its own size if that is more;
// honest files compress less than that.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;  // bounds one exercise file
  std::size_t unpacked_bytes = std::size_t{256}
                               << 20;  // bounds all bytes read, including nested archives and their files
  std::size_t stream_bytes = std::size_t{1} << 30;  // bounds a tar's whole stream; only a part of it is kept
  std::size_t entries = 200000;                     // bounds files and folders, also those in nested archives
};

struct IntakeChoices {
  bool classes = false;   // each of several arguments may be a class
  std::string from = {};  // is the layout (layouts/system.h), or "folders"; "": it is guessed
  KnownOwner known = {};  // comes from the roster, for names with several readings

  bool says_class() const { return classes || (!from.empty() && from != "folders"); }
};

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
