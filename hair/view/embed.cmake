# cmake -DOUT=FILE.h -DFILES=a.js,b.js -P embed.cmake: a header with these scripts as a text. Compilers take raw strings of a few kilobytes, so
# that each script is one.
string(REPLACE "," ";" FILES "${FILES}")
set(text "// Made by hair/view/embed.cmake.\n#pragma once\n\n#include <string>\n\nnamespace hair {\n\ninline const std::string kPageScripts =\n    std::string()")
foreach(file ${FILES})
  file(READ "${file}" script)
  string(APPEND text " +\n    R\"js(${script})js\"")
endforeach()
file(WRITE "${OUT}" "${text};\n\n}  // namespace hair\n")
