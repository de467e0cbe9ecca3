#pragma once
// A mechanism that nobody thought of, as a user would write it.

#include <string>

namespace agreement::newton {

/// A tree of 2 to 8 bodies in joints of all types, with forces of all kinds, as a model file; some loops are closed, some contacts
/// roll, some coordinates are held or exchanged for speeds. The same seed gives the same text.
std::string random_mechanism(unsigned seed);

/// Likewise with all that is hard: lengths from 1e-6 to 1e6, masses up to 1e12 apart, stiff springs, several constraints, of which some follow from
/// others (the same again, in other words, as a multiple) or nearly do.
std::string extreme_mechanism(unsigned seed);

}  // namespace agreement::newton
