#pragma once
// What an expression is measured in. Private to the folder.

#include <optional>
#include <string>

#include "model/model.hpp"

namespace gaussgen::model {

struct Measure {
  enum class Kind {
    unknown,  ///< something in it has no unit, or is reported already: fits everything
    literal,  ///< numbers and pi alone: has the unit of its place
    known,
  } kind = Kind::unknown;
  Dimension dimension = {};
  std::string written = {};  ///< the user's unit, where the quantity has one name; else empty
};

Measure known(const Dimension& dimension);

/// Of a name in an expression, or of what a table gives; unknown when it has no unit or is not declared.
Measure measure_of(const Model& model, const std::string& symbol);

/// What a table has to be called with.
Measure measure_of_argument(const Table& table);

/// "m/s", "kN" as the user wrote it; "1".
std::string unit_of(const Measure& measure);

/// "in m/s", "in kN" as the user wrote it, "a plain number".
std::string phrase(const Measure& measure);

/// Which name in the expressions has which unit: "'x' is in m, 'r' in mm"; empty when there are none.
std::string units_of_names(const Model& model, const std::vector<const Ast*>& expressions);

}  // namespace gaussgen::model
