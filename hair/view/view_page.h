// The page that runs motions (motion.h): one file, which opens from disk, without a network. Its scripts are
// in page/ and become part of it.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/html.h"

namespace hair {

struct NamedMotion {
  std::string name;  // "swing": readers tell it from the other one by this
  std::string json;  // motion.json
};

// One motion, or two to compare. `below` stands below them: pictures there can be looked at closer, too.
std::string view_page(const std::vector<NamedMotion>& motions, const Html& below = {});

// A page's script that looks closer at pairs of pictures: images side by side in elements of class "pictures",
// and the frames of two motions.
std::string viewer_script();

}  // namespace hair
