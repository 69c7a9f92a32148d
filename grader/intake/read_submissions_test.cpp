// STAFF ONLY. Tests that hand-ins of every form are read, and that each rejection has a reason.
#include "grader/intake/read_submissions.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <set>

#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {
namespace {

// The answers come with the exercise files, and change nothing else.
TEST_F(Submissions, AnswersOfAStudentComeAlong) {
  const auto with = [&](const char* name, const std::string& text) {
    return only(ArchiveBuilder(Packing::zip).file("p/conj_grad.cpp", "c").file(name, text).bytes());
  };
  EXPECT_EQ(with("p/about.txt", "Hours: 3\r\n").about, "Hours: 3\n");
  EXPECT_EQ(with("about (1).txt", "Hours: 3\n").about, "Hours: 3\n");
  EXPECT_EQ(with("about.txt", std::string("\xff\xfeH\0i\0", 6)).about, "Hi") << "UTF-16";
  EXPECT_EQ(with("about.txt", "a\x1b[31mb").about, "ab");
  for (const char* other : {"about.md", "about-me.txt", "readme.txt"})
    EXPECT_EQ(with(other, "text").about, "");

  const Submission large = with("about.txt", std::string(100000, 'x'));
  EXPECT_EQ(large.about, "");
  EXPECT_EQ(large.problem, "");
  EXPECT_EQ(large.files.at("conj_grad.cpp").text, "c");
  EXPECT_NE(only(zip("about.txt", "Hours: 3")).problem, "") << "alone it is no hand-in";
}

TEST_F(Submissions, AFolderIsASubmissionUnderItsName) {
  write("alice/student/deep/er/conj_grad.cpp", "text");
  write("alice/build/normal_equations.cpp", "more");
  write("alice/CMakeLists.txt", "");
  for (const char* path : {"alice", "alice/", "alice/.", "../alice/build/.."}) {
    fs::current_path(dir_ / (path[0] == '.' ? "alice" : "."));
    EXPECT_EQ(told(read({path})), Names{"alice: conj=text normal=more"}) << path;
  }
  fs::current_path("/");
}

TEST_F(Submissions, AnArchiveOfArchivesAndFoldersIsAClass) {
  const std::string bob = ArchiveBuilder(Packing::tar_gz).file("h/conj_grad.cpp", "b").bytes();
  for (const Packing packing : {Packing::zip, Packing::tar_gz}) {
    const std::string bytes = ArchiveBuilder(packing)
                                  .file("class/alice.zip", zip("conj_grad.cpp", "a"))
                                  .file("class/bob.tar.gz", bob)
                                  .file("class/carol/normal_equations.cpp", "c")
                                  .file("class/dave/handin.tar.gz", bob)
                                  .file("class/erin/main.cpp")
                                  .file("__MACOSX/class/._alice.zip")
                                  .bytes();
    const std::vector<Submission> all = read({write("class.zip", bytes)});
    ASSERT_EQ(told(all),
              (Names{"alice: conj=a", "bob: conj=b", "carol: normal=c", "dave: conj=b", "erin: !"}));
    EXPECT_TRUE(
        says(all[4].problem, "None of the exercise files is in it (conj_grad.cpp, normal_equations.cpp)"));
  }
}

TEST_F(Submissions, AnArchiveInAnArchiveIsOpened) {
  const std::string handin = zip("a/conj_grad.cpp", "text");
  EXPECT_EQ(only(zip("handin.zip", handin)).files.at("conj_grad.cpp").text, "text");
  EXPECT_EQ(only(zip("x.zip", zip("handin.zip", handin))).files.at("conj_grad.cpp").text, "text");
}

// The rules for paths are in names_test.cpp. Between archives only builds, backups and names of copies
// decide.
TEST_F(Submissions, OfFilesOfOneNameARuleTakesOneOrAPersonIsAsked) {
  struct Case {
    std::vector<std::pair<std::string, std::string>>
        files;          // path, content; a .zip has conj_grad.cpp of this content
    std::string taken;  // "": it stays open
    std::string named;  // is in the student's text
  };
  const std::string said = "was taken for conj_grad.cpp, and not ";
  const std::vector<Case> cases = {
      {{{"student/conj_grad.cpp", "1"}, {"Backup/conj_grad.cpp", "2"}},
       "1",
       "alice.zip/student/conj_grad.cpp " + said + "alice.zip/Backup/conj_grad.cpp."},
      {{{"x/Backup/conj_grad.cpp", "2"}, {"x/old/conj_grad.cpp", "3"}, {"x/conj_grad.cpp", "1"}},
       "1",
       "alice.zip/x/conj_grad.cpp " + said + "alice.zip/x/Backup/conj_grad.cpp and 1 more."},
      {{{"Backup.zip", "2"}, {"hw.zip", "1"}}, "1", "alice.zip/hw.zip/conj_grad.cpp " + said},
      {{{"a/conj_grad.cpp", "1"}, {"b/conj_grad.cpp", "1"}}, "1", ""},
      {{{"a/conj_grad.cpp", "1"}, {"b/conj_grad.cpp", "1"}, {"c/conj_grad.cpp", "2"}},
       "",
       "more than one conj_grad.cpp: alice.zip/a/conj_grad.cpp and alice.zip/c/conj_grad.cpp."},
      {{{"1.zip", "1"}, {"2.zip", "2"}},
       "",
       "alice.zip/1.zip/conj_grad.cpp and alice.zip/2.zip/conj_grad.cpp"},
      {{{"Conj_grad.cpp", "1"}, {"CONJ_GRAD.cpp", "2"}},
       "",
       "alice.zip/Conj_grad.cpp and alice.zip/CONJ_GRAD.cpp"},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.files.front().first);
    for (const bool backwards : {false, true}) {
      ArchiveBuilder builder(Packing::zip);
      auto handed_in = one.files;
      if (backwards) std::ranges::reverse(handed_in);
      for (const auto& [path, text] : handed_in)
        builder.file(path, path.ends_with(".zip") ? zip("conj_grad.cpp", text) : text);
      const Intake intake = take({write("only/alice.zip", builder.bytes()).parent_path()});
      const SourceFile& file = intake.submissions.at(0).files.at("conj_grad.cpp");
      EXPECT_EQ(file.text, one.taken);
      EXPECT_EQ(file.problem.empty(), !one.taken.empty());
      EXPECT_EQ(intake.notices.size(), one.taken.empty() ? 1U : 0U);
      EXPECT_EQ(intake.remarks.size(), file.choice.empty() ? 0U : 1U);
      if (backwards) continue;
      EXPECT_TRUE(says(file.problem + file.choice, one.named));
    }
  }
}

