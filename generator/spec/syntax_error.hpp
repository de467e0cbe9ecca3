#pragma once
// yaml-cpp's terse reports, said so that the writer of a model file knows what to do.

#include <string>

#include "support/diagnostics.hpp"

namespace gaussgen::spec {

/// `offset` and `text` are those of yaml-cpp's exception.
void report_syntax_error(const support::Source& source, std::uint32_t offset, const std::string& text,
                         support::Diagnostics& diagnostics);

/// True, and a report, if a bracket before `offset` is never closed.
bool report_open_bracket(const support::Source& source, std::uint32_t offset, support::Diagnostics& diagnostics);

}  // namespace gaussgen::spec
