// Rounding in emitted code: chains of 2 to 4 links in double and in float, against 50 digits.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "gauss/model_concept.hpp"
#include "planar_chain_relative_2.hpp"
#include "planar_chain_relative_3.hpp"
#include "planar_chain_relative_4.hpp"
#include "process.hpp"
#include "registry.hpp"
#include "sized.hpp"

namespace hard_cases {

GAUSS_MODEL(Chain2, gauss::planar_chain_relative_2);
GAUSS_MODEL(Chain3, gauss::planar_chain_relative_3);
GAUSS_MODEL(Chain4, gauss::planar_chain_relative_4);

namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;
constexpr int k_states = 1000;  // of each chain

struct Errors {
  std::vector<double> ulps = {};  ///< of every acceleration, in units of its last digit
  double by_size = 0;             ///< largest, by eps S
  int not_ok = 0;

  double quantile(double share) {
    if (ulps.empty() || not_ok > 0) return k_breaks_down;
    const auto at = ulps.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(ulps.size() - 1));
    std::nth_element(ulps.begin(), at, ulps.end());
    return *at;
  }
};

/// Numbers that all types hold exactly: otherwise models would differ, and not roundings.
template <class Model, class S>
auto prepared() {
  typename Model::template Parameters<S> p;
  p.m = S(1.25);
  p.L = S(0.75);
  p.Ja = S(0.0009765625);
  p.g = S(9.8125);
  return Model::prepare(p);
}

/// Accelerations of the chain in S.
template <class Model, class S, class Given>
std::vector<S> accelerations(const std::vector<Given>& state, bool& is_ok) {
  typename Model::template State<S> at;
  for (std::size_t i = 0; i < state.size(); ++i) at.values[i] = S(state[i]);
  typename Model::template Derivative<S> derivative;
  is_ok = Model::rhs(S(0), at, {}, prepared<Model, S>(), derivative) == gauss::Status::ok;
  return {derivative.values + Model::n_q, derivative.values + Model::n_q + Model::n_v};
}

template <class Model, class S>
void add(Errors& errors) {
  std::mt19937 random(20230u + static_cast<unsigned>(Model::n_q));
  std::uniform_real_distribution<S> angle(-3, 3);
  constexpr S eps = std::numeric_limits<S>::epsilon();
  for (int k = 0; k < k_states; ++k) {
    std::vector<S> state(2 * Model::n_q);
    for (S& x : state) x = angle(random);
    bool is_ok = true, is_wide_ok = true, is_sized_ok = true;
    const auto found = accelerations<Model, S>(state, is_ok);
    const auto exact = accelerations<Model, Wide>(state, is_wide_ok);
    const auto sized = accelerations<Model, Sized>(state, is_sized_ok);
    if (!(is_ok && is_wide_ok && is_sized_ok)) ++errors.not_ok;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto error = static_cast<double>(abs(Wide(found[i]) - exact[i]));
      const S size = std::abs(found[i]);
      errors.ulps.push_back(error / static_cast<double>(std::nextafter(size, 2 * size + 1) - size));
      grow(errors.by_size, error / (static_cast<double>(eps) * sized[i].size));
    }
  }
}

template <class S>
Errors errors_of_chains() {
  Errors result;
  add<Chain2, S>(result);
  add<Chain3, S>(result);
  add<Chain4, S>(result);
  if (result.not_ok > 0) result.by_size = k_breaks_down;
  return result;
}

/// Instructions and calls of double in an object that uses float only.
double doubles_in_float_object() {
  const Outcome outcome = run_program("CPATH='" GAUSS_FLOAT_HEADERS "' '" GAUSS_PYTHON "' -B '" GAUSS_SOURCE_DIR
                                      "/tests/headers/check_float.py' '" GAUSS_CXX "' objdump '" GAUSS_FLOAT_FILE "'");
  if (outcome.exit_code == 0) return 0;
  const auto lines = std::count(outcome.said.begin(), outcome.said.end(), '\n');
  return outcome.exit_code == 1 && lines > 0 ? static_cast<double>(lines) : k_breaks_down;
}

}  // namespace

std::vector<Figure> rounding(const Scope&) {
  Errors errors = errors_of_chains<double>();
  const std::string states = ", 3000 states of chains with 2 to 4 links";
  return {{"H23.size", "largest error of an acceleration by eps S, S the sum of absolute terms" + states, "1",
           std::nullopt, errors.by_size, 8},
          {"H23.median", "median of the errors", "ulp", std::nullopt, errors.quantile(0.5), 2},
          {"H23.p99", "error that 99 of 100 stay below", "ulp", std::nullopt, errors.quantile(0.99), 100}};
}

std::vector<Figure> rounding_in_float() {
  Errors errors = errors_of_chains<float>();
  return {{"H24.size", "largest error of an acceleration by eps S in float, 3000 states", "1", std::nullopt,
           errors.by_size, 8},
          {"H24.median", "median of the errors in float", "ulp", std::nullopt, errors.quantile(0.5), 2},
          {"H24.object", "instructions and calls of double in an object file of float", "1", std::nullopt,
           doubles_in_float_object(), 0}};
}

}  // namespace hard_cases
