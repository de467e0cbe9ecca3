#pragma once
// Errors of a model file, collected so that a user sees all of them at once.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "support/source.hpp"

namespace gaussgen::support {

enum class Severity { error, warning };

/// One finding. `code` is stable ("E012"); `hint` says what to do and may be empty.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;
  Span span;
  std::string message;
  std::string hint;
};

/// Collects findings of one Source; stages go on after an error wherever that makes sense.
class Diagnostics {
 public:
  void error(std::string code, Span span, std::string message, std::string hint = {});
  void add(Diagnostic finding);
  void warning(std::string code, Span span, std::string message, std::string hint = {});

  bool has_errors() const { return errors_ > 0; }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

/// That anybody reads.
inline constexpr std::size_t k_most_findings = 100;

enum class Colour { none, ansi };

/// Findings in the order of the text, no more than k_most_findings. `left_out` becomes the number of the others.
std::vector<Diagnostic> in_order(const Diagnostics& diagnostics, std::size_t& left_out);

/// `file:line:col: error[E012]: message`, the source line, a caret, and `hint: …`; sorted by position.
std::string render(const Diagnostics& diagnostics, const Source& source, Colour colour = Colour::none);

}  // namespace gaussgen::support
