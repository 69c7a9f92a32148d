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

TEST(Layout, ArchivesAreAClass) {
  EXPECT_EQ(members({"bob.tar.gz", "alice.zip"}), (Names{"alice.zip", "bob.tar.gz"}));
  EXPECT_EQ(members({"class/bob.tgz", "class/alice.zip", "class/"}),
            (Names{"class/alice.zip", "class/bob.tgz"}));
}

TEST(Layout, FoldersAreAClassWithThoseThatHoldNothing) {
  EXPECT_EQ(
      members({"alice/conj_grad.cpp", "bob/src/conj_grad.cpp", "carol/", "dave/main.cpp", "README.txt"}),
      (Names{"alice", "bob", "carol", "dave", "? README.txt"}));
}

TEST(Layout, FoldersAndArchivesMix) {
  EXPECT_EQ(members({"alice/conj_grad.cpp", "bob.zip", "carol/handin.zip"}),
            (Names{"alice", "bob.zip", "carol"}));
}

TEST(Layout, FoldersAroundEverythingChangeNothing) {
  const Names paths{"alice/conj_grad.cpp", "bob/handin.zip", "carol/"};
  Names wrapped{"README"};
  for (const std::string& path : paths) wrapped.push_back("a/b/" + path);
  EXPECT_EQ(members(wrapped), (Names{"a/b/alice", "a/b/bob", "a/b/carol", "? README"}));
}

TEST(Layout, AnExerciseFileAtTheRootMakesOneSubmissionWithAtMostOneFolderOrArchive) {
  EXPECT_EQ(members({"conj_grad.cpp"}), Names{"one"});
  EXPECT_EQ(members({"x/conj_grad.cpp", "x/old/conj_grad.cpp", "x/notes/"}), Names{"one"});
  EXPECT_EQ(members({"conj_grad.cpp", "handin.zip"}), Names{"one"});
  EXPECT_EQ(members({"conj_grad.cpp", "handin.zip"}, true), Names{"one"});
}

TEST(Layout, ABuildIsNoPerson) {
  EXPECT_EQ(members({"hw/student/conj_grad.cpp", "hw/build/handin.zip"}), Names{"one"});
  EXPECT_EQ(members({"student/conj_grad.cpp", "cmake-build-debug/conj_grad.cpp", "build-1/handin.zip"}),
            Names{"one"});
  EXPECT_EQ(members({"alice/conj_grad.cpp", "buildsmith/conj_grad.cpp"}), (Names{"alice", "buildsmith"}));
}

TEST(Layout, BareFilesBesideAClassAreStrays) {
  EXPECT_EQ(members({"alice.zip", "bob.zip", "conj_grad.cpp"}),
            (Names{"alice.zip", "bob.zip", "? conj_grad.cpp"}));
  EXPECT_EQ(members({"alice/conj_grad.cpp", "bob/conj_grad.cpp", "CMakeLists.txt"}),
            (Names{"alice", "bob", "? CMakeLists.txt"}));
  EXPECT_EQ(members({"c/alice.zip", "c/bob.zip", "c/CMakeLists.txt", "CMakeLists.txt"}),
            (Names{"c/alice.zip", "c/bob.zip", "? CMakeLists.txt", "? c/CMakeLists.txt"}));
  // One student's old copies look like this, too.
  EXPECT_EQ(members({"conj_grad.cpp", "old/conj_grad.cpp", "older/conj_grad.cpp"}),
            (Names{"old", "older", "? conj_grad.cpp"}));
}

TEST(Layout, WhatLiesOutsideOfTheRootIsAStray) {
  EXPECT_EQ(members({"c/d/alice.zip", "c/d/bob.zip", "c/carol/main.cpp", "c/carol/x/y.cpp", "notes.txt"}),
            (Names{"c/d/alice.zip", "c/d/bob.zip", "? c/carol", "? notes.txt"}));
}

