// STAFF ONLY. Tests that copies with other names, layout and order are found, and independent solutions are
// not; given code counts nowhere; common pieces and files that were not compared are reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/similar/shared_code.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader::inline similar {
namespace {

namespace fs = std::filesystem;
using tests::says;

const fs::path kProject = HAIR_PROJECT;

const Course& course() {
  static const Course all = read_course(kProject / "handout/exercises.json");
  return all;
}

std::string stub_of(const std::string& file) {
  return hair::bytes_of(kProject /
                        unwritten_file_of(*std::ranges::find(course().exercises, file, &Exercise::file)));
}

// Lists right solutions that differ, by exercise file: the reference and the samples'.
std::map<std::string, std::vector<SimilarFile>> honest_files() {
  std::map<std::string, std::vector<SimilarFile>> files;
  for (const Exercise& exercise : course().exercises) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(kProject / "reference" / exercise.id / "right"))
      paths.push_back(entry.path());
    std::ranges::sort(paths);
    files[exercise.file] = {{"reference", hair::bytes_of(kProject / solution_of(exercise))}};
    for (const fs::path& path : paths)
      files[exercise.file].push_back({path.stem().string(), hair::bytes_of(path)});
  }
  return files;
}

// Acts like a copyist: it changes every name that is not the language's, removes all comments and directives,
// and breaks lines in other places.
std::string renamed_and_laid_out(std::string text) {
  static const std::set<std::string> kept{"int",  "float",  "double", "const", "for",       "if",
                                          "else", "return", "while",  "void",  "namespace", "std",
                                          "auto", "static", "struct", "bool"};
  for (const auto& [what, by] : {std::pair("//[^\n]*|#[^\n]*", ""), {"\n", " "}, {";", ";\n  "}})
    text = std::regex_replace(text, std::regex(what), by);
  std::map<std::string, std::string> names;
  std::string out;
  static const std::regex kWord("[A-Za-z_][A-Za-z_0-9]*");
  auto at = text.cbegin();
  for (std::sregex_iterator word(text.begin(), text.end(), kWord), end; word != end; ++word) {
    out.append(at, text.cbegin() + word->position());
    at = text.cbegin() + word->position() + word->length();
    const std::string name = word->str();
    out += kept.contains(name) ? name
                               : names.try_emplace(name, "v" + std::to_string(names.size())).first->second;
  }
  return out.append(at, text.cend());
}

// Reverses functions and other pieces at the outermost level.
std::string in_another_order(const std::string& text) {
  std::vector<std::string> pieces(1);
  int depth = 0;
  for (const char c : text) {
    pieces.back() += c;
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (depth <= 1 && c == '}') pieces.emplace_back();
  }
  std::string out;
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) out += *piece + "\n";
  return out;
}

class Similar : public testing::Test {
 protected:
  Sim sim_{isolation_for_tests()};
};

bool are_a_pair(const SharedCode& shared, const std::vector<SimilarFile>& files, const std::string& one,
                const std::string& other) {
  return std::ranges::any_of(shared.pairs, [&](const SharedPair& pair) {
    const std::set<std::string> names{files[pair.one].name, files[pair.other].name};
    return names == std::set<std::string>{one, other};
  });
}

// Adds ten copies to all honest files. Samples that began as one text are reported, too, since they are
// copies. Honest pairs of two files are accused, whose functions are short and dictated by the contract: the
// four integrators, and implicit Euler.
TEST_F(Similar, FindsTenCopiesAmongHonestFiles) {
  const std::set<std::string> dictated{"explicit_integrators.cpp", "implicit_euler.cpp"};
  const std::set<std::set<std::string>> began_as_one{{"expanded", "plain"}};
  const std::set<std::set<std::string>> accused_wrongly{{"plain", "reference"}, {"expanded", "reference"}};
  std::map<std::string, std::vector<SimilarFile>> honest = honest_files();
  std::size_t files = 0, planted = 0, found = 0;
  for (auto& [file, all] : honest) {
    files += all.size();
    const std::string victim = all.back().name;
    const std::size_t honest_ones = all.size();
    if (planted < 10) {
      const std::string copy = renamed_and_laid_out(all.back().text);
      all.push_back({"copyist", planted % 2 == 0 ? copy : in_another_order(copy)});
      ++planted;
    }
    const SharedCode shared = shared_code(sim_, all, {stub_of(file)});
    if (all.size() > honest_ones) {
      const bool is_found = are_a_pair(shared, all, "copyist", victim);
      found += is_found;
      EXPECT_TRUE(is_found) << file << ": " << victim;
    }
    for (const SharedPair& pair : shared.pairs) {
      const std::set<std::string> names{all[pair.one].name, all[pair.other].name};
      if (names.contains("copyist")) continue;
      RecordProperty((file + " " + all[pair.one].name + " " + all[pair.other].name).c_str(),
                     std::to_string(pair.part));
      EXPECT_TRUE(began_as_one.contains(names) ||
                  (dictated.contains(file) && accused_wrongly.contains(names)))
          << file << ": " << all[pair.one].name << " " << all[pair.other].name << " " << pair.part;
    }
  }
  EXPECT_EQ(honest.size(), 14U);
  EXPECT_GE(files, 3 * honest.size()) << "three right programs an exercise";
  EXPECT_EQ(planted, 10U);
  EXPECT_EQ(found, 10U);
}

