// Sums and products that lose digits as they are written keep them in emitted code: against a hundred digits, beside the same formula as it is
// written (catalogue H22, docs/decisions/0011-cancellation.md).

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "catch_shim.hpp"
#include "near_places.hpp"
#include "poles.hpp"
#include "sums.hpp"

namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;
using Reference = std::function<Wide(const Wide&)>;
using Form = std::function<double(double)>;
using Coefficient = std::function<Wide(int)>;

constexpr int k_arguments = 100000;
constexpr int k_near_one = 20000;
constexpr double k_bar = 4;

/// Log-spaced, every second one negative: from 1e-300 to 1e2, then once more where roundings of all kinds meet, from 1e-3 on.
double argument(int i) {
  const double size = i < k_arguments ? std::pow(10.0, -300.0 + 302.0 * i / (k_arguments - 1))
                                      : std::pow(10.0, -3.0 + 5.0 * (i - k_arguments) / (k_near_one - 1));
  return i % 2 == 0 ? size : -size;
}

/// In units of the last digit of the value in the type S, or of `least` where that is larger; beyond all bars where it is no number.
template <class S, class Exact>
double ulps(S found, const Exact& exact, double least) {
  if (!std::isfinite(found)) return 1e300;
  const S size = static_cast<S>(std::max(std::fabs(static_cast<double>(exact)), least));
  const S ulp = std::nextafter(size, 2 * size + 1) - size;
  const Exact difference = Exact(found) - exact;
  return static_cast<double>(Exact(difference < 0 ? Exact(-difference) : difference) / Exact(ulp));
}

/// Σ c_k y^k and its slope by y; all of these converge everywhere, and lose 87 of their digits at most for |x| below 100.
struct Series {
  Wide value = 0, slope = 0;
};

const Wide k_negligible("1e-110");

Series series(const std::vector<Wide>& c, const Wide& y) {
  Series sum;
  Wide power = 1, before = 0;
  const bool falls = boost::multiprecision::abs(y) < 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Wide term = c[k] * power;
    sum.value += term;
    sum.slope += Wide(k) * c[k] * before;
    if ((k > 8 || (k > 1 && falls)) && boost::multiprecision::abs(term) < k_negligible) break;
    before = power;
    power *= y;
  }
  return sum;
}

/// Of a coefficient of k and of 1/(2k + n)!.
std::vector<Wide> coefficients(
    int n, const Coefficient& factor = [](int) { return Wide(1); }) {
  std::vector<Wide> c;
  Wide factorial = 1;
  for (int i = 2; i <= n; ++i) factorial *= i;
  for (int k = 0; k < 260; ++k) {
    c.push_back(factor(k) / factorial);
    factorial *= (2 * k + n + 1);
    factorial *= (2 * k + n + 2);
  }
  return c;
}

const std::vector<Wide> k_sine = coefficients(1), k_versine = coefficients(2), k_excess = coefficients(3),
                        k_bend = coefficients(3, [](int k) { return Wide(2 * k + 2); });

Wide even(const std::vector<Wide>& c, int sign, const Wide& x) { return series(c, sign * x * x).value; }
Wide slope(const std::vector<Wide>& c, int sign, const Wide& x) { return 2 * sign * x * series(c, sign * x * x).slope; }

/// A value of emitted code, in double for the parameters of the test, and in float and double for those that float has of them.
struct Emitted {
  Form in_double, in_float, beside_float;
};

struct Case {
  const char* name;
  Emitted emitted;
  Form as_written;
  Reference exact;
  /// Where it has a value, and no overflow in float.
  double from = -100, to = 100;
  /// Where values have zeros at which no form in double has digits, the size of its parts; else 0.
  Form size = [](double) { return 0.0; };
  double bar = k_bar;
  bool loses_digits = true;  ///< as it is written
};

struct Worst {
  double emitted = 0, as_written = 0, in_float = 0;
};

/// What is below the range of normal numbers has fewer digits in any form.
template <class S, class Exact>
bool is_normal(const Exact& exact) {
  return !(exact > -Exact(std::numeric_limits<S>::min()) && exact < Exact(std::numeric_limits<S>::min()));
}

