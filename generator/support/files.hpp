#pragma once
// Texts from the file system.

#include <istream>
#include <optional>
#include <string>

namespace gaussgen::support {

/// More than any model may have, so that the reader refuses what is cut off there; and /dev/zero comes to an end.
inline constexpr std::size_t k_most_read = std::size_t{16} << 20U;

/// At most k_most_read bytes; nothing when reading fails.
std::optional<std::string> read_stream(std::istream& in);

/// Nothing, with the reason in `why`, where there is no file that can be read.
std::optional<std::string> read_file(const std::string& path, std::string& why);

/// Likewise for a file that a model names: no pipe and no device, which would have the reader wait.
std::optional<std::string> read_regular_file(const std::string& path, std::string& why);

}  // namespace gaussgen::support
