// STAFF ONLY.
#include "grader/samples/sample.h"

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "grader/course/strict_json.h"

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

}  // namespace

std::string Sample::file_name() const {
  for (const Form& candidate : forms) {
    if (candidate.form == form) return name + std::string(candidate.ending);
  }
  return name;
}

std::vector<Sample> read_samples(const std::filesystem::path& samples_json) {
  const nlohmann::json document = read_json(samples_json);
  const JsonValue top(document, samples_json);
  top.check_keys({"samples"});
  std::vector<Sample> samples;
  std::set<std::string> names;
  const std::vector<JsonValue> items = top["samples"].items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const JsonValue& json = items[i];
    json.check_keys({"name", "shows", "form", "files", "expect"}, {"patch", "windows", "cut"});
    Sample sample;
    sample.name = json["name"].text();
    if (!names.insert(sample.name).second) json["name"].fail("this name is taken; give each sample its own");
    sample.shows = json["shows"].text();
    sample.form = read_form(json["form"]);
    const nlohmann::json& raw = document["samples"][i];
    for (const std::string& path : json["files"].keys()) {
      sample.files.push_back(read_file(path, json["files"][path], raw["files"][path].is_object()));
    }
    if (json.has("patch")) sample.patch = json["patch"].text();
    sample.windows = raw.value("windows", false);
    if (json.has("cut")) sample.cut = read_bytes(json["cut"]);
    for (const std::string& id : json["expect"].keys()) {
      const JsonValue expected = json["expect"][id];
      expected.check_keys({"status"}, {"points"});
      ExpectedResult& result = sample.expected[id];
      result.status = expected["status"].text();
      if (expected.has("points")) result.points = expected["points"].number(0, 1e6);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace grader
