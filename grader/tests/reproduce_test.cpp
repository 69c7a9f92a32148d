// STAFF ONLY. Tests that a failing case builds and fails again without the grader, and that its folder tells
// nothing of the reference; and that hairgrade's try keeps nothing.
#include <cstdlib>

#include "grader/course/course.h"
#include "grader/package/gates.h"
#include "grader/record/record.h"
#include "grader/samples/solution_files.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

const fs::path kProject = HAIR_PROJECT;

const Course kCourse = read_course(kProject / "handout/exercises.json");

string wrong_program(const string& exercise, const string& sample) {
  const auto is_it = [&](const Sample& one, const string&) { return one.name == sample; };
  return programs_of(*kCourse.find(exercise), kProject, is_it).at(0).source;
}

string build_and_run(const fs::path& folder, bool ends_well = true) {
  const string in = "'" + folder.string() + "'", log = folder.string() + ".log";
  EXPECT_EQ(std::system(("(cmake -S " + in + " -B " + in + "/build && cmake --build " + in + "/build && " +
                         in + "/build/case) > '" + log + "' 2>&1")
                            .c_str()) == 0,
            ends_well);
  return hair::bytes_of(log);
}

// Expects that the program prints the numbers that the suite names: "worst entry 5: 1, expected 2".
void expect_numbers_of_the_suite(const string& output) {
  EXPECT_TRUE(says(output, "These are the numbers that grading saw."));
  const size_t at = output.find("worst entry ");
  if (at == string::npos) return;
  string words = output.substr(at + 6, output.find_first_of(";\n", at) - at - 6);
  words.replace(words.find(": ") + 2, 0, "actual ");
  EXPECT_TRUE(says(output, "\n" + words + "\n"));
}

void expect_no_secrets(const fs::path& folder, const string& secret) {
  package::Files files, reference;
  for (const auto& [path, text] : files_in(folder)) {
    if (path.starts_with("build/") || path.starts_with("student/")) continue;
    EXPECT_FALSE(says(text, secret)) << path;
    if (!path.ends_with(".a")) files[path] = text;
  }
  for (const auto& [path, text] : files_in(kProject / "reference"))
    if (path.ends_with(".cpp") || path.ends_with(".h")) reference[path] = text;
  EXPECT_NO_THROW(package::check_reference_lines(files, reference, {}));
}

struct Wrong {
  const char *name, *exercise, *sample, *place;
};
constexpr Wrong kWrong[] = {{"ada", "H10", "h10-weights-not-clamped", "H10.2"},  // plain values
                            {"ada", "S1", "steepest-descent", "S1.1"},           // a matrix of the suite's
                            {"ada", "H4", "h4-wrong-sign", "H4.1"},              // a force; returns a matrix
                            {"ben", "H4", "h4-output-by-value", "H4.6"},         // calls a given function
                            {"ada", "P1", "p1-midpoint-full-step", "P1.3"},      // dynamics of the suite's
                            {"ada", "H7", "h7-not-shifted", "H7.4"},             // lists of structs
                            {"ada", "H2", "h2-force-sign", "H2.2"}};             // strands

class OfARecord : public InAFolder {
 protected:
  OfARecord() : InAFolder(course_of({"S1", "P1", "H2", "H4", "H7", "H10"})) {
    for (const Wrong& wrong : kWrong)
      write(string("class/") + wrong.name + "/" + kCourse.find(wrong.exercise)->file,
            wrong_program(wrong.exercise, wrong.sample));
    write("class/ben/conj_grad.cpp", wrong_program("S1", "fixed-arrays"));
    EXPECT_EQ(grade({path("class")}).code, 0);
  }
  ProgramRun again(std::vector<string> words, const char* secret = "secret") const {
    words.insert(words.end(), {"--grades", path("grades"), "--secret", path(secret), "--cache", path("cache"),
                               "--course", path("course.json")});
    return run_hairgrade(words);
  }
};

TEST_F(OfARecord, IsReproducedAndTriedAndKeepsNothing) {
  const auto files = files_in(path("grades"));
  const string record = Record(path("grades")).export_json();
  for (const Wrong& wrong : kWrong) {
    SCOPED_TRACE(wrong.sample);
    const ProgramRun run = again({"reproduce", wrong.name, wrong.place, "--out", path(wrong.place)});
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_numbers_of_the_suite(build_and_run(path(wrong.place)));
    expect_no_secrets(path(wrong.place), read("secret"));
  }
  EXPECT_EQ(again({"reproduce", "ben", "S1.2", "--out", path("S1.2")}).code, 0);
  EXPECT_TRUE(says(build_and_run(path("S1.2"), false), "AddressSanitizer: stack-buffer-overflow"));
  const string right = (kProject / "reference/H2/angular_springs.cpp").string();
  fs::copy(right, path("H2.2/student/angular_springs.cpp"), fs::copy_options::overwrite_existing);
  EXPECT_TRUE(says(build_and_run(path("H2.2")), "These are not the numbers")) << "it is the student's code";
  const ProgramRun tried = again({"try", "ada", "H2", "--with", right});
  EXPECT_EQ(tried.code, 0) << tried.errors;
  for (const char* words : {"0 wrong                     5 passed\n", "30 passed\n"})
    EXPECT_TRUE(says(tried.output, words));

  write("other", "another secret for this test");
  struct Refused {
    std::vector<string> words;
    const char *because, *secret = "secret";
  };
  for (const auto& [words, because, secret] : std::vector<Refused>{
           {{"reproduce", "ada", "H2.2", "--out", path("H2.2")}, "is not empty"},
           {{"reproduce", "ada", "H2.1", "--out", path("new")}, "H2.1: passes"},
           {{"reproduce", "ada", "H2.14", "--out", path("new")}, "it judges a whole run"},
           {{"reproduce", "ada", "H2.99", "--out", path("new")}, "is no category; H2 has 14"},
           {{"reproduce", "ada", "H2", "--out", path("new")}, "is no category"},
           {{"reproduce", "ben", "H2.2", "--out", path("new")}, "is no category; H2 has 0"},
           {{"reproduce", "ada", "S2.1", "--out", path("new")}, "S2: is no exercise that ada"},
           {{"reproduce", "eve", "H2.2", "--out", path("new")}, "eve: is no hand-in"},
           {{"try", "ada", "H2", "--with", path("nothing")}, "nothing"},
           {{"try", "ada", "H2", "--with", right}, "secret", "other"}})
    expect_refused(again(words, secret), because);
  EXPECT_FALSE(fs::exists(path("new")));
  EXPECT_EQ(files_in(path("grades")), files);
  EXPECT_EQ(Record(path("grades")).export_json(), record);
}

}  // namespace
}  // namespace grader
