// Sums that lose their digits as they are written, and keep them in emitted code (docs/decisions/0011-cancellation.md): a smaller form of
// tests/headers/test_digits.cpp.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "near_places.hpp"
#include "poles.hpp"
#include "registry.hpp"
#include "sums.hpp"
#include "taut_string.hpp"

namespace hard_cases {

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;
using Real = double (*)(double);

constexpr int k_arguments = 100000;
constexpr double k_length = 0.7, k_far = 1e6;
/// What is not a rule alone: a rule within four operations more, each of which rounds once.
constexpr double k_state_bar = 8;

struct Form {
  const char* id;
  const char* formula;
  Real emitted;
  Real written;
  Wide (*exact)(const Wide&);  ///< by a form that loses nothing
  double from = -100;
};

Wide squared(const Wide& x) { return x * x; }

gauss::sums::Quantities<double> sums(double x) {
  gauss::sums::Parameters<double> parameters;
  parameters.L = k_length;
  gauss::sums::Inputs<double> inputs;
  inputs.x = inputs.y = x;
  gauss::sums::Quantities<double> result{};
  (void)quantities(0.0, gauss::sums::State<double>{}, inputs, prepare(parameters), result);
  return result;
}

gauss::poles::Quantities<double> poles(double x) {
  gauss::poles::State<double> state;
  state.q() = x;
  state.q_dot() = 1;
  gauss::poles::Quantities<double> result{};
  (void)quantities(0.0, state, gauss::poles::Inputs<double>{}, prepare(gauss::poles::Parameters<double>{}), result);
  return result;
}

const Form k_forms[] = {
    {"H22.cosine", "1 - cos x", [](double x) { return sums(x).cosine; }, [](double x) { return 1 - std::cos(x); },
     [](const Wide& x) { return Wide(2 * squared(sin(Wide(x / 2)))); }},
    {"H22.squared", "1 - cos² x", [](double x) { return sums(x).squared; },
     [](double x) { return 1 - std::cos(x) * std::cos(x); }, [](const Wide& x) { return squared(sin(x)); }},
    {"H22.hyperbolic", "cosh x - 1", [](double x) { return sums(x).hyperbolic; },
     [](double x) { return std::cosh(x) - 1; }, [](const Wide& x) { return Wide(2 * squared(sinh(Wide(x / 2)))); }},
    {"H22.root", "sqrt(L² + x²) - L", [](double x) { return sums(x).root; },
     [](double x) { return std::sqrt(k_length * k_length + x * x) - k_length; },
     [](const Wide& x) { return Wide(x * x / (sqrt(Wide(squared(Wide(k_length)) + x * x)) + Wide(k_length))); }},
    {"H22.exponential", "exp x - 1", [](double x) { return sums(x).exponential; },
     [](double x) { return std::exp(x) - 1; },
     [](const Wide& x) { return Wide(2 * sinh(Wide(x / 2)) * exp(Wide(x / 2))); }},
    {"H22.logarithm", "log(1 + x)", [](double x) { return sums(x).logarithm; },
     [](double x) { return std::log(1 + x); }, [](const Wide& x) { return log1p(x); }, -1},
    {"H22.quotient", "(1 - cos x)/x²", [](double x) { return poles(x).versine; },
     [](double x) { return (1 - std::cos(x)) / (x * x); },
     [](const Wide& x) { return Wide(2 * squared(Wide(sin(Wide(x / 2)) / x))); }},
};

/// In units of the last digit; beyond all bars where it is no number.
double ulps(double found, const Wide& exact) {
  if (!std::isfinite(found)) return 1e300;
  const double size = std::abs(static_cast<double>(exact));
  return static_cast<double>(abs(Wide(found) - exact)) / (std::nextafter(size, 2 * size) - size);
}

struct Errors {
  double naive = 0, ours = 0;
};

/// Where the value is a normal number: below, no form has all digits.
Errors errors(const Form& form) {
  Errors result;
  for (int i = 0; i < k_arguments; ++i) {
    const double x = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -300.0 + 302.0 * i / (k_arguments - 1));
    const Wide exact = x > form.from ? form.exact(Wide(x)) : Wide(0);
    if (abs(exact) < std::numeric_limits<double>::min()) continue;
    grow(result.naive, ulps(form.written(x), exact));
    grow(result.ours, ulps(form.emitted(x), exact));
  }
  return result;
}

