#pragma once
// A mechanism that nobody thought of, as a user would write it.

#include <string>

namespace agreement::newton {

/// A tree of 2 to 8 bodies in joints of all types, with forces of all kinds, as a model file; some loops are closed, some contacts
/// roll, some coordinates are held or exchanged for speeds. The same seed gives the same text.
std::string random_mechanism(unsigned seed);

}  // namespace agreement::newton
