// Rounding in emitted code: chains of 2 to 4 links in double and in float, against 50 digits.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "expanded.hpp"
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

/// The emitted structs from which the naive form starts.
template <class Model>
struct Equations;
#define EQUATIONS_OF(model, name_space)                   \
  template <>                                             \
  struct Equations<model> {                               \
    template <class S>                                    \
    using Metric = gauss::name_space::MassMatrix<S>;      \
    template <class S>                                    \
    using Forces = gauss::name_space::InverseDynamics<S>; \
  }
EQUATIONS_OF(Chain2, planar_chain_relative_2);
EQUATIONS_OF(Chain3, planar_chain_relative_3);
EQUATIONS_OF(Chain4, planar_chain_relative_4);

struct Errors {
  std::vector<double> ulps = {};  ///< of every acceleration, in units of its last digit
  double by_size = 0;             ///< largest, by eps S
  double by_value = 0;            ///< largest, by eps times the acceleration itself

  double quantile(double share) {
    if (ulps.empty()) return k_breaks_down;
    const auto at = ulps.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(ulps.size() - 1));
    std::nth_element(ulps.begin(), at, ulps.end());
    return *at;
  }

  template <class S>
  void add(const S& found, const Wide& exact, const Sized& sized) {
    const auto error = static_cast<double>(abs(Wide(found) - exact));
    const S size = std::abs(found);
    constexpr auto eps = static_cast<double>(std::numeric_limits<S>::epsilon());
    ulps.push_back(error / static_cast<double>(std::nextafter(size, 2 * size + 1) - size));
    grow(by_size, error / (eps * sized.size));
    grow(by_value, error / (eps * static_cast<double>(size)));
  }
};

/// Emitted ones, and those that are multiplied out.
struct Forms {
  Errors ours, naive;
  int not_ok = 0;
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
std::vector<S> multiplied_out(const std::vector<S>& state) {
  typename Model::template State<S> at;
  for (std::size_t i = 0; i < state.size(); ++i) at.values[i] = state[i];
  typename Equations<Model>::template Metric<S> metric;
  typename Equations<Model>::template Forces<S> forces;
  const auto values = prepared<Model, S>();
  (void)mass_matrix(S(0), at, values, metric);
  (void)inverse_dynamics(S(0), at, {}, values, typename Model::template Derivative<S>{}, forces);
  S result[Model::n_q];
  solve_expanded<Model::n_q>(metric.g, forces.missing, result);
  return {result, result + Model::n_q};
}

template <class Model, class S>
void add(Forms& forms) {
  std::mt19937 random(20230u + static_cast<unsigned>(Model::n_q));
  std::uniform_real_distribution<S> angle(-3, 3);
  for (int k = 0; k < k_states; ++k) {
    std::vector<S> state(2 * Model::n_q);
    for (S& x : state) x = angle(random);
    bool is_ok = true, is_wide_ok = true, is_sized_ok = true;
    const auto found = accelerations<Model, S>(state, is_ok);
    const auto exact = accelerations<Model, Wide>(state, is_wide_ok);
    const auto sized = accelerations<Model, Sized>(state, is_sized_ok);
    const auto expanded = multiplied_out<Model, S>(state);
    if (!(is_ok && is_wide_ok && is_sized_ok)) ++forms.not_ok;
    for (std::size_t i = 0; i < found.size(); ++i) {
      forms.ours.add(found[i], exact[i], sized[i]);
      forms.naive.add(expanded[i], exact[i], sized[i]);
    }
  }
}

template <class S>
Forms forms_of_chains() {
  Forms result;
  add<Chain2, S>(result);
  add<Chain3, S>(result);
  add<Chain4, S>(result);
  if (result.not_ok > 0) {
    result.ours.by_size = k_breaks_down;
    result.ours.ulps.clear();
  }
  return result;
}

/// With `suffix` behind what is measured.
std::vector<Figure> figures_of_chains(const std::string& id, Forms forms, const std::string& suffix) {
  return {
      {id + ".size",
       "largest error of an acceleration by eps S, S the sum of absolute terms, naive by eps times the value" + suffix,
       "1", forms.ours.by_value, forms.ours.by_size, 8},
      {id + ".median", "median of the errors, naive of determinants multiplied out" + suffix, "ulp",
       forms.naive.quantile(0.5), forms.ours.quantile(0.5), 2},
      {id + ".p99", "error that 99 of 100 stay below, naive of determinants multiplied out" + suffix, "ulp",
       forms.naive.quantile(0.99), forms.ours.quantile(0.99), 100}};
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
  return figures_of_chains("H23", forms_of_chains<double>(), ", 3000 states of chains with 2 to 4 links");
}

std::vector<Figure> rounding_in_float() {
  std::vector<Figure> figures = figures_of_chains("H24", forms_of_chains<float>(), ", in float");
  figures.push_back({"H24.object", "instructions and calls of double in an object file of float", "1", std::nullopt,
                     doubles_in_float_object(), 0});
  return figures;
}

}  // namespace hard_cases