/// Against double, of which the digits are known by then.
double in_float(const Case& tested, double x) {
  const double rounded = static_cast<float>(x);
  if (!is_normal<float>(rounded)) return 0;
  const double exact = tested.emitted.beside_float(rounded);
  if (!is_normal<float>(exact) || std::fabs(exact) > std::numeric_limits<float>::max()) return 0;
  const float found = static_cast<float>(tested.emitted.in_float(rounded));
  return ulps(found, exact, tested.size(rounded));
}

Worst worst_of(const Case& tested) {
  Worst worst;
  for (int i = 0; i < k_arguments + k_near_one; ++i) {
    const double x = argument(i);
    if (!(x > tested.from && x < tested.to)) continue;
    worst.in_float = std::max(worst.in_float, in_float(tested, x));
    const Wide exact = tested.exact(Wide(x));
    if (!is_normal<double>(exact)) continue;
    const double least = tested.size(x);
    worst.emitted = std::max(worst.emitted, ulps(tested.emitted.in_double(x), exact, least));
    worst.as_written = std::max(worst.as_written, ulps(tested.as_written(x), exact, least));
  }
  std::printf("%-22s %6.2f ulp emitted, %6.2f in float, %9.2g as it is written\n", tested.name, worst.emitted,
              worst.in_float, worst.as_written);
  return worst;
}

void check(const std::vector<Case>& cases) {
  for (const Case& tested : cases) {
    INFO(tested.name);
    const Worst worst = worst_of(tested);
    CHECK(worst.emitted <= tested.bar);
    CHECK(worst.in_float <= tested.bar);
    if (tested.loses_digits) CHECK(worst.as_written > 1e6);
  }
}

constexpr double k_offset = 1e-9;
constexpr double k_length = 0.7;

template <class S>
auto sums_at(S x, S length = S(k_length), S offset = S(k_offset)) {
  gauss::sums::Parameters<S> parameters;
  parameters.L = length;
  parameters.h = offset;
  gauss::sums::Inputs<S> inputs;
  inputs.x = inputs.y = x;
  gauss::sums::Quantities<S> result{};
  (void)quantities(S(0), gauss::sums::State<S>{}, inputs, prepare(parameters), result);
  return result;
}

template <class S>
gauss::poles::Quantities<S> poles_at(const S& x) {
  gauss::poles::State<S> state;
  state.q() = x;
  state.q_dot() = S(1);
  gauss::poles::Quantities<S> result{};
  (void)quantities(S(0), state, gauss::poles::Inputs<S>{}, prepare(gauss::poles::Parameters<S>{}), result);
  return result;
}

/// `of` takes one value out of all.
template <class Of>
Emitted of_sums(Of of) {
  constexpr auto k_short_length = static_cast<float>(k_length), k_short_offset = static_cast<float>(k_offset);
  return {[of](double x) { return of(sums_at(x)); }, [of](double x) { return double(of(sums_at(float(x)))); },
          [of](double x) { return of(sums_at<double>(x, k_short_length, k_short_offset)); }};
}
template <class Of>
Emitted of_poles(Of of) {
  return {[of](double x) { return of(poles_at(x)); }, [of](double x) { return double(of(poles_at(float(x)))); },
          [of](double x) { return of(poles_at(x)); }};
}

#define GAUSS_VALUE(name) [](const auto& values) { return values.name; }

Wide one_less_cosine(const Wide& x) { return x * x * even(k_versine, -1, x); }
Wide exact_sine(const Wide& x) { return x * even(k_sine, -1, x); }

/// √(L² + x²) - L as the solution r of r (2 L + r) = x².
Wide exact_root(const Wide& x) {
  const Wide L(k_length);
  if (boost::multiprecision::abs(x) > Wide(1e-3)) return sqrt(L * L + x * x) - L;
  Wide r = 0;
  Wide before = -1;
  for (; r != before; r = x * x / (2 * L + r)) before = r;
  return r;
}

/// Σ x^k c_k from the first power on, for small x.
Wide powers(const Wide& x, const std::function<Wide(int)>& c) {
  Wide sum = 0, power = x;
  for (int k = 1; k < 40 && boost::multiprecision::abs(power) > k_negligible * boost::multiprecision::abs(x);
       ++k, power *= x)
    sum += c(k) * power;
  return sum;
}

bool is_small(const Wide& x) { return boost::multiprecision::abs(x) < Wide(1e-3); }

