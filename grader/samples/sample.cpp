// STAFF ONLY.
#include "grader/samples/sample.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "grader/course/course.h"
#include "grader/course/input.h"

namespace grader {
namespace {

struct Form {
  SampleForm form;
  std::string_view name, ending;
};
constexpr std::array<Form, 3> forms{{{SampleForm::zip, "zip", ".zip"},
                                     {SampleForm::tar_gz, "tar.gz", ".tar.gz"},
                                     {SampleForm::folder, "folder", ""}}};

SampleForm read_form(const JsonValue& json) {
  for (const Form& form : forms) {
    if (json.text() == form.name) return form.form;
  }
  json.fail("unknown form; write zip, tar.gz or folder");
}

std::uint64_t read_bytes(const JsonValue& json) {
  return static_cast<std::uint64_t>(json.number(0, 1e12));
}

SampleFile read_file(const std::string& path, const JsonValue& json, bool is_object) {
  if (!is_object) return {path, SampleFile::Kind::solution, json.text(), 0};
  json.check_keys({}, {"text", "link", "zeros"});
  if (json.keys().size() != 1) json.fail("has several contents, or none; write one of text, link, zeros");
  if (json.has("text")) return {path, SampleFile::Kind::text, json["text"].text(), 0};
  if (json.has("link")) return {path, SampleFile::Kind::link, json["link"].text(), 0};
  return {path, SampleFile::Kind::zeros, "", read_bytes(json["zeros"])};
}

ExpectedResult read_expected(const JsonValue& json, const Exercise& exercise) {
  json.check_keys({"status"}, {"points"});
  ExpectedResult expected{json["status"].text(), {}};
  if (json.has("points")) expected.points = json["points"].number(0, exercise.points);
  return expected;
}

Attack read_attack(const JsonValue& json, bool one_number, const Course& course) {
  json.check_keys({"place", "fence", "most_points", "most_cpu_seconds"}, {"also", "no_pictures"});
  Attack attack;
  attack.place = json["place"].text();
  if (std::find(kPlaces.begin(), kPlaces.end(), attack.place) == kPlaces.end())
    json["place"].fail("unknown place; write build, start, run, protocol, archive, report or time");
  attack.fence = json["fence"].text();
  const JsonValue points = json["most_points"];
  if (one_number) {
    attack.most_points = points.number(0, 1000);
  } else {
    for (const std::string& id : points.keys()) {
      const Exercise* exercise = course.find(id);
      if (exercise == nullptr) points.fail("there is no exercise " + id);
      attack.most_points_of[id] = points[id].number(0, exercise->points);
    }
  }
  attack.most_cpu_seconds = json["most_cpu_seconds"].number(0, 1000);
  if (json.has("also"))
    for (const JsonValue& status : json["also"].items()) attack.also.push_back(status.text());
  if (json.has("no_pictures")) attack.no_pictures = json["no_pictures"].boolean();
  return attack;
}

Overwrite read_overwrite(const JsonValue& json) {
  json.check_keys({"at", "hex"});
  Overwrite overwrite{static_cast<std::int64_t>(json["at"].number(-1e9, 1e9)), ""};
  const std::string hex = json["hex"].text();
  if (hex.size() % 2 != 0 || hex.find_first_not_of("0123456789abcdef") != std::string::npos)
    json["hex"].fail("write two digits for a byte, 0 to 9 and a to f");
  for (std::size_t i = 0; i < hex.size(); i += 2)
    overwrite.bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return overwrite;
}

// Fills in "others", and what each exercise of the course is expected to give.
void complete(Sample& sample, const JsonValue& json, const Course& course) {
  std::string others;
  if (json.has("others")) {
    others = json["others"].text();
    if (others != "reference" && others != "stub") json["others"].fail("write reference or stub");
  }
  for (const std::string& id : json["expect"].keys())
    if (!course.find(id)) json["expect"].fail("there is no exercise " + id);

  const std::vector<SampleFile> named = sample.files;
  for (const Exercise& exercise : course.exercises) {
    const bool has_file = std::any_of(named.begin(), named.end(), [&](const SampleFile& file) {
      return std::filesystem::path(file.path).filename() == exercise.file;
    });
    const bool filled_in = !has_file && !others.empty();
    if (filled_in) sample.files.push_back({exercise.file, SampleFile::Kind::solution, others, 0});
    if (json["expect"].has(exercise.id)) {
      if (filled_in) json["expect"].fail("names " + exercise.id + ", which \"others\" fills in");
      sample.listed.push_back(exercise.id);
      sample.expected[exercise.id] = read_expected(json["expect"][exercise.id], exercise);
    } else if (has_file) {
      json["expect"].fail("does not say what " + exercise.id + " gets for its " + exercise.file);
    } else {
      const char* status = !filled_in ? "missing" : others == "stub" ? "not implemented" : "passed";
      sample.expected[exercise.id] = {status, {}};
    }
  }
  std::sort(sample.files.begin(), sample.files.end(),
            [](const SampleFile& a, const SampleFile& b) { return a.path < b.path; });
}

// Adds the samples of one list; `names` are those that are taken.
void read_list(const std::filesystem::path& list, const Course& course, std::set<std::string>& names,
               std::vector<Sample>& samples) {
  const nlohmann::json document = read_json(list);
  const JsonValue top(document, list);
  top.check_keys({"samples"});
  const std::vector<JsonValue> items = top["samples"].items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const JsonValue& json = items[i];
    json.check_keys(
        {"name", "shows", "form", "files", "expect"},
        {"others", "patch", "windows", "cut", "overwrite", "showcase", "beside_attacks", "attack"});
    Sample sample;
    sample.list = list.stem().string();
    sample.name = json["name"].text();
    if (!names.insert(sample.name).second) json["name"].fail("this name is taken; give each sample its own");
    sample.shows = json["shows"].text();
    sample.form = read_form(json["form"]);
    const nlohmann::json& raw = document["samples"][i];
    for (const std::string& path : json["files"].keys())
      sample.files.push_back(read_file(path, json["files"][path], raw["files"][path].is_object()));
    if (json.has("patch")) sample.patch = json["patch"].text();
    if (json.has("windows")) sample.windows = json["windows"].boolean();
    if (json.has("showcase")) sample.showcase = json["showcase"].boolean();
    if (json.has("cut")) sample.cut = read_bytes(json["cut"]);
    if (json.has("overwrite"))
      for (const JsonValue& bytes : json["overwrite"].items())
        sample.overwrite.push_back(read_overwrite(bytes));
    if (json.has("beside_attacks")) sample.beside_attacks = json["beside_attacks"].boolean();
    if (json.has("attack"))
      sample.attack = read_attack(json["attack"],
                                  raw["attack"].value("most_points", nlohmann::json()).is_number(), course);
    complete(sample, json, course);
    samples.push_back(std::move(sample));
  }
}

}  // namespace

std::string Sample::file_name() const {
  for (const Form& candidate : forms) {
    if (candidate.form == form) return name + std::string(candidate.ending);
  }
  return name;
}

std::vector<Sample> read_samples(const std::filesystem::path& project) {
  const Course course = read_course(project / "handout" / "exercises.json");
  std::vector<std::filesystem::path> lists;
  for (const auto& entry : std::filesystem::directory_iterator(project / "grader" / "samples" / "list"))
    if (entry.path().extension() == ".json") lists.push_back(entry.path());
  std::sort(lists.begin(), lists.end());
  std::vector<Sample> samples;
  std::set<std::string> names;
  for (const std::filesystem::path& list : lists) read_list(list, course, names, samples);
  return samples;
}

}  // namespace grader
