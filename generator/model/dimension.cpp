#include "model/dimension.hpp"

#include <algorithm>

namespace gaussgen::model {

Dimension operator*(const Dimension& a, const Dimension& b) {
  Dimension product;
  for (std::size_t i = 0; i < product.powers.size(); ++i) product.powers[i] = a.powers[i] + b.powers[i];
  product.angle = a.angle + b.angle;
  return product;
}

Dimension operator/(const Dimension& a, const Dimension& b) { return a * power(b, -1); }

Dimension power(const Dimension& base, const support::Rational& exponent) {
  Dimension result;
  for (std::size_t i = 0; i < result.powers.size(); ++i) result.powers[i] = base.powers[i] * exponent;
  result.angle = base.angle * exponent;
  return result;
}

bool agree(const Dimension& a, const Dimension& b) {
  return std::equal(a.powers.begin(), a.powers.end(), b.powers.begin(),
                    [](const auto& x, const auto& y) { return x == y; });
}

bool is_number(const Dimension& dimension) { return agree(dimension, {}); }

}  // namespace gaussgen::model
