// What the parts of a head's hair cost: collisions with a ball and with a bust, curls, links, strips; each beside the same hair without
// it, in the same run.
#pragma once

namespace hair_bench {

// Prints two tables.
void head_parts();

}  // namespace hair_bench
