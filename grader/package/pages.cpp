// STAFF ONLY. Has a script make the handout's pages.
#include "grader/package/pages.h"

#include <algorithm>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"

namespace grader::inline package {

namespace fs = std::filesystem;

Paths with_pages(Paths paths) {
  for (const std::string& path : Paths(paths))
    if (path.ends_with(".md")) paths.insert(fs::path(path).replace_extension(".html").string());
  paths.insert("assignment/font-licence.txt");
  return paths;
}

std::string add_pages(Files& handout, const fs::path& script) {
  const hair::TemporaryFolder folder("handout-pages");
  const fs::path said = folder.path() / "said";
  std::vector<std::string> words{"/usr/bin/env", "node", script.string(), folder.path().string()};
  Paths paths;
  for (const auto& [path, bytes] : handout) {
    paths.insert(path);
    if (path.ends_with(".md")) words.push_back(path);
    if (!path.ends_with(".md") && !path.ends_with(".png") && !path.ends_with(".svg") &&
        !path.ends_with(".html"))
      continue;
    fs::create_directories((folder.path() / path).parent_path());
    hair::write_file(folder.path() / path, bytes);
  }
  const auto code = hair::exit_code_of(
      hair::start_program({.words = words,
                           .output = said,
                           .errors = "/dev/null",
                           .environment = {"NODE_PATH=/usr/share/nodejs"}}));  // Debian's libraries
  std::string line = code == 127 ? "node is missing" : hair::bytes_of(said);
  line.resize(std::min(line.find('\n'), line.size()));
  if (code == 77 || code == 127)
    return "The texts have no pages: " + line +
           "; install Debian's nodejs, katex, node-marked, fonts-lmodern, fonttools and python3-brotli";
  if (code != 0) throw BadInput(script.string() + ": " + line);
  for (const std::string& path : with_pages(paths))
    if (!handout.contains(path) && (handout[path] = hair::bytes_of(folder.path() / path)).empty())
      throw BadInput(script.string() + " did not write " + path);
  handout["README.md"].insert(
      0, "**[Open README.html in a browser](README.html)**: this text and all others, with formulas.\n\n");
  return "";
}

}  // namespace grader::package
