// STAFF ONLY. Makes random downloads of all learning systems, and later ones of the same class. The generator
// follows the systems' own sources and uses nothing of intake.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {

struct Student {
  std::string name, number, id;
  unsigned draws;           // holds all random choices for the hand-in
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
    download_.root = chance(3) ? "wrapped/" : "";
    system_ = below(8);
    draws_ = static_cast<unsigned>(random_());
    const int count = below(9) + 2;
    for (int i = 0; i < count; ++i) join(i);
    return written();
  }

  // Some people are new; less than half of those with a file have handed in again or left.
  Download later() {
    std::vector<Student>& students = download_.students;
    const auto with = std::ranges::count_if(students, [](const Student& one) { return !one.newest.empty(); });
    const int left_before = static_cast<int>(students.size());
    std::ranges::shuffle(students, random_);
    for (int i = below(std::max(1, static_cast<int>(with + 1) / 2)); i > 0; --i)
      if (chance(2))
        students.pop_back();
      else
        students[static_cast<std::size_t>(i)].draws = static_cast<unsigned>(random_());
    for (int i = with < 2 ? 0 : below(3); i > 0; --i) join(left_before + i);
    return written();
  }

 private:
  void join(int i) {
    const std::string number = std::to_string(4000 + 7 * i);
    download_.students.push_back({any_name(i), number, number, static_cast<unsigned>(random_())});
  }
  Download written() {
    static const std::vector<void (Generator::*)()> all{
        &Generator::canvas,     &Generator::moodle,  &Generator::moodle_flat, &Generator::brightspace,
        &Generator::blackboard, &Generator::autolab, &Generator::classroom,   &Generator::gradescope};
    const std::mt19937 others = std::exchange(random_, std::mt19937(draws_));
    download_.files.clear();
    (this->*all.at(static_cast<std::size_t>(system_)))();
    random_ = others;
    return download_;
  }
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
    return one.id + " of attempt " + std::to_string(attempt) + " " + std::to_string(one.draws);
  }
  // A student without a new hand-in has the same files in each download.
  template <class HandIn>
  void each(const HandIn& hand_in) {
    for (Student& one : download_.students) {
      random_.seed(one.draws);
      one.newest.clear();
      one.has_files = false;
      hand_in(one);
    }
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
    each([&](Student& one) {
      const std::string stem = squeezed(one.name) + (chance(4) ? "_LATE_" : "_") + one.id + "_";
      if (chance(6)) {
        add(stem + (chance(2) ? "text.html" : "link.html"), "<p>");
        return;
      }
      attempt(one, 1, [&](const std::string& name) { return stem + std::to_string(file++) + "_" + name; });
    });
  }
  static std::string clean(const std::string& name) {  // as Moodle's clean_filename: no apostrophes
    std::string text;
    for (const char c : name)
      if (c != '\'') text += c;
    return text;
  }
  void moodle() {
    download_.system = "moodle";
    const char* end = chance(2) ? "_" : "";
    each([&](Student& one) {
      const std::string stem = clean(one.name) + "_" + one.id + "_assignsubmission_";
      if (chance(3))
        add(stem + "onlinetext" + end + "/onlinetext.html", "<p>");
      else
        attempt(one, 1, [&](const std::string& name) {
          return stem + "file" + end + (chance(4) ? "/src/" : "/") + name;
        });
    });
  }
  void moodle_flat() {
    download_.system = "moodle";
    each([&](Student& one) {
      attempt(one, 1, [&](const std::string& name) {
        return clean(one.name) + "_" + one.id + "_assignsubmission_file_" + name;
      });
    });
  }
  void brightspace() {
    download_.system = "brightspace";
    const bool flat = chance(2);
    add("index.html", "<html>");
    each([&](Student& one) {
      for (int number = 1; number <= 1 + below(3); ++number) {
        const std::string stem = one.id + "-99 - " + one.name + " - May " + std::to_string(number + 8) +
                                 ", 2025 1" + std::to_string(below(3)) + "24 PM";
        attempt(one, number, [&](const std::string& name) { return stem + (flat ? " - " : "/") + name; });
      }
    });
  }
  void blackboard() {
    download_.system = "blackboard";
    each([&](Student& one) {
      one.id = "user" + one.number;
      for (int number = 1; number <= 1 + below(3); ++number) {
        const std::string stem =
            "Lab_3 b_" + one.id + "_attempt_2025-03-0" + std::to_string(number) + "-10-15-22";
        add(stem + ".txt", "Name");
        attempt(one, number, [&](const std::string& name) { return stem + "_" + name; });
      }
    });
  }
  void autolab() {
    download_.system = "autolab";
    each([&](Student& one) {
      one.id = "u_" + one.number + "@u.de";
      const int last = 1 + below(12);
      for (int number = 1; number <= last; ++number) {
        one.newest = text_of(one, number);
        one.has_files = true;
        add(one.id + "_" + std::to_string(number) + "_conj_grad.cpp", one.newest);
      }
    });
  }
  void classroom() {
    download_.system = "classroom";
    download_.root = "lab3-submissions/";
    each([&](Student& one) {
      one.id = "login-" + one.number;
      attempt(one, 1, [&](const std::string& name) { return "lab3-" + one.id + "/" + name; });
    });
  }
  void gradescope() {
    download_.system = "gradescope";
    std::string yaml = "---\n";
    each([&](Student& one) {
      const std::string folder = "submission_" + std::to_string(below(1000000)) + one.id;
      yaml += folder + ":\n  :submitters:\n  - :name: \"" + one.name + "\"\n    :sid: '" + one.id +
              "'\n    :email: x@u.de\n  :created_at: 2025-03-04 10:15:22 Z\n";
      attempt(one, 1, [&](const std::string& name) { return folder + "/" + name; });
    });
    add("submission_metadata.yml", yaml);
  }

  std::mt19937 random_;
  int system_ = 0;
  unsigned draws_ = 0;  // are random choices for the download, except its hand-ins
  Download download_;
};

}  // namespace grader::intake
