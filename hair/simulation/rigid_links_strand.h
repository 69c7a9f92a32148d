// Makes a strand of rigid links with a description's weight and drag.
#pragma once

#include "hair/rigid_links/link_strand.h"
#include "hair/simulation/description.h"

namespace hair {

LinkStrand links_of(const StrandSpec& spec, const Description& description);

}  // namespace hair
