// STAFF ONLY. Tests random classes, each followed by a later download of it, and by archives of one student
// that look like one.
#include <functional>

#include "grader/class_folder/blind.h"
#include "grader/class_folder/origins.h"
#include "grader/class_folder/rows.h"
#include "grader/grading/grading.h"
#include "grader/intake/question.h"
#include "grader/intake/random_downloads.h"
#include "grader/record/record.h"

namespace grader::inline class_folder {
namespace {

class LaterDownloads : public Submissions {
 protected:
  std::vector<Submission> taken(const Download& download, const std::string& name) const {
    ArchiveBuilder builder(Packing::zip);
    for (const auto& [path, text] : download.files) builder.file(path, text);
    return take({write(name, builder.bytes())}).submissions;
  }
  // Does as `grade`, without grading.
  std::vector<Submission> first_download(Generator& generator) const {
    fs::remove(dir_ / kRecordFile);
    std::vector<Submission> submissions = taken(generator.make(), "first.zip");
    Record record(dir_);
    record.put_people(hand_ins_of(submissions));
    for (const Submission& one : submissions) {
      SubmissionResult result;
      result.name = one.name;
      result.origin = one.origin;
      record.put({result}, {.files = hash_of_files(one)});
    }
    return submissions;
  }
};

TEST_F(LaterDownloads, AskNothingAndNameWhoIsMissing) {
  std::size_t anew = 0, newcomers = 0, missing = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Generator generator(seed);
    const std::vector<Submission> first = first_download(generator);
    std::vector<Submission> later = taken(generator.later(), "later.zip");
    std::vector<Accounted> none;
    std::optional<std::string> all;
    {
      Record record(dir_);
      keep_rows(later, none, record, all);
    }
    const Settled settled = settle_origins(dir_, later, all, {});
    std::map<std::string, std::string> files;
    for (const Submission& one : first) files[one.name] = hash_of_files(one);
    for (const Submission& one : later) {
      EXPECT_EQ(one.origin, first[0].origin) << "its rows are of one class";
      const auto before = files.find(one.name);
      newcomers += before == files.end() ? 1U : 0U;
      anew += before != files.end() && before->second != hash_of_files(one) ? 1U : 0U;
      files.erase(one.name);
    }
    missing += files.size();
    ASSERT_EQ(settled.missing.size(), files.empty() ? 0U : 1U);
    for (const auto& [name, hash] : files) EXPECT_TRUE(says(settled.missing[0], name));
  }
  EXPECT_GE(std::min({anew, newcomers, missing}), 10U) << "all of it was tried";
}

void forge(Submission& one) {
  one.files["conj_grad.cpp"].text = "int wrong;\n";
  one.problem.clear();
}

// Mallory is the first student, and knows the names and numbers of all.
struct Attack {
  const char* what;
  std::function<void(std::vector<Submission>&)> change;
};
const std::vector<Attack> kAttacks{
    {"all others' are replaced", [](auto& all) { std::for_each(all.begin() + 1, all.end(), forge); }},
    {"all others' are taken away",
     [](auto& all) {
       std::for_each(all.begin() + 1, all.end(), [](Submission& one) { one.files.clear(); });
     }},
    {"one victim",
     [](auto& all) {
       all.erase(all.begin() + 2, all.end());
       forge(all[1]);
     }},
    {"two accomplices", [](auto& all) { std::for_each(all.begin() + 3, all.end(), forge); }},
    {"two accomplices, one victim, nobody else",
     [](auto& all) {
       all.erase(all.begin() + 4, all.end());
       forge(all[3]);
     }},
    {"somebody absent beside two accomplices",
     [](auto& all) {
       all.erase(all.begin() + 4, all.end());
       all[3].name = "absent";
     }},
    {"nobody of the class",
     [](auto& all) {
       for (Submission& one : all) one.name += "-again";
     }},
};

TEST_F(LaterDownloads, ArchivesOfOneStudentAreNone) {
  int tried = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    Generator generator(seed);
    std::vector<Submission> first = first_download(generator);
    std::erase_if(first, [](const Submission& one) { return one.files.empty(); });
    if (first.size() < 6) continue;
    for (const Attack& attack : kAttacks) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + attack.what);
      std::vector<Submission> late = first;
      for (Submission& one : late) one.origin = "class of a learning system /late/hw5.zip";
      attack.change(late);
      try {
        settle_origins(dir_, late, {}, {});
        ADD_FAILURE() << "asks nothing";
      } catch (const Question& question) {
        EXPECT_TRUE(says(question.what(), late.back().name));
        EXPECT_EQ(question.option, kSaysClass);
      }
      ++tried;
    }
  }
  EXPECT_GE(tried, 50);
}

}  // namespace
}  // namespace grader::class_folder
