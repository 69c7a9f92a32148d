# The packages that the build looks for and that hairlab loads, a row each: what needs it, its name for apt
# (Debian, Ubuntu, WSL2), and its name for Homebrew, or "-". README.md lists them, too.
#
#   hair_how_to_install(OUT PACKAGE...)   a sentence, of names for apt
set(HAIR_PACKAGES
  checks    cmake               cmake
  checks    libeigen3-dev       eigen
  checks    libgtest-dev        googletest
  hairlab   nlohmann-json3-dev  nlohmann-json
  hairlab   libcli11-dev        cli11
  hairlab   libstb-dev          -
  hairlab   libosmesa6          -
  hairlab   ffmpeg              ffmpeg
  live      libmicrohttpd-dev   libmicrohttpd
  live      pkg-config          pkgconf
  studies   libsundials-dev     sundials)

function(hair_how_to_install OUT)
  set(brew)
  foreach(package ${ARGN})
    list(FIND HAIR_PACKAGES ${package} i)
    math(EXPR i "${i} + 1")
    list(GET HAIR_PACKAGES ${i} name)
    if(NOT name STREQUAL "-")
      list(APPEND brew ${name})
    endif()
  endforeach()
  string(JOIN " " apt ${ARGN})
  set(text "Debian, Ubuntu, WSL2: sudo apt install ${apt}. macOS: ")
  if(brew)
    string(JOIN " " brew ${brew})
    string(APPEND text "brew install ${brew}; ")
  endif()
  set(${OUT} "${text}README.md says more" PARENT_SCOPE)
endfunction()
