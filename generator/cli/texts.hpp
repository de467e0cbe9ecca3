#pragma once
// Texts that cmake makes C++ of.

namespace gaussgen::cli {

/// starter.yaml, with @name@ for the name of the model.
const char* starter();

}  // namespace gaussgen::cli
