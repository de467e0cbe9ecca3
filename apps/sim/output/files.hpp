#pragma once
// Where tables and summaries go.

#include <string>
#include <vector>

namespace gausssim {

/// Beside its table.
std::string summary_path(const std::string& csv);

/// Of study.html as of study, where each of several files has an ending of its own: `path` without one of these.
std::string without_ending(const std::string& path, const std::vector<std::string>& endings);

/// What happened on the way, of a model with regimes.
std::string events_path(const std::string& csv);

/// Makes the folder of a file that is to be written at the end, and throws cli::FileError where the file could not be: before anything is computed.
void check_writable(const std::string& path);

/// Throws cli::UsageError where a table or its summary would take the place of something that is no such thing, or of a file in `inputs`; and as check_writable. `csv` "-": standard output.
void check_outputs(const std::string& csv, const std::vector<std::string>& inputs);

}  // namespace gausssim
