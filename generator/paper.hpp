#pragma once
// The paper's route beside the emitted one.

#include <string>

#include "lower/paper_route.hpp"
#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// The paper's route over the symbols of `mechanics`.
lower::PaperRoute paper_route(Mechanics& mechanics);

/// Puts accelerations, multipliers and reactions of the paper's route in place of the emitted ones. False, with an error,
/// when that route does not take the model. `fold` is that of `mechanics`.
bool take_paper_route(Mechanics& mechanics, bool fold, support::Diagnostics& diagnostics);

/// The paper's objects and equations with their formulas, as Markdown or as a LaTeX document; empty, with an error, when the
/// paper's route does not take the model, or none does.
std::string derivation_text(const model::Model& model, bool latex, support::Diagnostics& diagnostics);

/// The same as Markdown for `--dump=paper`; says why when there is none.
std::string dump_paper(Mechanics& mechanics);

}  // namespace gaussgen
