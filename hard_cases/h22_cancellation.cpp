// Sums that lose their digits as they are written, and keep them in emitted code (docs/decisions/0011-cancellation.md): a smaller form of
// tests/headers/test_digits.cpp.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "registry.hpp"
#include "sums.hpp"

namespace hard_cases {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;
using Quantities = gauss::sums::Quantities<double>;

constexpr int k_arguments = 5000;
constexpr double k_length = 0.7;

struct Form {
  const char* id;
  const char* formula;
  double Quantities::*emitted;
  double (*written)(double);
  Wide (*exact)(const Wide&);  ///< by a form that loses nothing
};

Wide squared(const Wide& x) { return x * x; }

const Form k_forms[] = {
    {"H22.cosine", "1 - cos x", &Quantities::cosine, [](double x) { return 1 - std::cos(x); },
     [](const Wide& x) { return Wide(2 * squared(sin(Wide(x / 2)))); }},
    {"H22.squared", "1 - cos² x", &Quantities::squared, [](double x) { return 1 - std::cos(x) * std::cos(x); },
     [](const Wide& x) { return squared(sin(x)); }},
    {"H22.hyperbolic", "cosh x - 1", &Quantities::hyperbolic, [](double x) { return std::cosh(x) - 1; },
     [](const Wide& x) { return Wide(2 * squared(sinh(Wide(x / 2)))); }},
    {"H22.root", "sqrt(L² + x²) - L", &Quantities::root,
     [](double x) { return std::sqrt(k_length * k_length + x * x) - k_length; },
     [](const Wide& x) { return Wide(x * x / (sqrt(Wide(squared(Wide(k_length)) + x * x)) + Wide(k_length))); }},
    {"H22.exponential", "exp x - 1", &Quantities::exponential, [](double x) { return std::exp(x) - 1; },
     [](const Wide& x) { return Wide(2 * sinh(Wide(x / 2)) * exp(Wide(x / 2))); }},
};

double emitted(const Form& form, double x) {
  gauss::sums::Parameters<double> parameters;
  parameters.L = k_length;
  gauss::sums::Inputs<double> inputs;
  inputs.x = inputs.y = x;
  Quantities result{};
  (void)quantities(0.0, gauss::sums::State<double>{}, inputs, prepare(parameters), result);
  return result.*form.emitted;
}

/// In units of the last digit; of values below the normal numbers, in those of the least normal one.
double ulps(double found, const Wide& exact) {
  const double size = std::max(std::abs(static_cast<double>(exact)), std::numeric_limits<double>::min());
  return static_cast<double>(abs(Wide(found) - exact)) / (std::nextafter(size, 2 * size + 1) - size);
}

}  // namespace

std::vector<Figure> cancellation(const Scope&) {
  std::vector<Figure> result;
  for (const Form& form : k_forms) {
    double naive = 0, ours = 0;
    for (int i = 0; i < k_arguments; ++i) {
      const double x = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -150.0 + 152.0 * i / (k_arguments - 1));
      const Wide exact = form.exact(Wide(x));
      grow(naive, ulps(form.written(x), exact));
      grow(ours, ulps(emitted(form, x), exact));
    }
    result.push_back(
        {form.id, std::string(form.formula) + ", 5000 arguments from 1e-150 to 100", "ulp", naive, ours, 4});
  }
  return result;
}

}  // namespace hard_cases
