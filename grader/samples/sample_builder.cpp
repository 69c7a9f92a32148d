// STAFF ONLY. Reads the categories of exercises, and makes a sample of its section.
#include "grader/samples/sample_builder.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "grader/course/input.h"

namespace grader::inline samples {
namespace {

void read_form(SampleBuilder& builder, const GroupLine& line) {
  for (const SampleFormName& form : kSampleForms)
    if (line.rest == form.name) {
      builder.sample.form = form.form;
      return;
    }
  builder.fail(line, "unknown form; write zip, tar.gz or folder");
}

void read_file_of(SampleBuilder& builder, const GroupLine& line) {
  std::string rest = line.rest;
  const std::string solution = builder.take(line, rest);
  builder.add(builder.path(line, rest), SampleFile::Kind::solution, solution);
}

void read_text(SampleBuilder& builder, const GroupLine& line) {
  std::string rest = line.rest;
  if (!rest.starts_with('"')) builder.fail(line, "write the text as a JSON string, and then the path");
  const std::string text = builder.take(line, rest);
  builder.add(builder.path(line, rest), SampleFile::Kind::text, text);
}

void read_link(SampleBuilder& builder, const GroupLine& line) {
  std::string rest = line.rest;
  const std::string target = builder.take(line, rest);
  builder.add(builder.path(line, rest), SampleFile::Kind::link, target);
}

void read_zeros(SampleBuilder& builder, const GroupLine& line) {
  std::string rest = line.rest;
  const double bytes = builder.number(line, builder.take(line, rest), 0, 1e12);
  builder.add(builder.path(line, rest), SampleFile::Kind::zeros, "", static_cast<std::uint64_t>(bytes));
}

void read_others(SampleBuilder& builder, const GroupLine& line) {
  if (line.rest != "reference" && line.rest != "stub" && line.rest != "none")
    builder.fail(line, "write reference, stub or none");
  builder.others = line.rest == "none" ? "" : line.rest;
}

void read_edit(SampleBuilder& builder, const GroupLine& line) {
  const auto file = std::ranges::find(builder.sample.files, SampleFile::Kind::solution, &SampleFile::kind);
  if (line.rest.empty() && file == builder.sample.files.end())
    builder.fail(line, "the sample has no \"file\"; name the file that the edit changes");
  builder.sample.edits.push_back(
      {builder.group.path.string() + ":" + std::to_string(line.number) + ": sample \"" + builder.sample.name +
           "\"",
       line.rest.empty() ? std::filesystem::path(file->path).filename().string() : line.rest,
       {}});
  builder.open = &builder.sample.edits.back().lines;
}

void read_part(SampleBuilder& builder, const GroupLine& line) {
  builder.open = &builder.parts[line.rest];
}

void read_cut(SampleBuilder& builder, const GroupLine& line) {
  builder.sample.cut = static_cast<std::uint64_t>(builder.number(line, line.rest, 0, 1e12));
}

void read_overwrite(SampleBuilder& builder, const GroupLine& line) {
  std::string hex = line.rest;
  Overwrite overwrite{static_cast<std::int64_t>(builder.number(line, builder.take(line, hex), -1e9, 1e9)),
                      ""};
  if (hex.empty() || hex.size() % 2 != 0 || hex.find_first_not_of("0123456789abcdef") != std::string::npos)
    builder.fail(line, "write two digits for a byte, 0 to 9 and a to f");
  for (std::size_t i = 0; i < hex.size(); i += 2)
    overwrite.bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  builder.sample.overwrite.push_back(overwrite);
}

void read_status(SampleBuilder& builder, const GroupLine& line) {
  std::string status = line.rest;
  const std::string id = builder.take(line, status);
  if (id == "all") {
    for (const Exercise& exercise : builder.course.exercises)
      builder.expect(line, exercise.id).status = status;
  } else {
    builder.expect(line, builder.exercise(line, id).id).status = status;
  }
}

void read_fails(SampleBuilder& builder, const GroupLine& line) {
  std::string names = line.rest;
  const std::string id = builder.exercise(line, builder.take(line, names)).id;
  const auto known = builder.categories.find(id);
  if (known == builder.categories.end()) builder.fail(line, "the suites have no categories of " + id);
  ExpectedResult& expected = builder.expect(line, id);
  std::vector<std::string>& failed = expected.failed;
  while (!names.empty()) {
    const std::string name = builder.take(line, names);
    const auto category = std::ranges::find(known->second, name, &SampleCategory::name);
    if (category == known->second.end()) {
      std::string all;
      for (const SampleCategory& one : known->second) all += (all.empty() ? "" : ", ") + one.name;
      builder.fail(line, id + " has no category \"" + name + "\"; it has " + all);
    }
    if (std::ranges::find(failed, category->title) != failed.end())
      builder.fail(line, "names " + name + " twice");
    failed.push_back(category->title);
  }
  if (failed.empty()) builder.fail(line, "name the categories that fail, as in \"fails H2 Energy Balance\"");
  if (failed.size() == known->second.size())
    builder.fail(line, "no category is left; write \"status " + id + " wrong\"");
}

void read_points(SampleBuilder& builder, const GroupLine& line) {
  std::string points = line.rest;
  const Exercise& exercise = builder.exercise(line, builder.take(line, points));
  builder.expect(line, exercise.id).points = builder.number(line, points, 0, exercise.points);
}

void read_place(SampleBuilder& builder, const GroupLine& line) {
  if (std::ranges::find(kPlaces, line.rest) == kPlaces.end())
    builder.fail(line, "unknown place; write build, start, run, protocol, archive, report or time");
  builder.attack().place = line.rest;
}

void read_most(SampleBuilder& builder, const GroupLine& line) {
  std::string points = line.rest;
  const std::string id = builder.take(line, points);
  if (id == "all") {
    builder.attack().most_points = builder.number(line, points, 0, 1000);
  } else {
    const Exercise& exercise = builder.exercise(line, id);
    builder.attack().most_points_of[id] = builder.number(line, points, 0, exercise.points);
  }
}

const SampleKey keys[] = {
    {"title", "title", false, [](SampleBuilder& b, const GroupLine& line) { b.sample.title = line.rest; }},
    {"part", "part", true, read_part},
    {"sample", "sample", false, [](SampleBuilder& b, const GroupLine& line) { b.sample.name = line.rest; }},
    {"shows", "shows", false, [](SampleBuilder& b, const GroupLine& line) { b.sample.shows = line.rest; }},
    {"form", "form", false, read_form},
    {"file", "file", true, read_file_of},
    {"text", "file", true, read_text},
    {"link", "file", true, read_link},
    {"zeros", "file", true, read_zeros},
    {"others", "others", false, read_others},
    {"edit", "edit", true, read_edit},
    {"windows", "windows", false, [](SampleBuilder& b, const GroupLine&) { b.sample.windows = true; }},
    {"cut", "cut", false, read_cut},
    {"overwrite", "overwrite", true, read_overwrite},
    {"showcase", "showcase", false,
     [](SampleBuilder& b, const GroupLine& line) {
       b.sample.showcase = true;
       b.sample.first = line.rest == "first";
       if (!b.sample.first && !line.rest.empty()) b.fail(line, "write showcase, or showcase first");
     }},
    {"beside-attacks", "beside-attacks", false,
     [](SampleBuilder& b, const GroupLine&) { b.sample.beside_attacks = true; }},
    {"status", "status", true, read_status},
    {"fails", "fails", true, read_fails},
    {"points", "points", true, read_points},
    {"useless", "useless", false,
     [](SampleBuilder& b, const GroupLine& line) { b.sample.useless = line.rest; }},
    {"place", "place", false, read_place},
    {"fence", "fence", false, [](SampleBuilder& b, const GroupLine& line) { b.attack().fence = line.rest; }},
    {"most", "most", true, read_most},
    {"seconds", "seconds", false,
     [](SampleBuilder& b, const GroupLine& line) {
       b.attack().most_cpu_seconds = b.number(line, line.rest, 0, 1000);
     }},
    {"also", "also", true,
     [](SampleBuilder& b, const GroupLine& line) { b.attack().also.push_back(line.rest); }},
    {"no-pictures", "no-pictures", false,
     [](SampleBuilder& b, const GroupLine&) { b.attack().no_pictures = true; }},
};

}  // namespace

const SampleKey* key_of(const GroupLine& line) {
  const auto* key = std::ranges::find(keys, line.key, &SampleKey::name);
  return key == std::end(keys) ? nullptr : key;
}

void SampleBuilder::read(const GroupLine& line) {
  const SampleKey* key = key_of(line);
  if (key == nullptr && std::string_view("-=+*").find(line.key) != std::string_view::npos)
    return add_to_edit(line);
  if (key == nullptr) fail(line, "unknown word \"" + line.key + "\"; see grader/samples/sample.h");
  open = nullptr;
  key->read(*this, line);
}

// Fills in "others", and the expected results of each exercise of the course.
void SampleBuilder::complete(const GroupLine& first) {
  if (sample.attack) {
    const Attack& attack = *sample.attack;
    if (attack.place.empty() || attack.fence.empty() || attack.most_cpu_seconds == 0 ||
        (!attack.most_points && attack.most_points_of.empty()))
      fail(first, "an attack has place, fence, most and seconds");
  }
  const std::vector<SampleFile> before = sample.files;
  for (const Exercise& exercise : course.exercises) {
    const bool has_file = std::ranges::any_of(before, [&](const SampleFile& file) {
      return std::filesystem::path(file.path).filename() == exercise.file;
    });
    const bool filled_in = !has_file && !others.empty();
    if (filled_in) sample.files.push_back({exercise.file, SampleFile::Kind::solution, others, 0});
    ExpectedResult& expected = sample.expected[exercise.id];
    if (const auto line = named.find(exercise.id); line != named.end()) {
      expected = given[exercise.id];
      if (filled_in) fail(*line->second, "names " + exercise.id + ", which \"others\" fills in");
      if (expected.points.has_value() != (sample.showcase && !expected.failed.empty()))
        fail(*line->second, expected.points
                                ? "points are computed; name the categories that fail"
                                : "a sample of the showcase says its points of " + exercise.id + ", too");
      if (!expected.failed.empty() && expected.status.empty()) expected.status = "partly";
      if (!expected.failed.empty() && !expected.points)
        expected.points = points_without(categories.at(exercise.id), expected.failed);
      sample.listed.push_back(exercise.id);
    } else {
      expected.status = has_file || others == "reference" ? "passed"
                        : others == "stub"                ? "not implemented"
                                                          : "missing";
    }
  }
  std::ranges::sort(sample.files, {}, &SampleFile::path);
}

SampleCategories read_categories(const std::filesystem::path& project, const Course& course) {
  SampleCategories all;
  for (const Exercise& exercise : course.exercises) {
    const std::filesystem::path file = project / "handout" / exercise.folder / "categories.json";
    const nlohmann::json document = read_json(file);
    for (const JsonValue& json : JsonValue(document, file).items()) {
      json.check_keys({"id", "title", "points", "asks"}, {"functions", "rows"});
      all[exercise.id].push_back({json["id"].text(), json["title"].text(), json["points"].number(0, 1000)});
    }
  }
  return all;
}

double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed) {
  double points = 0;
  for (const SampleCategory& category : categories)
    if (std::ranges::find(failed, category.title) == failed.end()) points += category.points;
  return points;
}

}  // namespace grader::samples