TEST(Layout, DocumentsInAClassAreSubmissions) {
  EXPECT_EQ(members({"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "README.txt"}),
            (Names{"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "? README.txt"}));
  EXPECT_EQ(members({"alice.zip", "carol.pdf"}, true), (Names{"alice.zip", "carol.pdf"}));
  EXPECT_EQ(members({"handin.zip", "report.pdf"}), Names{"one"});
  EXPECT_EQ(members({"conj_grad.cpp", "report.pdf"}, true), Names{"one"});
}

TEST(Layout, AProjectIsOneSubmission) {
  EXPECT_EQ(members({"CMakeLists.txt", "student/conj_grad.cpp", "build/handin.tar.gz", "solver/x.h"}),
            Names{"one"});
  EXPECT_EQ(members({"p/CMakeLists.txt", "p/student/conj_grad.cpp", "p/old/conj_grad.cpp"}), Names{"one"});
  EXPECT_EQ(members({"p/CMakeLists.txt", "p/student/1/conj_grad.cpp", "p/student/2/normal_equations.cpp"}),
            Names{"one"});
  EXPECT_EQ(members({"CMakeLists.txt", "hair/", "a.zip", "b.zip"}), Names{"one"});
  EXPECT_EQ(members({"student/conj_grad.cpp", "solver/x.h", "build/a.o"}), Names{"one"});
  EXPECT_EQ(
      members({"conj_grad.cpp", "CMakeLists.txt", "particles/x.h", "old/conj_grad.cpp", "v2/conj_grad.cpp"}),
      Names{"one"});
}

TEST(Layout, AProjectNeedsAFolderOfTheHandout) {
  EXPECT_EQ(members({"CMakeLists.txt", "src/conj_grad.cpp", "lib/conj_grad.cpp", "hairy/x"}),
            (Names{"hairy", "lib", "src", "? CMakeLists.txt"}));
  EXPECT_EQ(members({"CMakeLists.txt", "solver", "a.zip", "b.zip"}),
            (Names{"a.zip", "b.zip", "? CMakeLists.txt", "? solver"}))
      << "a file is no folder";
  EXPECT_EQ(members({"x/CMakeLists.txt", "x/solver/y.h", "a.zip", "b.zip"}), (Names{"a.zip", "b.zip", "x"}))
      << "one student's project beside others' archives";
}

TEST(Layout, ProjectsOfAClassStayApart) {
  EXPECT_EQ(members({"alice/CMakeLists.txt", "alice/student/conj_grad.cpp", "bob/CMakeLists.txt",
                     "bob/student/conj_grad.cpp"}),
            (Names{"alice", "bob"}));
}

TEST(Layout, AnArchiveAloneInAnArchiveIsTheSubmissionItself) {
  EXPECT_EQ(members({"handin.tar.gz"}), Names{"one"});
  EXPECT_EQ(members({"x/handin.tar.gz", "x/notes/"}), Names{"one"});
}

TEST(Layout, AnArchiveAloneInAFolderOnDiskIsAClassOfOne) {
  EXPECT_EQ(members({"alice.zip"}, true), Names{"alice.zip"});
  EXPECT_EQ(members({"alice/handin.zip"}, true), Names{"one"});
}

TEST(Layout, HiddenThingsAndMacResourcesDoNotCount) {
  EXPECT_EQ(members({".git/conj_grad.cpp", "a/.cache/x.zip", "__MACOSX/alice/conj_grad.cpp"}),
            Names{"nothing"});
  EXPECT_EQ(members({"x/student/conj_grad.cpp", "__MACOSX/x/student/conj_grad.cpp", "x/.old/conj_grad.cpp"}),
            Names{"one"});
  EXPECT_EQ(members({"alice.zip", "bob.zip", "._alice.zip", ".hidden/"}), (Names{"alice.zip", "bob.zip"}));
}

TEST(Layout, NothingToLookAtIsSaid) {
  EXPECT_EQ(members({"main.cpp", "notes/"}), Names{"nothing"});
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
