// STAFF ONLY.
#include "grader/compile/cache.h"

#include <fcntl.h>
#include <stdlib.h>

#include "grader/sandbox/descriptor.h"

namespace grader {

namespace fs = std::filesystem;

void keep_copy(const fs::path& file, const fs::path& kept) {
  std::error_code error;
  std::string temporary = (kept.parent_path() / "new-XXXXXX").string();
  const Descriptor reserved(mkostemp(temporary.data(), O_CLOEXEC));
  if (reserved && fs::copy_file(file, temporary, fs::copy_options::overwrite_existing, error))
    fs::rename(temporary, kept, error);
}

}  // namespace grader
