#pragma once
// Nodes as C++ expressions.

#include <string>
#include <unordered_map>

#include "emit/cpp_tree.hpp"
#include "emit/names.hpp"
#include "passes/writing.hpp"

namespace gaussgen::emit {

class ExpressionWriter {
 public:
  ExpressionWriter(const passes::Writing& writing, const UnitNames& names) : writing_(writing), names_(names) {}

  /// From here on `id` is written by its name.
  void bind(NodeId id, std::string name) { bound_[id.index] = std::move(name); }
  const std::string* bound(NodeId id) const;

  /// A name where there is one, else written out.
  cpp::Expression value(NodeId id) const;
  /// Written out, though there may be a name for it: the right-hand side of a definition.
  cpp::Expression definition(NodeId id) const;
  /// Of type Bool; the constants 0 and 1 are false and true.
  cpp::Expression condition(NodeId id) const;

 private:
  struct Fraction {
    bool is_negative = false;
    std::vector<cpp::Expression> top;
    std::vector<cpp::Expression> bottom;
  };

  cpp::Expression symbol(const ir::Node& node) const;
  cpp::Expression function(const ir::Node& node) const;
  /// abs to piecewise, by selections.
  cpp::Expression choice(const ir::Node& node) const;
  cpp::Expression power(NodeId id) const;
  cpp::Expression sum(const ir::Node& node) const;
  /// factor * id, factor positive
  cpp::Expression scaled(const ir::Rational& factor, NodeId id) const;
  void multiply(Fraction& fraction, NodeId factor) const;
  void divide(Fraction& fraction, NodeId divisor) const;

  const passes::Writing& writing_;
  const UnitNames& names_;
  std::unordered_map<std::uint32_t, std::string> bound_;
};

}  // namespace gaussgen::emit
