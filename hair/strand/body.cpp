#include "hair/strand/body.h"

namespace hair {

const char* coordinates_name(Coordinates coordinates) {
  switch (coordinates) {
    case Coordinates::positions:
      return "positions";
  }
  return "";
}

}  // namespace hair
