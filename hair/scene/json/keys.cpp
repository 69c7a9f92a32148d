#include "hair/scene/json/keys.h"

#include <array>
#include <charconv>
#include <set>
#include <utility>

namespace hair::json {

namespace {

class Tables {
 public:
  // A section appears once, however many keys lead to it.
  void add(const ObjectKind& object, const std::string& path, const std::string& heading) {
    if (!headings_.insert(heading).second) return;
    const Section& section = object.section();
    text_ += "## " + heading + "\n\n" + section.about + (*section.about ? "\n\n" : "") +
             (section.one_of ? "One of:\n\n" : "") +
             "| key | unit | default | bounds | what |\n|---|---|---|---|---|\n";
    for (const NotedKey& key : section.keys) add_row(key);
    text_ += "\n";
    for (const NotedKey& key : section.keys)
      for (const ObjectKind& inner : key.spec.objects) {
        const std::string below = path + (path.empty() ? "" : ".") + key.name + (key.list ? "[]" : "");
        add(inner, below, "`" + below + "`" + inner.addition);
      }
  }

  std::string take() { return std::move(text_); }

 private:
  void add_row(const NotedKey& key) {
    text_ += "| `" + std::string(key.name) + "` ";
    for (const std::string& cell :
         {std::string(key.spec.unit), key.otherwise, key.bounds, std::string(key.what)})
      text_ += "|" + (cell.empty() ? "" : " " + cell) + " ";
    text_ += "|\n";
  }

  std::string text_;
  std::set<std::string> headings_;
};

}  // namespace

std::string key_tables(const ObjectKind& object, const std::string& top) {
  Tables tables;
  tables.add(object, "", top);
  return tables.take();
}

void Section::check(const JsonValue& object) const {
  if (one_of)
    object.only_key(optional);
  else
    object.check_keys(needed, optional);
}

void Keys::note(NotedKey key) {
  (key.spec.needed ? noted_->needed : noted_->optional).emplace_back(key.name);
  noted_->keys.push_back(std::move(key));
}

Vector3d Keys::vector_at(const char* key, const KeySpec& spec) const {
  return Vector3d(at(key).three_numbers(spec.least, spec.most).data());
}

Vector3d Keys::direction_at(const char* key, const KeySpec& spec) const {
  const Vector3d along = vector_at(key, spec);
  const double size = along.norm();
  if (size < 1e-9) at(key).fail("has no direction; give one that is not [0, 0, 0]");
  return size == 1 ? along : Vector3d(along / size);
}

std::string exact_text(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.begin(), text.end(), number).ptr};
}

std::string Keys::text_of(const Vector3d& vector) {
  return "[" + exact_text(vector[0]) + ", " + exact_text(vector[1]) + ", " + exact_text(vector[2]) + "]";
}

}  // namespace hair::json
