#pragma once
// The pages of `explain`, one for each code. They are written in explanations/<code>.txt; cmake makes C++ of them.

#include <string>
#include <string_view>
#include <vector>

#include "support/error_codes.hpp"

namespace gaussgen::cli {

/// Errors first, then warnings, by number.
std::vector<support::ErrorCode> all_codes();

struct Page {
  const char* code;
  /// Sentences; a line `example:`, which may state options; the lines of a model that begin with `- ` where they are
  /// wrong, with `+ ` where that is put right, and with two blanks elsewhere. \xHH is a byte that cannot be shown.
  const char* text;
};

/// In the order of their codes.
const std::vector<Page>& pages();

struct Explanation {
  std::string about;
  std::string options;  ///< of gauss-gen
  std::string example;  ///< with the marks
  std::string wrong;
  std::string right;
};

Explanation explanation_of(const Page& page);

}  // namespace gaussgen::cli