Wide exact_exponential(const Wide& x) {
  if (!is_small(x)) return exp(x) - 1;
  return x * x * even(k_versine, 1, x) + x * even(k_sine, 1, x);
}

Wide exact_logarithm(const Wide& x) {
  if (!is_small(x)) return log(1 + x);
  return powers(x, [](int k) { return Wide(k % 2 == 1 ? 1 : -1) / k; });
}

}  // namespace

TEST_CASE("sums of which small arguments leave no digit keep all but four units of the last one") {
  const double L = k_length;
  const Wide wide_L(L), h(k_offset);
  const Form nothing = [](double) { return 0.0; };
  const auto amplitude = [](double x) { return std::fabs(x) > 1 ? k_offset : 0; };
  check({
      {"1 - cos x", of_sums(GAUSS_VALUE(cosine)), [](double x) { return 1 - std::cos(x); }, one_less_cosine},
      {"L - L cos x", of_sums(GAUSS_VALUE(multiple)), [L](double x) { return L - L * std::cos(x); },
       [=](const Wide& x) { return wide_L * one_less_cosine(x); }},
      {"two pairs", of_sums(GAUSS_VALUE(two)),
       [L](double x) { return L - L * std::cos(x) + L * L - L * L * std::cos(x); },
       [=](const Wide& x) { return (wide_L + wide_L * wide_L) * one_less_cosine(x); }},
      {"3 L - 2 L cos x - L cos 2x", of_sums(GAUSS_VALUE(shared)),
       [L](double x) { return 3 * L - 2 * L * std::cos(x) - L * std::cos(2 * x); },
       [=](const Wide& x) { return wide_L * (2 * one_less_cosine(x) + one_less_cosine(2 * x)); }, -50, 50},
      {"1 + cos x", of_sums(GAUSS_VALUE(supplement)), [](double x) { return 1 + std::cos(x); },
       [](const Wide& x) {
         const Wide c = cos(Wide(x / 2));
         return Wide(2 * c * c);
       },
       -100, 100, nothing, k_bar, false},
      {"L^2 - x^2", of_sums(GAUSS_VALUE(squares)), [L](double x) { return L * L - x * x; },
       [=](const Wide& x) { return Wide((wide_L - x) * (wide_L + x)); }, -100, 100, nothing, k_bar, false},
      {"1 - cos^2 x", of_sums(GAUSS_VALUE(squared)), [](double x) { return 1 - std::cos(x) * std::cos(x); },
       [](const Wide& x) { return exact_sine(x) * exact_sine(x); }},
      {"(1-cos x)(1+cos x)", of_sums(GAUSS_VALUE(conjugates)),
       [](double x) { return (1 - std::cos(x)) * (1 + std::cos(x)); },
       [](const Wide& x) { return exact_sine(x) * exact_sine(x); }},
      {"cosh x - 1", of_sums(GAUSS_VALUE(hyperbolic)), [](double x) { return std::cosh(x) - 1; },
       [](const Wide& x) { return x * x * even(k_versine, 1, x); }},
      {"sqrt(L^2 + x^2) - L", of_sums(GAUSS_VALUE(root)), [L](double x) { return std::sqrt(L * L + x * x) - L; },
       exact_root},
      {"e^x - 1", of_sums(GAUSS_VALUE(exponential)), [](double x) { return std::exp(x) - 1; }, exact_exponential},
      {"log(1 + x)", of_sums(GAUSS_VALUE(logarithm)), [](double x) { return std::log(1 + x); }, exact_logarithm, -1},
      {"sin 2x/2x", of_sums(GAUSS_VALUE(doubled)), [](double x) { return std::sin(2 * x) / (2 * x); },
       [](const Wide& x) { return even(k_sine, -1, 2 * x); }, -50, 50,
       [](double x) { return std::fabs(x) > 1 ? 1 / std::fabs(2 * x) : 0; }, k_bar, false},
      {"cos(x + h) - cos x", of_sums(GAUSS_VALUE(cosines)),
       [](double x) { return std::cos(x + k_offset) - std::cos(x); },
       [=](const Wide& x) { return -2 * exact_sine(x + h / 2) * exact_sine(h / 2); }, -100, 100, amplitude},
      {"sin(x + h) - sin x", of_sums(GAUSS_VALUE(sines)), [](double x) { return std::sin(x + k_offset) - std::sin(x); },
       [=](const Wide& x) { return 2 * cos(x + h / 2) * exact_sine(h / 2); }, -100, 100, amplitude},
  });
}

