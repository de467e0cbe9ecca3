#pragma once
// Names for what is used often or never written out: values, and entries of inverses of symbolic matrices.

#include <string>
#include <variant>
#include <vector>

#include "symbolic/vector.hpp"

namespace gaussgen::symbolic {

/// symbol := value, so that the value is lowered (and emitted) once.
struct Definition {
  std::string name;
  ex symbol;
  ex value;
};

/// `entries` is the inverse of `matrix`, entry by entry a symbol, bound to numbers by a factorisation when evaluated.
struct OpaqueInverse {
  std::string name;               ///< such as g_up
  std::vector<std::string> rows;  ///< labels of the rows of the inverse
  std::vector<std::string> columns;
  bool is_symmetric = false;  ///< and positive definite: a metric
  Matrix matrix;
  Matrix entries;
};

using Binding = std::variant<Definition, OpaqueInverse>;

/// All bindings of a model, each after those that it mentions.
class Bindings {
 public:
  /// A symbol for `value`; the value itself where that is a number or a symbol.
  ex define(const std::string& name, const ex& value);

  /// The inverse of `matrix`. Blocks that do not touch each other are inverted one by one, blocks of one or two rows
  /// explicitly, larger ones never: expressions do not swell. `rows` and `columns` label the inverse.
  Matrix invert(const std::string& name, const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                const Matrix& matrix, bool is_symmetric);

  const std::vector<Binding>& all() const { return all_; }

 private:
  Matrix invert_block(OpaqueInverse block);

  std::vector<Binding> all_;
};

}  // namespace gaussgen::symbolic
