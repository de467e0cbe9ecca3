#pragma once
// "Did you mean": the nearest of the names that would have been right.

#include <string>
#include <string_view>
#include <vector>

namespace gaussgen::support {

/// The candidate nearest to `name`, or an empty text when none is near enough to be a slip of the pen.
std::string closest(std::string_view name, const std::vector<std::string>& candidates);

/// Of words of a format also the shortest that `name` begins, as 'value' for 'val'.
std::string closest_or_begun(std::string_view name, const std::vector<std::string>& candidates);

/// "did you mean 'psi'?", or an empty text.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

/// The same of a dozen at most: "a, b, c and 188 more".
std::string joined_first(const std::vector<std::string>& words);

}  // namespace gaussgen::support
