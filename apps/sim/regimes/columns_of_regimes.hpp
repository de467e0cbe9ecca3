#pragma once
// Columns of a run through regimes: what one of them has is 0 in others, as the reaction of a contact that is open.

#include "sim/output/columns.hpp"
#include "sim/regimes/regime_source.hpp"

namespace gausssim {

/// As choose_columns of the ground regime, with what contacts and friction have when they act; `modes` is a group of its own.
Columns columns_of_regimes(const Described& ground, const std::vector<Word>& wanted, RegimeSource& regimes,
                           gaussgen::support::Diagnostics& diagnostics, const ListEverything& list);

/// The contact, friction or link whose mode a column shows; empty: none.
const std::string& switch_in_column(const Column& column);

/// In tables: 0 open, free or broken; 1 closed, sticking or holding; 2 sliding, forwards; -2 backwards.
double number_of_mode(const std::string& mode);

}  // namespace gausssim
