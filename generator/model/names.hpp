#pragma once
// Names: what is a valid one, and the one namespace of everything that expressions can mention.

#include "model/reading.hpp"

namespace gaussgen::model {

inline constexpr std::size_t k_longest_name = 64;

/// A name of a body, a force, …: pattern, and no macro of emitted code.
bool check_name(const Name& name, Reading& reading);

/// The name of the model, which becomes a namespace.
void check_model_name(const Name& name, Reading& reading);

/// A symbol of expressions; `what` is "the parameter". A faulty name is entered too, so that its uses raise no second error.
void declare(const Name& name, SymbolKind kind, std::size_t index, const std::string& what, Reading& reading);

/// A table: a function of expressions, which shares their namespace. False for a name that is refused.
bool declare_table(const Name& name, Reading& reading);

/// Names that the emitted code derives, such as chi_dot from the coordinate chi, must be free.
void check_rate_names(Reading& reading);

}  // namespace gaussgen::model
