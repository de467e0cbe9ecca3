#pragma once
// `$i` and `$(i - 1)` in names and expressions: whole numbers that are known while a file is read. Private to the folder.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// What each name after `$` stands for.
using Indices = std::map<std::string, std::int64_t>;

inline constexpr std::int64_t k_largest_index = 1'000'000;

enum class UnknownIndex { error, keep };

/// The text with its indices replaced by numbers.
spec::LocatedText with_indices(const spec::LocatedText& text, const Indices& indices, UnknownIndex unknown,
                               support::Diagnostics& diagnostics);

/// Every text of the tree likewise; in `about` a `$` may be a dollar.
spec::Node with_indices(spec::Node node, const Indices& indices, support::Diagnostics& diagnostics);

/// A whole number, or a formula over `indices` without `$`; nothing after a report.
std::optional<std::int64_t> whole_number(const spec::LocatedText& text, const Indices& indices,
                                         support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
