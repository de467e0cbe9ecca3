#pragma once
// Quad for libraries that look functions of numbers up by the namespace of the number.

#include <boost/multiprecision/float128.hpp>
#include <memory>
#include <vector>

#include "sim/drive/functions.hpp"
#include "sim/drive/numbers.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

/// Of the same bytes as Quad.
using Wide = boost::multiprecision::float128;
static_assert(sizeof(Wide) == sizeof(Quad) && alignof(Wide) == alignof(Quad));

inline Quad narrow(const Wide& value) { return value.backend().value(); }

inline std::vector<Wide> widened(const std::vector<Quad>& values) {
  return std::vector<Wide>(values.begin(), values.end());
}

inline Numbers<Wide> widened(const Numbers<Quad>& values) {
  Numbers<Wide> result;
  for (const Quad& value : values) result.emplace_back(value);
  return result;
}

/// The same functions of the same model; `functions` need not outlive them.
inline std::shared_ptr<const Functions<Wide>> widened(const Functions<Quad>& functions) {
  auto result = std::make_shared<Functions<Wide>>();
  result->n_q = functions.n_q;
  result->n_v = functions.n_v;
  result->prepared = widened(functions.prepared);
  result->inputs = widened(functions.inputs);
  result->units = functions.units;
  result->energy_layout = functions.energy_layout;
  result->is_constrained = functions.is_constrained;
  const auto bound = [&](const Callable<Quad>& function) {
    Callable<Wide> same(function);
    if (same) same.bind(result->prepared.data(), result->inputs.data());
    return same;
  };
  result->rates = bound(functions.rates);
  result->projection = bound(functions.projection);
  result->energy = bound(functions.energy);
  return result;
}

}  // namespace gausssim
