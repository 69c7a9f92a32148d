// Checks a table: it has a header, and all rows are as long as the header.
#pragma once

#include <stdexcept>
#include <string>

#include "hair/io/plot/page.h"

namespace hair::plot {

inline void check_table(const Table& table) {
  if (table.header.empty())
    throw std::invalid_argument("table \"" + table.caption + "\": the header is empty; a column is needed");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != table.header.size())
      throw std::invalid_argument("table \"" + table.caption + "\": row " + std::to_string(i) + " has " +
                                  std::to_string(table.rows[i].size()) + " fields; the header has " +
                                  std::to_string(table.header.size()));
}

}  // namespace hair::plot