TEST_F(Submissions, IdenticalFilesCountOnceAndTheLastEntryOfAPath) {
  for (const Packing packing : {Packing::zip, Packing::tar_gz}) {
    ArchiveBuilder copies(packing), twice(packing);
    for (const char* folder : {"hw", "hw - Copy"})
      copies.file(std::string(folder) + "/student/conj_grad.cpp", "same");
    EXPECT_EQ(told(read({write("h.zip", copies.bytes())})), Names{"h: conj=same"});
    twice.file("conj_grad.cpp", "first").file("b.cpp").file("conj_grad.cpp", "last");
    EXPECT_EQ(told({only(twice.bytes())}), Names{"alice: conj=last"});
  }
}

TEST_F(Submissions, LinksDevicesAndPathsThatLeadOutsideAreNotTakenAndTouchNothing) {
  const std::string secret = write("secret.cpp", "secret").string();
  const struct {
    bool in_a_zip;
    std::function<void(ArchiveBuilder&)> put;
    const char* problem;
  } rows[] = {
      {true, [&](auto& to) { to.symbolic_link("a/conj_grad.cpp", secret); }, "a/conj_grad.cpp is a symbolic"},
      {true, [](auto& to) { to.file("a/../../conj_grad.cpp"); }, "leads out of the archive"},
      {false, [](auto& to) { to.file("x").hard_link("conj_grad.cpp", "x"); }, "is a link to another file"},
      {false, [](auto& to) { to.special("conj_grad.cpp", AE_IFIFO); }, "conj_grad.cpp is not a file"},
      {false, [](auto& to) { to.special("conj_grad.cpp", AE_IFCHR); }, "conj_grad.cpp is not a file"},
      {false, [](auto& to) { to.special("conj_grad.cpp", AE_IFBLK); }, "conj_grad.cpp is not a file"},
      {false, [](auto& to) { to.symbolic_link("\x1b[2J/conj_grad.cpp", "x"); },
       "\\x1b[2J/conj_grad.cpp is a symbolic link"}};
  for (const auto& [in_a_zip, put, problem] : rows)
    for (const Packing packing : {Packing::tar, Packing::tar_gz, Packing::zip}) {
      if (packing == Packing::zip && !in_a_zip) continue;
      ArchiveBuilder builder(packing);
      put(builder);
      const Submission alice = only(builder.file("normal_equations.cpp", "fine").bytes());
      EXPECT_EQ(told({alice}), Names{"alice: conj=! normal=fine"});
      EXPECT_TRUE(says(alice.files.at("conj_grad.cpp").problem, problem));
    }
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(dir_), {}), 3)
      << "only the secret and the archive itself may be there";
}

