#pragma once
// The number type of references.

#include <string>

namespace gausssim {

/// Four times the digits that results are shown with. Of g++ and clang++ alone, hence the extension.
__extension__ typedef __float128 Quad;

/// All its digits.
std::string text_of(Quad value);
Quad quad_of(const std::string& text);

}  // namespace gausssim
