// STAFF ONLY. Tests with random downloads of all learning systems that each student has one submission with
// the newest file, and that each file of the input is accounted for. The generator follows the systems' own
// sources and uses nothing of intake.
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {
namespace {

struct Student {
  std::string name, number, id;
  std::string newest = {};  // is the conj_grad.cpp that counts; "": there is none
  bool has_files = false;
};

struct Download {
  std::vector<std::pair<std::string, std::string>> files = {};  // path, content
  std::vector<Student> students = {};
  std::string system = {}, root = {};
};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  Download make() {
    static const std::vector<void (Generator::*)()> all{
        &Generator::canvas,  &Generator::moodle,    &Generator::brightspace, &Generator::blackboard,
        &Generator::autolab, &Generator::classroom, &Generator::gradescope};
    download_.root = chance(3) ? "wrapped/" : "";
    const int count = below(9) + 2;
    for (int i = 0; i < count; ++i) {
      const std::string number = std::to_string(4000 + 7 * i);
      download_.students.push_back({any_name(i), number, number});
    }
    (this->*all.at(static_cast<std::size_t>(below(7))))();
    return download_;
  }

 private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  bool chance(int of) { return below(of) == 0; }
  std::string any_name(int i) {
    static const std::vector<std::string> kFirst{"Ann",        "Jörg", "O'Brien", "Mary-Lou", "王伟",
                                                 "de la Cruz", "LATE", "Seán",    "Zoë"};
    return kFirst[static_cast<std::size_t>(below(static_cast<int>(kFirst.size())))] + " " +
           std::string(1, static_cast<char>('A' + i)) + "son";
  }
  static std::string squeezed(
      const std::string& name) {  // as Canvas does: no blanks, hyphens, apostrophes; lower case
    std::string text;
    for (const char c : name)
      if (c != ' ' && c != '-' && c != '\'') text += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return text;
  }
  static std::string text_of(const Student& one, int attempt) {
    return one.id + " of attempt " + std::to_string(attempt);
  }
  void add(const std::string& path, const std::string& text) {
    download_.files.emplace_back(download_.root + path, text);
  }

  // Returns the files of an attempt, by `place`. One of five students hands in only another file.
  template <class Place>
  void attempt(Student& student, int number, Place place) {
    const bool has = !chance(5);
    const std::string text = text_of(student, number);
    student.has_files = true;
    student.newest = has ? text : "";
    if (has && chance(4))
      add(place("handin.zip"), zip("hw/conj_grad.cpp", text));
    else if (has)
      add(place("conj_grad.cpp"), text);
    if (!has || chance(3)) add(place("report.pdf"), "%PDF");
  }

  void canvas() {
    download_.system = "canvas";
    int file = 90000;
    for (Student& one : download_.students) {
      const std::string stem = squeezed(one.name) + (chance(4) ? "_LATE_" : "_") + one.id + "_";
      if (chance(6)) {
        add(stem + (chance(2) ? "text.html" : "link.html"), "<p>");
        continue;
      }
      attempt(one, 1, [&](const std::string& name) { return stem + std::to_string(file++) + "_" + name; });
    }
  }
  static std::string clean(const std::string& name) {  // as Moodle's clean_filename: no apostrophes
    std::string text;
    for (const char c : name)
      if (c != '\'') text += c;
    return text;
  }
  void moodle() {
    download_.system = "moodle";
    const bool flat = chance(2);
    const char* end = chance(2) ? "_" : "";
    for (Student& one : download_.students) {
      const std::string stem = clean(one.name) + "_" + one.id + "_assignsubmission_";
      if (!flat && chance(3))
        add(stem + "onlinetext" + end + "/onlinetext.html", "<p>");
      else
        attempt(one, 1, [&](const std::string& name) {
          return stem + "file" +
                 (flat        ? "_"
                  : chance(4) ? end + std::string("/src/")
                              : end + std::string("/")) +
                 name;
        });
    }
  }
  void brightspace() {
    download_.system = "brightspace";
    const bool flat = chance(2);
    add("index.html", "<html>");
    for (Student& one : download_.students) {
      for (int number = 1; number <= 1 + below(3); ++number) {
        const std::string stem = one.id + "-99 - " + one.name + " - May " + std::to_string(number + 8) +
                                 ", 2025 1" + std::to_string(below(3)) + "24 PM";
        attempt(one, number, [&](const std::string& name) { return stem + (flat ? " - " : "/") + name; });
      }
    }
  }
  void blackboard() {
    download_.system = "blackboard";
    for (Student& one : download_.students) {
      one.id = "user" + one.number;
      for (int number = 1; number <= 1 + below(3); ++number) {
        const std::string stem =
            "Lab_3 b_" + one.id + "_attempt_2025-03-0" + std::to_string(number) + "-10-15-22";
        add(stem + ".txt", "Name");
        attempt(one, number, [&](const std::string& name) { return stem + "_" + name; });
      }
    }
  }
  void autolab() {
    download_.system = "autolab";
    for (Student& one : download_.students) {
      one.id = "u_" + one.number + "@u.de";
      const int last = 1 + below(12);
      for (int number = 1; number <= last; ++number) {
        one.newest = text_of(one, number);
        one.has_files = true;
        add(one.id + "_" + std::to_string(number) + "_conj_grad.cpp", one.newest);
      }
    }
  }
  void classroom() {
    download_.system = "classroom";
    download_.root = "lab3-submissions/";
    for (Student& one : download_.students) {
      one.id = "login-" + one.number;
      attempt(one, 1, [&](const std::string& name) { return "lab3-" + one.id + "/" + name; });
    }
  }
  void gradescope() {
    download_.system = "gradescope";
    std::string yaml = "---\n";
    for (Student& one : download_.students) {
      const std::string folder = "submission_" + std::to_string(below(1000000)) + one.id;
      yaml += folder + ":\n  :submitters:\n  - :name: \"" + one.name + "\"\n    :sid: '" + one.id +
              "'\n    :email: x@u.de\n  :created_at: 2025-03-04 10:15:22 Z\n";
      attempt(one, 1, [&](const std::string& name) { return folder + "/" + name; });
    }
    add("submission_metadata.yml", yaml);
  }

  std::mt19937 random_;
  Download download_;
};

class RandomDownloads : public Submissions {};

TEST_F(RandomDownloads, LoseNobodyAndNoFile) {
  const char* asked = std::getenv("HAIR_RANDOM_DOWNLOADS");
  const unsigned count = asked ? static_cast<unsigned>(std::atoi(asked)) : 400;
  std::map<std::string, int> of_system;
  for (unsigned seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Download download = Generator(seed).make();
    ++of_system[download.system];
    fs::path argument;
    if (seed % 4 == 0) {
      argument = dir_ / std::to_string(seed);
      for (const auto& [path, text] : download.files) write(std::to_string(seed) + "/" + path, text);
    } else {
      ArchiveBuilder builder(seed % 4 == 1 ? Packing::tar_gz : Packing::zip);
      for (const auto& [path, text] : download.files) builder.file(path, text);
      argument = write("download.zip", builder.bytes());
    }
    const Intake intake = take({argument});
    ASSERT_EQ(intake.submissions.size(), download.students.size())
        << testing::PrintToString(names(intake.submissions));
    EXPECT_EQ(intake.accounted.size(), download.files.size());
    EXPECT_EQ(intake.notices.size(),
              static_cast<std::size_t>(std::ranges::count(download.students, "", &Student::newest)))
        << "a line for each hand-in without a file, and no other: " << testing::PrintToString(intake.notices);
    std::map<std::string, const Submission*> by_id;
    for (const Submission& one : intake.submissions) by_id[one.owner.id] = &one;
    for (const Student& student : download.students) {
      SCOPED_TRACE(student.id);
      ASSERT_TRUE(by_id.contains(student.id)) << testing::PrintToString(names(intake.submissions));
      const Submission& one = *by_id.at(student.id);
      EXPECT_EQ(one.system, download.system);
      if (student.newest.empty()) {
        EXPECT_TRUE(says(one.problem, "None of the exercise files"));
        EXPECT_EQ(student.has_files, one.problem.find("It holds") != std::string::npos) << one.problem;
      } else {
        ASSERT_TRUE(one.files.contains("conj_grad.cpp")) << one.problem;
        EXPECT_EQ(one.files.at("conj_grad.cpp").text, student.newest);
      }
    }
    for (const Accounted& file : intake.accounted)
      EXPECT_TRUE(file.as == Accounted::As::made || !file.whose.empty()) << file.path;
    fs::remove_all(argument);
    if (HasFailure()) break;
  }
  EXPECT_GE(of_system.size(), std::min<std::size_t>(7, count / 20)) << "all systems were tried";
}

}  // namespace
}  // namespace grader::intake
