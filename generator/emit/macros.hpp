#pragma once

#include <string_view>

namespace gaussgen::emit {

/// True for what headers that a program is likely to include define as macros: those of C, C++ and POSIX, of Windows, and
/// of the libraries that the documents name. A macro knows no scope, so it replaces members of emitted structs, too.
/// tests/cli/test_macros.py asks the compilers at hand for theirs.
bool is_macro(std::string_view name);

}  // namespace gaussgen::emit
