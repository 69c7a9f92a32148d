// STAFF ONLY. Writes the categories of all exercises to standard output, as grader/samples/categories.h reads them:
// list_categories EXERCISES_JSON.
#include <iostream>
#include <nlohmann/json.hpp>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/suite/graded_categories.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: list_categories EXERCISES_JSON\n";
    return 2;
  }
  try {
    nlohmann::ordered_json all;
    for (const grader::Exercise& exercise : grader::read_course(argv[1]).exercises)
      for (const grader::Category& category : grader::graded_categories(exercise.id))
        all[exercise.id].push_back(
            {{"name", category.name}, {"title", category.title}, {"points", category.weight}});
    std::cout << all.dump(1) << "\n";
    return 0;
  } catch (const grader::BadInput& error) {
    std::cerr << "list_categories: " << error.what() << "\n";
    return 2;
  }
}