TEST_CASE("1 + cos x next to a half turn, and a difference of squares next to zero, keep theirs") {
  const double pi = 3.14159265358979323846;
  double cosine = 0, as_written = 0, squares = 0, squares_as_written = 0;
  for (int i = 1; i <= 50; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const double x = pi + sign * std::pow(2.0, -i), y = k_length * (1 + sign * std::pow(2.0, -i));
      const Wide exact = 1 + cos(Wide(x)), difference = Wide(k_length) * k_length - Wide(y) * y;
      cosine = std::max(cosine, ulps(sums_at(x).supplement, exact, 0));
      as_written = std::max(as_written, ulps(1 + std::cos(x), exact, 0));
      squares = std::max(squares, ulps(sums_at(y).squares, difference, 0));
      squares_as_written = std::max(squares_as_written, ulps(k_length * k_length - y * y, difference, 0));
    }
  }
  CHECK(cosine <= k_bar);
  CHECK(as_written > 1e6);
  CHECK(squares <= k_bar);
  CHECK(squares_as_written > 1e6);
}

TEST_CASE(
    "places that are near to each other keep the digits of what lies between them, however far from the origin they "
    "are") {
  namespace places = gauss::near_places;
  const auto prepared = prepare(places::Parameters<double>{});
  double gaps = 0, inner = 0, as_written = 0;
  for (int i = 0; i < k_arguments; ++i) {
    // About 1e6 m away, and from 1e-9 m to 1 km apart, in directions all over the sphere.
    const double gap = std::pow(10.0, -9.0 + 12.0 * i / (k_arguments - 1)), u = std::cos(0.7 * i), v = 1.3 * i;
    const double near[3] = {1e6 + std::sin(i), -1e6 + std::cos(i), 1e6};
    const double way[3] = {gap * std::sqrt(1 - u * u) * std::cos(v), gap * std::sqrt(1 - u * u) * std::sin(v), gap * u};
    places::State<double> state{};
    Wide square = 0;
    double expanded = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = near[k], b = near[k] + way[k];
      state.values[k] = a;
      state.values[3 + k] = b;
      square += (Wide(a) - b) * (Wide(a) - b);
      expanded += a * a - 2 * a * b + b * b;
    }
    state.x() = near[0];
    state.y() = near[1];
    state.theta() = v;
    places::Quantities<double> found;
    (void)quantities(0.0, state, places::Inputs<double>{}, prepared, found);
    const Wide exact = sqrt(square);
    if (exact == 0) continue;  // rounded to one place
    gaps = std::max(gaps, ulps(found.gap, exact, 0));
    as_written = std::max(as_written, ulps(std::sqrt(std::fabs(expanded)), exact, 0));
    inner = std::max(inner, ulps(found.inner, 2 * Wide(places::Parameters<double>{}.r), 0));
  }
  std::printf("gaps at 1e6 m: %.2f ulp, on a body %.2f, multiplied out %.2g\n", gaps, inner, as_written);
  CHECK(gaps <= k_bar);
  CHECK(inner <= k_bar);
  CHECK(as_written > 1e6);
}

TEST_CASE("a root less a length has its sign, and is nothing where both are nothing") {
  for (const double L : {-0.7, 0.0}) {
    gauss::sums::Parameters<double> parameters;
    parameters.L = L;
    gauss::sums::Inputs<double> inputs;
    gauss::sums::Quantities<double> result{};
    for (const double x : {0.0, 0.3, 2.0}) {
      inputs.x = x;
      (void)quantities(0.0, gauss::sums::State<double>{}, inputs, prepare(parameters), result);
      CHECK(std::fabs(result.root - (std::sqrt(L * L + x * x) - L)) <= 4e-16 * (std::fabs(L) + x));
    }
  }
}

TEST_CASE("exponentials less one keep their limits") {
  CHECK(sums_at(-1e5).exponential == -1);
  CHECK(sums_at(800.0).exponential == std::numeric_limits<double>::infinity());
}

