// STAFF ONLY. Finds functions in a header, and the names of their parameters.
#include "grader/judge/calls_as_code.h"

#include <utility>

#include "hair/io/files/read_file.h"

namespace grader::inline judge {
namespace {

Declared::Parameter parameter_of(std::string text) {
  const bool is_array = text.ends_with("[]");
  if (is_array) text.resize(text.size() - 2);
  const std::size_t name = text.find_last_of(" *&\n") + 1;
  return {text.substr(name), is_array || text.substr(0, name).find('*') != std::string::npos};
}

}  // namespace

std::vector<Declared> declared(const Exercise& exercise, const std::filesystem::path& headers) {
  const std::string header = hair::bytes_of(headers / exercise.header);
  std::vector<Declared> all;
  for (const std::string& signature : exercise.functions) {
    Declared& one = all.emplace_back();
    one.name = signature.substr(0, signature.find('('));
    const std::string start = " " + hair::plain_name(signature) + "(";
    std::size_t at = header.find(start), begin = header.rfind('\n', at) + 1;
    for (; at != std::string::npos && header.compare(begin, 2, "//") == 0; begin = header.rfind('\n', at) + 1)
      at = header.find(start, at + 1);
    const std::size_t end = header.find(");", at);
    if (end == std::string::npos) throw NotWritable(exercise.header + " does not declare " + one.name);
    one.text = header.substr(begin, end + 1 - begin);
    std::string next;
    int depth = 0;
    for (const char c : header.substr(at + start.size(), end - at - start.size()) + ",") {
      depth += (c == '<') - (c == '>');
      if (c != ',' || depth > 0)
        next += c;
      else
        one.parameters.push_back(parameter_of(std::exchange(next, "")));
    }
  }
  return all;
}

}  // namespace grader::judge
