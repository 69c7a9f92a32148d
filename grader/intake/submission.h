// STAFF ONLY. Finds the exercise files in what students hand in. Nothing is unpacked to disk: archives are
// read in memory, and only files with an exercise's name are kept, so that paths and links can do no harm.
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
// Each of several arguments is a hand-in of one student: a hand-in can look like a class, and must not speak
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
#include "grader/intake/accounted.h"
#include "grader/intake/archive.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/owner.h"

namespace grader::inline intake {

struct SourceFile {
  std::string text;  // the file's bytes
  std::string problem =
      {};  // not empty: why it is rejected, a sentence for the student; then `text` is empty
  std::string choice =
      {};  // not empty: a sentence for the student that names the file, of several or under another name
};

struct Submission {
  std::string name;                              // see names.h
  std::string origin;                            // see origin.h; "": a name that clashes
  std::map<std::string, SourceFile> files = {};  // by exercise file ("conj_grad.cpp"); only handed-in files
  std::string problem = {};  // not empty: why the whole submission is rejected, for the student
  bool unreadable = false;   // it has a problem: it is no archive that we read, or a damaged or encrypted one
  Owner owner = {};
  std::string system = {};  // the layout's name, as --from takes it: "canvas", "folders"
  std::string handed_in =
      {};  // as the download says it (text/time_text.h); "": it has no time; "-": a table says none
  bool marked_late = false;  // by the learning system
  std::string about = {};    // the text of about.txt, a student's answers about the course; "": there is none
  std::string known_as = {};  // the name that was found, where `name` is a code (tool/blind.h)
  std::string drawn_from =
      {};  // the name that its inputs are drawn from, as the class's record has it; "": `name`
};
inline const std::string& drawn_from(const Submission& submission) {
  return submission.drawn_from.empty() ? submission.name : submission.drawn_from;
}

struct Intake {
  std::vector<Submission> submissions;  // sorted by name; each has a name of its own
  // For staff, a line for each argument: a hand-in or a class. Of several arguments only for classes.
  std::vector<std::string> taken_for;
  // For staff, a line each that a person must look at: files that belong to nobody, archives that stayed
  // shut, names that clash.
  std::vector<std::string> notices;
  std::map<std::string, std::string> whose_notice =
      {};  // by notice: the submission that it is about, if it is about one
  // For staff, a line each that is good to know: names that were guessed, files taken under other names, who
  // has handed in nothing that counts.
  std::vector<std::string> remarks;
  std::vector<Accounted> accounted;  // each file of the input, but what systems leave behind (ignored.h)
};

// Limits for reading one submission. Names that systems leave behind (ignored.h) use up nothing. A whole
// argument may have 10 times the entries, and its stream may unpack to 20 times its own size if that is more;
// honest files compress less than that.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;  // one exercise file
  std::size_t unpacked_bytes = std::size_t{256}
                               << 20;  // all that is read, including nested archives and what is read of them
  std::size_t stream_bytes = std::size_t{1} << 30;  // a tar's whole stream; only a part of it is kept
  std::size_t entries = 200000;                     // files and folders, including those in nested archives
};

struct IntakeChoices {
  bool classes = false;   // each of several arguments may be a class
  std::string from = {};  // the layout (layouts/system.h), or "folders"; "": it is guessed
  KnownOwner known = {};  // from the roster, where a name has several readings

  bool says_class() const { return classes || (!from.empty() && from != "folders"); }
};

// Files of absent exercises are ignored. An error in one submission is reported in it and does not affect
// others. Throws BadInput for an argument that does not exist, for a lone one that can't be read whole, that
// is neither an archive nor a folder, or in which nothing is recognised; and Question if all arguments look
// like classes and may be hand-ins.
Intake read_submissions(const std::vector<std::filesystem::path>& arguments, const Course& course,
                        const OpenArchive& open_archive, const IntakeLimits& limits = {},
                        const IntakeChoices& choices = {});

// The folder of one student, who is called `name` whatever is in it: never a class. A folder without any
// exercise file is a submission with a problem.
Intake read_hand_in(const std::filesystem::path& folder, const std::string& name, const Course& course,
                    const OpenArchive& open_archive, const IntakeLimits& limits = {});

}  // namespace grader::intake