// No file system has longer names, and more marks take quadratic time (text/letters.h).
TEST_F(Submissions, NamesOverALimitAreRefusedAndTheRestGoesOn) {
  const auto marks = [](std::size_t count) {
    std::string name = "a";
    for (std::size_t i = 0; i < count; ++i) name += "\xcc\x81";
    return name;
  };
  const std::map<std::string, bool> names_refused = {{std::string(255, 'x'), false},
                                                     {std::string(256, 'x'), true},
                                                     {marks(30), false},
                                                     {marks(31), true},
                                                     {marks(1980), true}};
  for (const auto& [name, refused] : names_refused) {
    const std::string bytes = ArchiveBuilder(Packing::tar_gz)
                                  .file("class/alice/conj_grad.cpp")
                                  .file("class/bob/" + name + "/conj_grad.cpp")
                                  .file("class/bob/" + name + "/normal_equations.cpp")
                                  .file("class/" + name)
                                  .bytes();
    const Intake intake = take({write("class.tar.gz", bytes)});
    ASSERT_EQ(names(intake.submissions), (Names{"alice", "bob"}));
    EXPECT_EQ(intake.submissions[1].files.size(), 2U);
    EXPECT_EQ(bool(has_remark(intake, {"is refused: class/bob/name-", " stands for it, as in 2 more"})),
              refused)
        << name;
    EXPECT_EQ(bool(has_notice(intake, {"class/name-", "belongs to nobody"})), refused) << name;
  }
}

TEST_F(Submissions, PathsLoseTheirRootAndTouchNothing) {
  for (const char* path : {"../../conj_grad.cpp", "/tmp/conj_grad.cpp", "C:\\conj_grad.cpp"}) {
    const Intake intake = take({write("only/alice.zip", zip(path, "text")).parent_path()});
    EXPECT_EQ(intake.submissions.at(0).files.at("conj_grad.cpp").text, "text") << path;
    EXPECT_TRUE(has_remark(intake, {"alice.zip: ", "conj_grad.cpp begins at a root, which was left away"}));
    EXPECT_EQ(intake.notices, Names{});
  }
  const std::string bytes = ArchiveBuilder(Packing::zip)
                                .file("/ann/conj_grad.cpp")
                                .file("C:\\Users\\bob\\conj_grad.cpp")
                                .file("../cy/conj_grad.cpp")
                                .bytes();
  EXPECT_EQ(names(read({write("class.zip", bytes)})), (Names{"ann", "bob", "cy"}));
  EXPECT_FALSE(fs::exists("/tmp/conj_grad.cpp"));
}

