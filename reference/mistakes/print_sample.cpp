// STAFF ONLY. Writes a sample's file of an exercise, with its bug: print_sample PROJECT SAMPLE OUT.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "grader/samples/solution_files.h"
#include "hair/io/files/write_file.h"

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("print_sample PROJECT SAMPLE OUT");
  const std::filesystem::path project = arguments[1], out = arguments[3];
  const auto samples = grader::read_samples(project);
  const auto sample = std::ranges::find(samples, arguments[2], &grader::Sample::name);
  if (sample == samples.end()) throw std::runtime_error(std::string("there is no sample ") + arguments[2]);
  for (const auto& [path, text] : grader::solution_files(*sample, project))
    if (std::filesystem::path(path).filename() == out.filename()) hair::write_file(out, text);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "print_sample: %s\n", error.what());
  return 1;
}