// A template that students edit matches again, and in the denominator it would keep identical work below 100
// %.
TEST_F(Similar, TakesOffWhatWasGiven) {
  const std::string stub = stub_of("conj_grad.cpp"), work = honest_files()["conj_grad.cpp"].front().text;
  const std::vector<SimilarFile> files{{"a", stub + work}, {"b", work + stub}, {"c", stub}, {"d", stub}};
  const SharedCode shared = shared_code(sim_, files, {stub});
  ASSERT_EQ(shared.pairs.size(), 1U);
  EXPECT_GT(shared.pairs.front().part, 0.95);
  ASSERT_EQ(shared.not_compared.size(), 2U);
  EXPECT_TRUE(says(shared.not_compared.front().why, "too few"));
  EXPECT_TRUE(shared_code(sim_, files, {work}).pairs.empty());
}

// Six copies are a group, a piece of many, and fifteen pairs.
TEST_F(Similar, TellsWhatManyShare) {
  const std::string work = honest_files()["conj_grad.cpp"].front().text;
  std::vector<SimilarFile> files;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) files.push_back({name, work});
  const SharedCode shared = shared_code(sim_, files, {});
  EXPECT_EQ(shared.pairs.size(), 15U);
  for (const SharedPair& pair : shared.pairs) EXPECT_EQ(pair.of_many, pair.tokens);
  const auto groups = groups_of(shared, files.size());
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups.front().size(), 6U);
  ASSERT_FALSE(shared.common.empty());
  EXPECT_EQ(shared.common.front().owners.size(), 6U);
}

// sim's time grows with the square of tokens that repeat themselves and of quotes that never end: these would
// take hours.
TEST_F(Similar, HostileFilesStopNobodyElse) {
  const std::string work = honest_files()["conj_grad.cpp"].front().text,
                    line = "double f(int a, int b, int c, int d) { return a + b + c + d; }";
  const auto times = [](std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string quotes = "\"" + times(500000, "\\\"");
  const std::map<std::string, std::string> hostile{
      {"bytes", std::string("\0\xff\xfe\"'/*", 7)},
      {"open", "/* \" ' R\"(" + times(100000, "(")},
      {"many tokens", times(100000, "a+b;")},
      {"few tokens that repeat themselves", times(10000, "(")},
      {"backslashes", "\"" + times(1 << 20, "\\")},
      {"quotes", quotes},
      {"quotes where what is given was blanked", line + " /*\n" + quotes + "\n*/\n" + work},
      {"empty", ""}};
  std::vector<SimilarFile> files{{"a", work}, {"b", work}};
  std::set<std::string> names;
  for (const auto& [name, text] : hostile) {
    files.push_back({name, text});
    names.insert(name);
  }
  const SharedCode shared = shared_code(sim_, files, {line});
  EXPECT_TRUE(are_a_pair(shared, files, "a", "b"));
  std::set<std::string> left_out;
  for (const NotCompared& one : shared.not_compared) left_out.insert(files[one.file].name);
  EXPECT_EQ(left_out, names);
}

// A text that repeats itself takes sim hours with another one that repeats the same.
TEST_F(Similar, FilesThatRepeatThemselvesStopNobodyElse) {
  const std::string work = honest_files()["conj_grad.cpp"].front().text;
  std::string repeats;
  for (int i = 0; i < 4000; ++i) repeats += "x\n";
  const std::vector<SimilarFile> files{{"a", work}, {"c", repeats}, {"b", work}, {"d", repeats + "x\n"}};
  const SharedCode shared = shared_code(sim_, files, {}, {.cpu_seconds = 30});
  EXPECT_TRUE(are_a_pair(shared, files, "a", "b"));
  std::vector<std::string> left_out;
  for (const NotCompared& one : shared.not_compared) left_out.push_back(files[one.file].name);
  EXPECT_EQ(left_out, (std::vector<std::string>{"c", "d"}));
}

// Last year's copies of each other are not reported. A padded copy is found in either direction.
TEST_F(Similar, EarlierYearsAreComparedWithThisOneAlone) {
  const std::map<std::string, std::vector<SimilarFile>> honest = honest_files();
  const std::string work = honest.at("conj_grad.cpp").front().text,
                    padding = honest.at("super_helix.cpp").front().text;
  const std::vector<SimilarFile> files{{.name = "last", .text = work, .earlier = true},
                                       {.name = "last again", .text = work, .earlier = true},
                                       {.name = "padded", .text = padding + work},
                                       {.name = "other", .text = honest.at("constraint_forces.cpp")[0].text},
                                       {.name = "part", .text = padding, .earlier = true}};
  const SharedCode shared = shared_code(sim_, files, {});
  std::set<std::string> pairs;
  for (const SharedPair& pair : shared.pairs)
    pairs.insert(files[pair.one].name + " in " + files[pair.other].name);
  EXPECT_EQ(pairs, (std::set<std::string>{"last in padded", "last again in padded", "part in padded"}));
  EXPECT_TRUE(shared_code(sim_, {files[0], files[1]}, {}).pairs.empty());
}

}  // namespace
}  // namespace grader::similar
