#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/diagnostics.hpp"

namespace gaussgen::cli {

/// A wrong command line; the message is for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// Of an expression that is given to an option.
  UsageError(const std::string& text, std::string option, std::vector<support::Diagnostic> findings)
      : runtime_error(text), option_(std::move(option)), findings_(std::move(findings)) {}

  const std::string& option() const { return option_; }
  const std::vector<support::Diagnostic>& findings() const { return findings_; }

 private:
  std::string option_;
  std::vector<support::Diagnostic> findings_;
};

}  // namespace gaussgen::cli
