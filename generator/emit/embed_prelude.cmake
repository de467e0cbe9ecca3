# cmake "-DSOURCES=a.hpp;b.hpp" -DFUNCTION=prelude -DOUTPUT=prelude.cpp -P embed_prelude.cmake: text files, one after the other, as a C++ string.
# The text is taken byte by byte, so nothing in it has to be quoted for CMake.
set(hex "")
foreach(source IN LISTS SOURCES)
  file(READ "${source}" one HEX)
  string(APPEND hex "${one}")
endforeach()
# What they include of ours is in the header already: #include "gauss/….hpp" and the end of its line.
set(names "")
foreach(source IN LISTS SOURCES ITEMS src/gauss/math.hpp)
  string(REGEX REPLACE "^.*src/gauss/" "" name "${source}")
  list(APPEND names "${name}")
  string(HEX "#include \"gauss/${name}\"\n" include)
  string(REPLACE "${include}" "" hex "${hex}")
endforeach()
# Any other would be found beside the sources only, not where the text is compiled.
foreach(source IN LISTS SOURCES)
  file(STRINGS "${source}" includes REGEX "^#include \"gauss/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"gauss/(.*)\"$" "\\1" name "${include}")
    list(FIND names "${name}" found)
    if(found EQUAL -1)
      message(FATAL_ERROR "${FUNCTION}: ${source} includes gauss/${name}, which is not among its SOURCES")
    endif()
  endforeach()
endforeach()
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
# One line of code per line of text.
string(REPLACE "'\\x0a'," "'\\x0a',\n    " bytes "${bytes}")
if(NOT DEFINED NAMESPACE)
  set(NAMESPACE gaussgen::emit)
  set(HEADER emit/header.hpp)
endif()
file(WRITE "${OUTPUT}" "// Made by embed_prelude.cmake.
#include \"${HEADER}\"

namespace ${NAMESPACE} {

namespace {

constexpr char k_text[] = {
    ${bytes}'\\0'};

}  // namespace

std::string_view ${FUNCTION}() { return {k_text, sizeof k_text - 1}; }

}  // namespace ${NAMESPACE}
")
