#include "support/diagnostics.hpp"

#include <utility>

namespace gaussgen::support {

void Diagnostics::add(Diagnostic finding) {
  if (finding.severity == Severity::error) ++errors_;
  all_.push_back(std::move(finding));
}

void Diagnostics::error(std::string code, Span span, std::string message, std::string hint) {
  add({Severity::error, std::move(code), span, std::move(message), std::move(hint)});
}

void Diagnostics::warning(std::string code, Span span, std::string message, std::string hint) {
  add({Severity::warning, std::move(code), span, std::move(message), std::move(hint)});
}

}  // namespace gaussgen::support
