#include "lower/raise.hpp"

#include "ir/traverse.hpp"
#include "support/assert.hpp"
#include "symbolic/choices.hpp"
#include "symbolic/rational.hpp"

namespace gaussgen::lower {

using GiNaC::ex;

ex Raising::operator()(ir::NodeId root) {
  for (const ir::NodeId id : ir::post_order(graph_, {root})) {
    if (memo_.count(id.index) == 0) memo_[id.index] = raised(graph_[id]);
  }
  return known(root);
}

ex Raising::raised(const ir::Node& node) const {
  switch (node.kind) {
    case ir::Kind::constant: return symbolic::number(node.value);
    case ir::Kind::symbol: return resolve_(node.symbol);
    case ir::Kind::named: return known(node.children[0]);
    case ir::Kind::power: return GiNaC::pow(known(node.children[0]), symbolic::number(node.value));
    case ir::Kind::function: return call(node);
    case ir::Kind::sum: {
      ex sum = symbolic::number(node.value);
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        sum += symbolic::number(node.coefficients[i]) * known(node.children[i]);
      }
      return sum;
    }
    case ir::Kind::product: {
      ex product = 1;
      for (const ir::NodeId child : node.children) product *= known(child);
      return product;
    }
  }
  return 0;
}

// A comparison is part of the function that chooses by it.
ex Raising::cases(const ir::Node& node) const {
  const ir::Node& condition = graph_[node.children[0]];
  const ex& a = known(condition.children[0]);
  const ex& b = known(condition.children[1]);
  const ex& yes = known(node.children[1]);
  const ex& no = known(node.children[2]);
  return condition.function == ir::Function::less ? ex(symbolic::case_less(a, b, yes, no))
                                                  : ex(symbolic::case_at_most(a, b, yes, no));
}

ex Raising::call(const ir::Node& node) const {
  const ex& x = known(node.children[0]);
  switch (node.function) {
    case ir::Function::sin: return GiNaC::sin(x);
    case ir::Function::cos: return GiNaC::cos(x);
    case ir::Function::tan: return GiNaC::tan(x);
    case ir::Function::asin: return GiNaC::asin(x);
    case ir::Function::acos: return GiNaC::acos(x);
    case ir::Function::atan: return GiNaC::atan(x);
    case ir::Function::atan2: return GiNaC::atan2(x, known(node.children[1]));
    case ir::Function::exp: return GiNaC::exp(x);
    case ir::Function::log: return GiNaC::log(x);
    case ir::Function::sinh: return GiNaC::sinh(x);
    case ir::Function::cosh: return GiNaC::cosh(x);
    case ir::Function::tanh: return GiNaC::tanh(x);
    case ir::Function::abs: return symbolic::abs_of(x);
    case ir::Function::sign: return symbolic::sign_of(x);
    case ir::Function::min: return symbolic::min_of(x, known(node.children[1]));
    case ir::Function::max: return symbolic::max_of(x, known(node.children[1]));
    case ir::Function::less:
    case ir::Function::at_most: return 0;
    case ir::Function::piecewise: return cases(node);
    case ir::Function::table: return symbolic::table_at(node.table.index, support::to_int(node.value), x);
    default: GAUSS_ASSERT(false, "function {} has no counterpart", ir::name_of(node.function)); return 0;
  }
}

}  // namespace gaussgen::lower
