# cmake -DSOURCE=math.hpp -DFUNCTION=prelude -DOUTPUT=prelude.cpp -P embed_prelude.cmake: a text file as a C++ string.
# The text is taken byte by byte, so nothing in it has to be quoted for CMake.
file(READ "${SOURCE}" hex HEX)
# What it includes of ours is in the header already: #include "gauss/….hpp" and the end of its line.
string(HEX "#include \"gauss/math.hpp\"\n" include)
string(REPLACE "${include}" "" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
# One line of code per line of text.
string(REPLACE "'\\x0a'," "'\\x0a',\n    " bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Made by embed_prelude.cmake.
#include \"emit/header.hpp\"

namespace gaussgen::emit {

namespace {

constexpr char k_text[] = {
    ${bytes}'\\0'};

}  // namespace

std::string_view ${FUNCTION}() { return {k_text, sizeof k_text - 1}; }

}  // namespace gaussgen::emit
")
