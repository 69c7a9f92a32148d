// STAFF ONLY. Declares the fields of people.
#include "grader/record/people_fields.h"

#include "grader/result/json_fields.h"

#include <algorithm>

namespace grader::inline record {
namespace {

// Follows the order of IdKind.
Field<Person> ids() {
  using Ids = std::vector<std::string>;
  return {"ids",
          [](const Person& person, const PictureText& pictures) {
            return to_json_value(Ids(person.ids.begin(), person.ids.end()), pictures);
          },
          [](Person& person, const JsonValue& at, const PictureText& pictures) {
            Ids all;
            from_json_value(all, at, pictures);
            if (all.size() != kIdKinds)
              at.fail("has " + std::to_string(all.size()) + " ids; write " + std::to_string(kIdKinds));
            std::ranges::copy(all, person.ids.begin());
          }};
}

}  // namespace

}  // namespace grader::record

namespace grader {

const Rows<Owner>& Fields<Owner>::rows() {
  using T = Owner;
  static const Rows<T> all = {field("name", &T::name),   field("id", &T::id),
                              field("email", &T::email), field("anonymous", &T::anonymous),
                              field("group", &T::group), field("members", &T::members)};
  return all;
}

const Rows<Person>& Fields<Person>::rows() {
  using T = Person;
  static const std::function<bool(const T&)> has_group = [](const T& person) {
    return !person.group.empty();
  };
  static const Rows<T> all = {field("name", &T::name),
                              field("section", &T::section),
                              field("group", &T::group, has_group),
                              ids(),
                              field("spoken", &T::keys, &NameKeys::as_spoken),
                              field("sorted", &T::keys, &NameKeys::as_sorted)};
  return all;
}

}  // namespace grader
