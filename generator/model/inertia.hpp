#pragma once
// `inertia:` as one expression, three principal moments, or a symmetric matrix. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

Inertia read_inertia(const spec::Entry& entry, Reading& reading);

/// The same expression up to blanks and brackets.
bool same_expression(const Ast& a, const Ast& b);

}  // namespace gaussgen::model
