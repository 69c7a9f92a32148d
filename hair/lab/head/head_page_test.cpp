// The record, the table and the page of an invented study.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hair/lab/head/head_pictures.h"
#include "hair/lab/head/head_record.h"
#include "solver/test_refusal.h"

namespace hair::head_study {
namespace {

using Json = OrderedJson;

// All numbers differ.
HeadStudy made_study() {
  double next = 1e-3;
  const auto number = [&] { return next += 0.37e-3; };
  HeadStudy study{{}, {}, ""};
  for (const std::size_t hair : {0, 3})
    for (const bool collides : {true, false}) {
      HeadCase one{&head_hairs()[hair], collides, 2000, number(), number(), {}};
      for (const int guides : {100, 1'000}) {
        GuideRun run{guides, number(), {}};
        for (ModeRun& mode : run.modes) {
          mode.synthesis = number();
          for (HeadError* error :
               {&mode.errors.start, &mode.errors.end, &mode.errors.all, &mode.errors.motion})
            *error = {number(), number()};
        }
        one.runs.push_back(run);
      }
      study.cases.push_back(one);
    }
  study.pictures = {{"straight", "straight-every.png", 2000}, {"straight", "straight-few.png", 100}};
  return study;
}

// Its table has a row for each way of synthesis, and one for every strand.
TEST(HeadRecord, HasEachNumberWhereItSays) {
  const HeadStudy study = made_study();
  EXPECT_EQ(head_rows(study).size(), 4u * (2 * kModes.size() + 1));
  const Json json = head_json(study);
  EXPECT_TRUE(json["no_pictures"].is_null());
  EXPECT_EQ(json["pictures"][1]["file"], "straight-few.png");
  ASSERT_EQ(json["cases"].size(), study.cases.size());
  const HeadCase& last = study.cases.back();
  const Json& read = json["cases"].back();
  EXPECT_EQ(read["hair"], "curly");
  EXPECT_EQ(read["head"], false);
  EXPECT_EQ(read["simulated_by"], "exercises");
  EXPECT_EQ(read["seconds"].get<double>(), last.seconds);
  EXPECT_EQ(read["runs"][1]["simulation"].get<double>(), last.runs[1].simulation);
  const Json& mode = read["runs"][1]["modes"]["blend"];
  EXPECT_EQ(mode["synthesis"].get<double>(), last.runs[1].modes[2].synthesis);
  EXPECT_EQ(mode["start"]["rms"].get<double>(), last.runs[1].modes[2].errors.start.rms);
  EXPECT_EQ(mode["motion"]["most"].get<double>(), last.runs[1].modes[2].errors.motion.most);
}

void expect_parts(const std::string& page, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_TRUE(tests::says(page, part));
}

TEST(HeadPage, HoldsEachTableFigureAndPicture) {
  const std::string page = to_html(head_page(made_study()));
  expect_parts(page, {"The answer in numbers", "straight-few.png", "interpolated from 100 guides",
                      "every strand simulated, 2000", "img-src &#39;self&#39; file:"});
  for (const char* id : {"straight-head", "straight-free", "curly-head", "curly-free"})
    expect_parts(page, {"id=\"error-against-time-" + std::string(id) + "\""});
  for (const char* hair : {"Straight hair", "Curly hair"})
    for (const char* place : {" on a head, ", " without a head, "})
      for (const ModeName& mode : kModes)
        expect_parts(page, {hair + std::string(place) + mode.id + ": 2000 strands, "});
  EXPECT_LT(page.find("straight-few.png"), page.find("straight-every.png"));
}

TEST(HeadPage, SaysWhyThereAreNoPictures) {
  HeadStudy study = made_study();
  study.pictures.clear();
  study.no_pictures = "no <OpenGL>";
  const std::string page = to_html(head_page(study));
  expect_parts(page, {"There are no pictures: no &lt;OpenGL&gt;.", "img-src data:"});
  EXPECT_EQ(page.find("<img"), std::string::npos);
}

// Fewer strands than any number of guides: only the run of every strand remains.
TEST(HeadPage, IsMadeWithoutRuns) {
  HeadStudy study = made_study();
  for (HeadCase& one : study.cases) one.runs.clear();
  EXPECT_NO_THROW(to_html(head_page(study)));
}

TEST(HeadPictures, ShowAHundredGuidesAndAThousandOrWhatIsNearest) {
  EXPECT_EQ(pictured_guides({50, 100, 300, 1000, 3000}).few, 100);
  EXPECT_EQ(pictured_guides({50, 100, 300, 1000, 3000}).many, 1000);
  EXPECT_EQ(pictured_guides({50, 100, 300}).many, 300);
  EXPECT_EQ(pictured_guides({50}).few, 50);
}

}  // namespace
}  // namespace hair::head_study
