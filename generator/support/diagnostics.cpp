#include "support/diagnostics.hpp"

#include <utility>

namespace gaussgen::support {

void Diagnostics::error(std::string code, Span span, std::string message, std::string hint) {
  all_.push_back({Severity::error, std::move(code), span, std::move(message), std::move(hint)});
  ++errors_;
}

void Diagnostics::warning(std::string code, Span span, std::string message, std::string hint) {
  all_.push_back({Severity::warning, std::move(code), span, std::move(message), std::move(hint)});
}

}  // namespace gaussgen::support
