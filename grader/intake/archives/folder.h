// STAFF ONLY. A folder on disk as a container. Links are listed as links and never followed. Names in
// ignored.h are not listed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/intake/archives/container.h"

namespace grader::inline intake {

class Folder : public Container {
 public:
  Folder(std::filesystem::path path, std::string shown, std::size_t most_entries);

  std::vector<Entry> list() override;  // sorts by path
  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t index, const Read&)>& take) override;

 private:
  std::filesystem::path path_;
  std::string shown_;
  std::size_t most_entries_;
  std::vector<std::string> listed_;
};

}  // namespace grader::intake
