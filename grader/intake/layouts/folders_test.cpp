// STAFF ONLY. Tests which folders and archives are one submission and which are a class.
#include "grader/intake/layouts/folders.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace grader::inline intake {
namespace {

const FileNames files{"conj_grad.cpp", "normal_equations.cpp"};

// Returns the submissions in a container with these paths (folders end with '/'), and its strays with "? "
// before them; "one" if it is a submission itself, "nothing" if it is neither.
std::vector<std::string> members(const std::vector<std::string>& paths, bool on_disk = false) {
  std::vector<Entry> entries;
  for (const std::string& path : paths) {
    entries.push_back(entry_at(path));
    if (path.back() == '/') entries.back().kind = Entry::Kind::folder;
  }
  const Layout layout = layout_of(entries, files, on_disk);
  if (!layout.found) return {"nothing"};
  if (!layout.is_class) return {"one"};
  std::vector<std::string> names;
  for (const Member& member : layout.members) names.push_back(member.path);
  for (const std::string& stray : layout.strays) names.push_back("? " + stray);
  return names;
}

using Names = std::vector<std::string>;

TEST(Layout, IsOneSubmissionOrAClassWithStrays) {
  const Names one{"one"}, nothing{"nothing"};
  const struct {
    const char* what;
    Names paths, expected;
    bool on_disk = false;
  } rows[] = {
      {"archives", {"bob.tar.gz", "alice.zip"}, {"alice.zip", "bob.tar.gz"}},
      {"archives", {"class/bob.tgz", "class/alice.zip", "class/"}, {"class/alice.zip", "class/bob.tgz"}},
      {"folders, also those that hold nothing",
       {"alice/conj_grad.cpp", "bob/src/conj_grad.cpp", "carol/", "dave/main.cpp", "README.txt"},
       {"alice", "bob", "carol", "dave", "? README.txt"}},
      {"folders and archives",
       {"alice/conj_grad.cpp", "bob.zip", "carol/handin.zip"},
       {"alice", "bob.zip", "carol"}},
      {"folders around everything",
       {"README", "a/b/alice/conj_grad.cpp", "a/b/bob/handin.zip", "a/b/carol/"},
       {"a/b/alice", "a/b/bob", "a/b/carol", "? README"}},
      {"an exercise file at the root", {"conj_grad.cpp"}, one},
      {"an exercise file at the root", {"x/conj_grad.cpp", "x/old/conj_grad.cpp", "x/notes/"}, one},
      {"an exercise file at the root", {"conj_grad.cpp", "handin.zip"}, one},
      {"an exercise file at the root", {"conj_grad.cpp", "handin.zip"}, one, true},
      {"a build is no person", {"hw/student/conj_grad.cpp", "hw/build/handin.zip"}, one},
      {"a build is no person",
       {"student/conj_grad.cpp", "cmake-build-debug/conj_grad.cpp", "build-1/handin.zip"},
       one},
      {"a build is no person", {"alice/conj_grad.cpp", "buildsmith/conj_grad.cpp"}, {"alice", "buildsmith"}},
      {"files beside a class",
       {"alice.zip", "bob.zip", "conj_grad.cpp"},
       {"alice.zip", "bob.zip", "? conj_grad.cpp"}},
      {"files beside a class",
       {"alice/conj_grad.cpp", "bob/conj_grad.cpp", "CMakeLists.txt"},
       {"alice", "bob", "? CMakeLists.txt"}},
      {"files beside a class",
       {"c/alice.zip", "c/bob.zip", "c/CMakeLists.txt", "CMakeLists.txt"},
       {"c/alice.zip", "c/bob.zip", "? CMakeLists.txt", "? c/CMakeLists.txt"}},
      {"one student's old copies look like it, too",
       {"conj_grad.cpp", "old/conj_grad.cpp", "older/conj_grad.cpp"},
       {"old", "older", "? conj_grad.cpp"}},
      {"outside of the root",
       {"c/d/alice.zip", "c/d/bob.zip", "c/carol/main.cpp", "c/carol/x/y.cpp", "notes.txt"},
       {"c/d/alice.zip", "c/d/bob.zip", "? c/carol", "? notes.txt"}},
      {"documents in a class",
       {"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "README.txt"},
       {"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "? README.txt"}},
      {"documents in a class", {"alice.zip", "carol.pdf"}, {"alice.zip", "carol.pdf"}, true},
      {"a document of one", {"handin.zip", "report.pdf"}, one},
      {"a document of one", {"conj_grad.cpp", "report.pdf"}, one, true},
      {"a project", {"CMakeLists.txt", "student/conj_grad.cpp", "build/handin.tar.gz", "solver/x.h"}, one},
      {"a project", {"p/CMakeLists.txt", "p/student/conj_grad.cpp", "p/old/conj_grad.cpp"}, one},
      {"a project",
       {"p/CMakeLists.txt", "p/student/1/conj_grad.cpp", "p/student/2/normal_equations.cpp"},
       one},
      {"a project", {"CMakeLists.txt", "hair/", "a.zip", "b.zip"}, one},
      {"a project", {"student/conj_grad.cpp", "solver/x.h", "build/a.o"}, one},
      {"a project",
       {"conj_grad.cpp", "CMakeLists.txt", "particles/x.h", "old/conj_grad.cpp", "v2/conj_grad.cpp"},
       one},
      {"no folder of the handout",
       {"CMakeLists.txt", "src/conj_grad.cpp", "lib/conj_grad.cpp", "hairy/x"},
       {"hairy", "lib", "src", "? CMakeLists.txt"}},
      {"a file is no folder",
       {"CMakeLists.txt", "solver", "a.zip", "b.zip"},
       {"a.zip", "b.zip", "? CMakeLists.txt", "? solver"}},
      {"one student's project beside others' archives",
       {"x/CMakeLists.txt", "x/solver/y.h", "a.zip", "b.zip"},
       {"a.zip", "b.zip", "x"}},
      {"projects of a class",
       {"alice/CMakeLists.txt", "alice/student/conj_grad.cpp", "bob/CMakeLists.txt",
        "bob/student/conj_grad.cpp"},
       {"alice", "bob"}},
      {"an archive alone in an archive", {"handin.tar.gz"}, one},
      {"an archive alone in an archive", {"x/handin.tar.gz", "x/notes/"}, one},
      {"an archive alone on disk", {"alice.zip"}, {"alice.zip"}, true},
      {"an archive alone on disk", {"alice/handin.zip"}, one, true},
      {"hidden", {".git/conj_grad.cpp", "a/.cache/x.zip", "__MACOSX/alice/conj_grad.cpp"}, nothing},
      {"hidden",
       {"x/student/conj_grad.cpp", "__MACOSX/x/student/conj_grad.cpp", "x/.old/conj_grad.cpp"},
       one},
      {"hidden",
       {"alice.zip", "bob.zip", "._alice.zip", ".hidden/", ".DS_Store", "Thumbs.db", "desktop.ini"},
       {"alice.zip", "bob.zip"}},
      {"nothing", {"main.cpp", "notes/"}, nothing},
  };
  for (const auto& [what, paths, expected, on_disk] : rows)
    EXPECT_EQ(members(paths, on_disk), expected) << what << ": " << testing::PrintToString(paths);
}

TEST(EntryPath, IsCleanedAndWhatLeadsOutsideIsNoted) {
  EXPECT_EQ(entry_at("./a//b/conj_grad.cpp").path, "a/b/conj_grad.cpp");
  EXPECT_FALSE(entry_at("./a//b/conj_grad.cpp").leads_outside);
  EXPECT_EQ(entry_at("a\\b\\conj_grad.cpp").path, "a/b/conj_grad.cpp");
  for (const char* path : {"a/../x", "a\\..\\x", "a/../../../x"}) {
    EXPECT_TRUE(entry_at(path).leads_outside) << path;
    EXPECT_EQ(name_of(entry_at(path)), "x") << path;
  }
  EXPECT_FALSE(entry_at("a/..x").leads_outside);
}

TEST(EntryPath, LosesItsRoot) {
  for (const char* path :
       {"/bob/x", "\\bob\\x", "C:\\bob\\x", "C:\\Users\\bob\\x", "/home/bob/x", "../../bob/x"}) {
    EXPECT_TRUE(entry_at(path).lost_root) << path;
    EXPECT_FALSE(entry_at(path).leads_outside) << path;
    EXPECT_EQ(entry_at(path).path, "bob/x") << path;
  }
  EXPECT_EQ(entry_at("Users/bob/x").path, "Users/bob/x");
}

}  // namespace
}  // namespace grader::intake
