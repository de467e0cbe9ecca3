#pragma once
// A model text to its raw tree. The only folder that sees yaml-cpp.

#include <optional>

#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::spec {

inline constexpr int k_deepest_nesting = 32;
inline constexpr int k_most_nodes = 100'000;
inline constexpr std::size_t k_most_written_out = 4'000'000;  ///< bytes, with the texts of all copies
inline constexpr std::size_t k_longest_key = 1024;

/// Stricter than YAML: one document, no repeated keys, no anchors, aliases or tags.
std::optional<Node> read_yaml(const support::Source& source, support::Diagnostics& diagnostics);

/// The same of another file, whose text is put behind those of `source`; its spans count from there.
std::optional<Node> read_yaml_behind(support::Source& source, const std::string& name, const std::string& text,
                                     support::Diagnostics& diagnostics);

}  // namespace gaussgen::spec