TEST_F(Submissions, LinksOnDiskAreNotFollowed) {
  write("secret/conj_grad.cpp", "secret");
  write("alice/normal_equations.cpp", "fine");
  fs::create_symlink(dir_ / "secret/conj_grad.cpp", dir_ / "alice/conj_grad.cpp");
  fs::create_directory_symlink(dir_ / "secret", dir_ / "alice/folder");
  const Submission alice = read({dir_ / "alice"}).front();
  EXPECT_TRUE(says(alice.files.at("conj_grad.cpp").problem, "conj_grad.cpp is a symbolic link"));
  EXPECT_EQ(told({alice}), Names{"alice: conj=! normal=fine"});
}

TEST_F(Submissions, APipeOnDiskIsNotWaitedFor) {
  write("alice/normal_equations.cpp", "fine");
  ASSERT_EQ(mkfifo((dir_ / "alice/conj_grad.cpp").c_str(), 0600), 0);
  EXPECT_TRUE(says(read({dir_ / "alice"}).front().files.at("conj_grad.cpp").problem, "is not a file"));
}

// Root reads everything: while this lives, the test is another user.
class AsNobody {
 public:
  explicit AsNobody(const fs::path& dir) : was_root_(geteuid() == 0) {
    fs::permissions(dir, fs::perms::all);
    if (was_root_ && seteuid(65534) != 0) throw std::runtime_error("seteuid");
  }
  ~AsNobody() {
    if (was_root_ && seteuid(0) != 0) std::abort();
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool was_root_;
};

TEST_F(Submissions, WhatCanNotBeReadIsSaid) {
  const AsNobody nobody(dir_);
  write("class/alice/conj_grad.cpp", "");
  write("class/bob/conj_grad.cpp", "");
  write("class/carol.zip", zip("conj_grad.cpp"));
  fs::permissions(dir_ / "class/alice/conj_grad.cpp", fs::perms::none);
  fs::permissions(dir_ / "class/carol.zip", fs::perms::none);
  std::vector<Submission> all = read({dir_ / "class"});
  EXPECT_TRUE(says(all.at(0).files.at("conj_grad.cpp").problem, "can't be read (Permission denied)"));
  EXPECT_EQ(all.at(1).problem, "");
  EXPECT_TRUE(says(all.at(2).problem, "can't be read (Permission denied)"));
  fs::create_directory(dir_ / "class/bob/closed");
  fs::permissions(dir_ / "class/bob/closed", fs::perms::none);
  all = read({dir_ / "class"});
  EXPECT_TRUE(says(all.at(1).problem, "The folder bob/closed can't be read"));
  fs::permissions(dir_ / "class/bob/closed", fs::perms::all);
}

TEST_F(Submissions, AFileThatIsTooLongIsNotTaken) {
  IntakeLimits limits;
  limits.file_bytes = 1000;
  for (const Packing packing : {Packing::zip, Packing::tar_gz}) {
    const Submission alice =
        only(ArchiveBuilder(packing).zeros("conj_grad.cpp", 1001).zeros("normal_equations.cpp", 1000).bytes(),
             limits);
    EXPECT_TRUE(says(alice.files.at("conj_grad.cpp").problem, "conj_grad.cpp is larger than 1000 bytes"));
    EXPECT_EQ(alice.files.at("conj_grad.cpp").text, "");
    EXPECT_EQ(alice.files.at("normal_equations.cpp").text.size(), 1000u);
  }
}

// A zip's files are found by its directory, as a folder's are. A tar's stream is read from its beginning.
TEST_F(Submissions, MoreThanTheLimitsIsRefusedWhereverItLies) {
  IntakeLimits limits;
  limits.unpacked_bytes = limits.stream_bytes = 1 << 20;
  limits.file_bytes = limits.unpacked_bytes;
  limits.entries = 5;
  const std::size_t much = (1 << 20) + 1;
  const std::string fine = zip("conj_grad.cpp", "fine");
  for (const Packing packing : {Packing::zip, Packing::tar_gz}) {
    EXPECT_TRUE(says(only(ArchiveBuilder(packing).zeros("handin.zip", much).bytes(), limits).problem,
                     "unpacks to more than 1 MiB"));
    const std::string bytes =
        ArchiveBuilder(packing).zeros("data.bin", much).file("a/conj_grad.cpp", "x").bytes();
    const std::vector<Submission> all = read(
        {write("c.zip", ArchiveBuilder(Packing::zip).file("alice.zip", bytes).file("bob.zip", fine).bytes())},
        limits);
    if (packing == Packing::zip) {
      EXPECT_EQ(all.at(0).files.at("conj_grad.cpp").text, "x") << "the rest is not read";
    } else {
      EXPECT_TRUE(says(all.at(0).problem, "unpacks to more than 1 MiB"));
    }
    EXPECT_EQ(all.at(1).files.at("conj_grad.cpp").text, "fine");
    ArchiveBuilder many(packing);
    for (int i = 0; i < 6; ++i) many.file("d/f" + std::to_string(i), "");
    many.file("conj_grad.cpp");
    EXPECT_TRUE(says(only(many.bytes(), limits).problem, "ore than 5 files and folders"));
  }
  write("big/conj_grad.cpp", "x");
  write("big/data", std::string(much, 'x'));
  EXPECT_EQ(read({dir_ / "big"}, limits).front().files.at("conj_grad.cpp").text, "x")
      << "the rest is not read";
}

TEST_F(Submissions, WhatIsIgnoredUsesNothingUp) {
  IntakeLimits limits;
  limits.unpacked_bytes = 1 << 20;
  limits.entries = 2;
  ArchiveBuilder builder(Packing::zip);
  builder.zeros(".git/pack", 2 << 20);
  for (const char* name : {"__MACOSX/a/._x", "a/.vs/x", "a/Icon\r", "a/~$x.docx", "a/x.cpp:Zone.Identifier",
                           "@eaDir/x", "Thumbs.db"})
    builder.file(name, "x");
  for (int i = 0; i < 100; ++i) builder.file(".git/objects/" + std::to_string(i));
  const std::string bytes = builder.file("a/conj_grad.cpp", "fine").bytes();
  EXPECT_EQ(only(bytes, limits).files.at("conj_grad.cpp").text, "fine");
  EXPECT_EQ(read({write("x.zip", bytes)}, limits).front().files.at("conj_grad.cpp").text, "fine");
  limits.entries = 3;
  EXPECT_EQ(only(zip("handin.zip", bytes), limits).files.at("conj_grad.cpp").text, "fine");
}

TEST_F(Submissions, TooMuchOfOneInAnArchivesFolderStaysWithIt) {
  IntakeLimits limits;
  limits.unpacked_bytes = 1 << 20;
  const std::string bytes =
      ArchiveBuilder(Packing::zip).zeros("alice/data.zip", 2 << 20).file("bob/conj_grad.cpp", "fine").bytes();
  const std::vector<Submission> all = read({write("class.zip", bytes)}, limits);
  EXPECT_TRUE(says(all.at(0).problem, "unpacks to more than 1 MiB"));
  EXPECT_EQ(told(all), (Names{"alice: !", "bob: conj=fine"}));
}

TEST_F(Submissions, ManyArchivesInOneAreRefused) {
  ArchiveBuilder many(Packing::zip);
  many.file("CMakeLists.txt").file("solver/x.h");
  for (int i = 0; i < 21; ++i) many.file(std::to_string(i) + ".zip", zip("x"));
  EXPECT_TRUE(says(only(many.bytes()).problem, "More than 20 archives"));
}

TEST_F(Submissions, ArgumentsThatAreNoneAreBadInput) {
  EXPECT_TRUE(says(bad_input({dir_ / "none"}), "none: there is no such file or folder"));
  EXPECT_TRUE(
      says(bad_input({write("notes.txt", "hello")}), "notes.txt: is neither an archive nor a folder"));
  write("empty/main.cpp", "");
  EXPECT_TRUE(
      says(bad_input({dir_ / "empty"}), "there is no exercise file (conj_grad.cpp, normal_equations.cpp)"));
}

TEST_F(Submissions, NamesThatAreNoUtf8LoseNobody) {
  const std::vector<std::pair<std::string, std::string>> pages{
      {"M\xfcller", "Müller"},       // Latin-1
      {"M\x81ller", "Müller"},       // CP437
      {"\xcd\xf5\xce\xb0", "王伟"},  // GB18030
  };
  for (const auto& [bytes, text] : pages) {
    for (const bool flagged : {false, true}) {
      SCOPED_TRACE(text + (flagged ? ", with the flag of UTF-8" : ""));
      std::string packed = ArchiveBuilder(Packing::zip, "zip:compression=store")
                               .file("ann/conj_grad.cpp", "a")
                               .file(bytes + "/conj_grad.cpp", "b")
                               .file(bytes + " 2/conj_grad.cpp", "c")
                               .bytes();
      for (const auto& [mark, flag] : {std::pair("PK\x03\x04", 7), {"PK\x01\x02", 9}})
        for (std::size_t at = 0; flagged && (at = packed.find(mark, at)) != std::string::npos; at += 4)
          packed[at + flag] = static_cast<char>(packed[at + flag] | 8);
      const Intake intake = take({write("class.zip", packed)});
      ASSERT_EQ(intake.submissions.size(), 3u);
      std::set<std::string> owners;
      for (const Submission& one : intake.submissions) owners.insert(one.owner.name);
      EXPECT_EQ(owners, (std::set<std::string>{"ann", text, text + " 2"}));
      EXPECT_TRUE(has_remark(intake, {"class.zip: names in it are no UTF-8", "which is a guess"}));
    }
  }
}

TEST_F(Submissions, AnArchiveIsKnownByItsContentToo) {
  EXPECT_EQ(read({write("handed_in", zip("conj_grad.cpp", "x"))}).front().files.at("conj_grad.cpp").text,
            "x");
}

// As a tar.gz ten gigabytes would be 160 gzips of 64 MiB in a row, which unpack to one stream. This one ends
// after five of them, and nobody notices.
TEST_F(Submissions, OfTenGigabytesOfZerosNoMoreIsReadThanMayBe) {
  constexpr std::size_t chunk = std::size_t{64} << 20;
  const std::string tar = ArchiveBuilder(Packing::tar).zeros("conj_grad.cpp", 0).bytes();
  std::string header = tar.substr(0, 512);
  const std::string size = "120000000000";  // is octal for 10 GiB
  header.replace(124, size.size(), size);
  unsigned sum = 0;
  for (std::size_t i = 0; i < header.size(); ++i) {
    sum += i >= 148 && i < 156 ? ' ' : static_cast<unsigned char>(header[i]);
  }
  char digits[8];
  std::snprintf(digits, sizeof digits, "%06o", sum);
  header.replace(148, 7, digits, 7);
  const std::string zeros = gzip(std::string(chunk, '\0'));
  std::string bomb = gzip(header);
  for (int i = 0; i < 5; ++i) bomb += zeros;

  IntakeLimits limits;
  limits.stream_bytes = 4 * chunk;
  const std::string zip_bomb = ArchiveBuilder(Packing::zip).zeros("conj_grad.cpp", 5 * chunk).bytes();
  const auto all = read({write("class.zip", ArchiveBuilder(Packing::zip)
                                                .file("a.zip", bomb)
                                                .file("b.zip", zip("conj_grad.cpp"))
                                                .file("c.zip", zip_bomb)
                                                .bytes())},
                        limits);
  EXPECT_TRUE(says(all.at(0).problem, "unpacks to more than 256 MiB"));
  EXPECT_EQ(all.at(1).problem, "");
  EXPECT_TRUE(says(all.at(2).files.at("conj_grad.cpp").problem, "conj_grad.cpp is larger than 1 MiB"));
}

}  // namespace
}  // namespace grader::intake