/// Of two places 1e6 m from the origin and 1 nm to 1 km from each other; as it is written, with the squares multiplied out.
Errors errors_of_gaps() {
  Errors result;
  const auto prepared = prepare(gauss::near_places::Parameters<double>{});
  for (int i = 0; i < k_arguments; ++i) {
    const double gap = std::pow(10.0, -9.0 + 12.0 * i / (k_arguments - 1));
    const double way[3] = {gap * std::cos(i), gap * std::sin(i) * std::cos(0.7 * i),
                           gap * std::sin(i) * std::sin(0.7 * i)};
    gauss::near_places::State<double> state{};
    Wide square = 0;
    double multiplied_out = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = state.values[k] = k_far, b = state.values[3 + k] = k_far + way[k];
      square += squared(Wide(a) - b);
      multiplied_out += a * a - 2 * a * b + b * b;
    }
    if (square == 0) continue;  // rounded to one place
    gauss::near_places::Quantities<double> found;
    (void)quantities(0.0, state, gauss::near_places::Inputs<double>{}, prepared, found);
    const Wide exact = sqrt(square);
    grow(result.naive, ulps(std::sqrt(std::abs(multiplied_out)), exact));
    grow(result.ours, ulps(found.gap, exact));
  }
  return result;
}

/// Of a bead that is 1e-7 m to 1e-5 m beside a string which is just taut: what pulls it back, and what that has stored.
struct OfString {
  Errors acceleration, energy;
};
OfString errors_of_string() {
  namespace emitted = gauss::taut_string;
  const emitted::Parameters<double> p;
  const auto prepared = prepare(p);
  OfString result;
  for (int i = 0; i < k_arguments; ++i) {
    const double x = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -7.0 + 2.0 * i / (k_arguments - 1));
    const emitted::State<double> state{{x, 0}};
    emitted::Derivative<double> rate;
    emitted::Energy<double> stored;
    (void)rhs(0.0, state, emitted::Inputs<double>{}, prepared, rate);
    (void)energy(0.0, state, prepared, stored);
    const double length = std::sqrt(p.L * p.L + x * x), longer = length - p.L;
    const Wide exact_length = sqrt(Wide(squared(Wide(p.L)) + squared(Wide(x)))), exact = exact_length - Wide(p.L);
    const Wide exact_acceleration = -2 * Wide(p.k) / Wide(p.m) * exact * Wide(x) / exact_length;
    grow(result.acceleration.naive, ulps(-2 * p.k / p.m * longer * x / length, exact_acceleration));
    grow(result.acceleration.ours, ulps(rate.values[1], exact_acceleration));
    grow(result.energy.naive, ulps(p.k * longer * longer, Wide(p.k) * squared(exact)));
    grow(result.energy.ours, ulps(stored.potential, Wide(p.k) * squared(exact)));
  }
  return result;
}

}  // namespace

std::vector<Figure> cancellation(const Scope&) {
  std::vector<Figure> result;
  for (const Form& form : k_forms) {
    const Errors found = errors(form);
    result.push_back({form.id, std::string(form.formula) + ", 1e5 arguments of both signs from 1e-300 to 100", "ulp",
                      found.naive, found.ours, 4});
  }
  const Errors gaps = errors_of_gaps();
  result.push_back(
      {"H22.gap", "distance of 1e5 pairs of places 1e6 m away, 1e-9 m to 1 km apart", "ulp", gaps.naive, gaps.ours, 4});
  const OfString string = errors_of_string();
  const char* remark = "a bead 1e-7 m to 1e-5 m beside a string that is just taut, 1e5 states";
  result.push_back({"H22.small", "acceleration at a small state", "ulp", string.acceleration.naive,
                    string.acceleration.ours, k_state_bar, 0, 0, remark});
  result.push_back({"H22.small_energy", "potential energy at a small state", "ulp", string.energy.naive,
                    string.energy.ours, k_state_bar, 0, 0, remark});
  return result;
}

}  // namespace hard_cases