TEST_CASE("slopes of such sums, in the Jacobian, are as good") {
  namespace sums = gauss::sums;
  const std::vector<Reference> slopes{
      exact_sine, [](const Wide& x) { return Wide(x / sqrt(Wide(k_length) * k_length + x * x)); },
      [](const Wide& x) { return Wide(exp(x)); }, [](const Wide& x) { return Wide(1 / (1 + x)); },
      [](const Wide& x) { return Wide(x * even(k_sine, 1, x)); }};
  const auto prepared = prepare(sums::Parameters<double>{});
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    double worst = 0;
    for (int k = 0; k < k_arguments; k += 7) {
      const double x = argument(k);
      if (x <= -1 && i == 3) continue;
      sums::State<double> state{};
      state.values[i] = x;
      sums::Jacobian<double> jacobian;
      (void)sums::jacobian(0.0, state, sums::Inputs<double>{}, prepared, jacobian);
      double all[sums::JacobianByState::rows][sums::JacobianByState::columns];
      dense(jacobian, sums::JacobianByState{}, &all[0][0]);
      const Wide exact = slopes[i](Wide(x));
      if (boost::multiprecision::abs(exact) < Wide(std::numeric_limits<double>::min())) continue;
      worst = std::max(worst, ulps(all[slopes.size() + i][i], exact, 0));
    }
    std::printf("slope %zu: %.2f ulp\n", i, worst);
    CHECK(worst <= k_bar);
  }
}

TEST_CASE("products with a limit at 0 keep their digits, and so do their derivatives") {
  using std::cos;
  using std::sin;
  const auto inverse = [](int n) {
    return [n](double x) { return std::fabs(x) > 2 ? std::pow(std::fabs(x), -n) : 0; };
  };
  const Form nothing = [](double) { return 0.0; };
  // What a rounding of the angle by 1 ulp of 1 changes, next to its poles and zeros.
  const Form by_angle = [](double x) {
    const double t = std::tan(x);
    return std::fabs(x) > 1 ? (1 + t * t) / std::fabs(x) : 0;
  };
  const double slope_bar = 8;
  const auto sine = [](const Wide& x) { return even(k_sine, -1, x); };
  check({
      {"sin x/x", of_poles(GAUSS_VALUE(sine)), [](double x) { return sin(x) / x; }, sine, -100, 100, nothing, k_bar,
       false},
      {"x/sin x", of_poles(GAUSS_VALUE(reciprocal)), [](double x) { return x / sin(x); },
       [=](const Wide& x) { return Wide(1 / sine(x)); }, -100, 100, nothing, k_bar, false},
      {"tan x/x", of_poles(GAUSS_VALUE(tangent)), [](double x) { return std::tan(x) / x; },
       [=](const Wide& x) { return Wide(sine(x) / cos(x)); }, -100, 100, by_angle, k_bar, false},
      {"sinh x/x", of_poles(GAUSS_VALUE(hyperbolic)), [](double x) { return std::sinh(x) / x; },
       [](const Wide& x) { return even(k_sine, 1, x); }, -85, 85, nothing, k_bar, false},
      {"(1 - cos x)/x^2", of_poles(GAUSS_VALUE(versine)), [](double x) { return (1 - cos(x)) / (x * x); },
       [](const Wide& x) { return even(k_versine, -1, x); }},
      {"(x - sin x)/x^3", of_poles(GAUSS_VALUE(excess)), [](double x) { return (x - sin(x)) / (x * x * x); },
       [](const Wide& x) { return even(k_excess, -1, x); }},
      {"(sin x - x cos x)/x^3", of_poles(GAUSS_VALUE(bend)),
       [](double x) { return (sin(x) - x * cos(x)) / (x * x * x); }, [](const Wide& x) { return even(k_bend, -1, x); },
       -100, 100, inverse(2)},
      {"(x cos x - sin x)/x^2", of_poles(GAUSS_VALUE(written_slope)),
       [](double x) { return (x * cos(x) - sin(x)) / (x * x); },
       [](const Wide& x) { return Wide(-x * even(k_bend, -1, x)); }, -100, 100, inverse(1)},
      {"(cosh x - 1)/x^2", of_poles(GAUSS_VALUE(hyperbolic_versine)),
       [](double x) { return (std::cosh(x) - 1) / (x * x); }, [](const Wide& x) { return even(k_versine, 1, x); }, -85,
       85},
      {"(sin x/x)'", of_poles(GAUSS_VALUE(sine_slope)), [](double x) { return cos(x) / x - sin(x) / (x * x); },
       [](const Wide& x) { return slope(k_sine, -1, x); }, -100, 100, inverse(1), slope_bar},
      {"((1 - cos x)/x^2)'", of_poles(GAUSS_VALUE(versine_slope)),
       [](double x) { return sin(x) / (x * x) - 2 * (1 - cos(x)) / (x * x * x); },
       [](const Wide& x) { return slope(k_versine, -1, x); }, -100, 100, inverse(2), slope_bar},
      {"((x - sin x)/x^3)'", of_poles(GAUSS_VALUE(excess_slope)),
       [](double x) { return (1 - cos(x)) / (x * x * x) - 3 * (x - sin(x)) / (x * x * x * x); },
       [](const Wide& x) { return slope(k_excess, -1, x); }, -100, 100, inverse(3), slope_bar},
      {"((sin x - x cos x)/x^3)'", of_poles(GAUSS_VALUE(bend_slope)),
       [](double x) { return sin(x) / (x * x) - 3 * (sin(x) - x * cos(x)) / (x * x * x * x); },
       [](const Wide& x) { return slope(k_bend, -1, x); }, -100, 100, inverse(2), slope_bar},
  });
}

