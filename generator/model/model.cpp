#include "model/model.hpp"

#include "support/assert.hpp"

namespace gaussgen::model {

SymbolRef Model::resolve(const std::string& symbol) const {
  const auto found = symbols.find(symbol);
  GAUSS_ASSERT(found != symbols.end(), "symbol={}", symbol);
  return found->second;
}

}  // namespace gaussgen::model
