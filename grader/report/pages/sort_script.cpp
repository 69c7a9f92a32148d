// STAFF ONLY. Holds the script that sorts the class's table.
#include "grader/report/pages/pages.h"

namespace grader::inline report {

std::string sort_script() {
  return R"js(
for (const th of document.querySelectorAll("table thead th[data-sort]")) {
  const column = th.cellIndex, button = document.createElement("button");
  button.append(...th.childNodes);
  th.append(button);
  button.onclick = () => {
    const down = th.getAttribute("aria-sort") === "ascending";
    for (const other of th.parentNode.children) other.removeAttribute("aria-sort");
    th.setAttribute("aria-sort", down ? "descending" : "ascending");
    const value = row => row.cells[column].dataset.value;
    const order = th.dataset.sort === "number"
      ? (a, b) => value(a) - value(b) : (a, b) => value(b) > value(a) ? -1 : value(a) > value(b);
    const body = th.closest("table").tBodies[0];
    body.append(...[...body.rows].sort((a, b) => down ? order(b, a) : order(a, b)));
  };
}
)js";
}

}  // namespace grader::report
