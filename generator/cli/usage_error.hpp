#pragma once

#include <stdexcept>

namespace gaussgen::cli {

/// A wrong command line; the message is for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gaussgen::cli