TEST_CASE("at 0 they are their limits, in every type") {
  const auto check_limits = [](auto zero) {
    using S = decltype(zero);
    const auto at = poles_at<S>(zero);
    // Numbers in emitted code have 48 digits at least.
    const S third = S(1) / S(3), least = std::max(2 * std::numeric_limits<S>::epsilon(), S(1e-48));
    for (const S& one : {at.sine, at.reciprocal, at.tangent, at.hyperbolic, at.doubled})
      CHECK(abs(one - S(1)) <= least);
    for (const S& half : {at.versine, at.hyperbolic_versine}) CHECK(abs(half - S(1) / S(2)) <= least);
    CHECK(abs(at.bend - third) <= least);
    CHECK(abs(at.excess - third / S(2)) <= least);
    for (const S& none : {at.sine_slope, at.versine_slope, at.excess_slope, at.bend_slope}) CHECK(none == S(0));
  };
  using std::abs;
  check_limits(0.0F);
  check_limits(0.0);
  check_limits(0.0L);
  check_limits(Wide(0));
}

namespace {

/// The largest error of the quotients and of their slopes, for arguments from 1e-30 to 1, relative.
template <class S>
std::pair<double, double> worst_in() {
  double value = 0, rate = 0;
  const auto relative = [](const S& found, const Wide& exact) {
    return static_cast<double>(boost::multiprecision::abs(Wide(found) / exact - 1));
  };
  for (int i = 0; i <= 3000; ++i) {
    const S x = static_cast<S>(std::pow(10.0, -30.0 + i / 100.0));
    const Wide wide(x);
    const auto at = poles_at<S>(x);
    for (const auto& [found, c] :
         {std::pair(at.sine, &k_sine), {at.versine, &k_versine}, {at.excess, &k_excess}, {at.bend, &k_bend}})
      value = std::max(value, relative(found, even(*c, -1, wide)));
    for (const auto& [found, c] : {std::pair(at.sine_slope, &k_sine),
                                   {at.versine_slope, &k_versine},
                                   {at.excess_slope, &k_excess},
                                   {at.bend_slope, &k_bend}})
      rate = std::max(rate, relative(found, slope(*c, -1, wide)));
  }
  std::printf("%d digits: %.2g, slopes %.2g\n", std::numeric_limits<S>::digits10, value, rate);
  return {value, rate};
}

}  // namespace

TEST_CASE("float, long double and types of many digits have those of theirs") {
  // Digits that values and slopes of differences lose above the reach of the series.
  const auto check_type = [](auto zero, int of_values, int of_slopes) {
    using S = decltype(zero);
    const double least = static_cast<double>(std::numeric_limits<S>::epsilon());
    const auto [value, rate] = worst_in<S>();
    CHECK(value <= 4 * least * std::pow(10.0, of_values));
    CHECK(rate <= 16 * least * std::pow(10.0, of_slopes));
  };
  check_type(0.0F, 0, 0);
  check_type(0.0L, 0, 0);
  check_type(boost::multiprecision::cpp_bin_float_quad(0), 1, 2);
  check_type(boost::multiprecision::cpp_bin_float_50(0), 3, 5);
}
