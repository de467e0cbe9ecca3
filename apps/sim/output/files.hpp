#pragma once
// Where tables and summaries go.

#include <string>
#include <vector>

namespace gausssim {

/// Beside its table.
std::string summary_path(const std::string& csv);

/// Throws cli::UsageError where a table or its summary would take the place of something that is no such thing, or of a file in `inputs`. `csv` "-": standard output.
void check_outputs(const std::string& csv, const std::vector<std::string>& inputs);

}  // namespace gausssim
