#pragma once
// Which numbers of formulas are written as decimals: those of the model that are, and what comes from them.

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace gaussgen::lower {

/// Knows the decimals in the expressions of a model. Values of parameters do not count, since formulas show their names;
/// neither does 0.5 with the other integers over powers of 2: kinetic energies are full of halves.
class DecimalStyle {
 public:
  DecimalStyle() = default;
  explicit DecimalStyle(const model::Model& model);

  /// Whether the model has any.
  bool is_used() const { return !written_.empty(); }

  /// "9.81" for 981/100; nothing for a number that reads better as a fraction.
  std::optional<std::string> operator()(const support::Rational& value) const;

 private:
  void collect(const model::Ast& ast);
  bool is_written(const support::Rational& value) const;

  std::vector<support::Rational> written_;
};

}  // namespace gaussgen::lower
