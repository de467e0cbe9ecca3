#pragma once
// Models, and random states of them.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "evaluate/arithmetic_scale.hpp"
#include "evaluation.hpp"
#include "read_model.hpp"
#include "support/files.hpp"

namespace agreement {

inline gaussgen::model::Model load(const std::string& file) {
  const std::string path = std::string(GAUSS_SOURCE_DIR) + "/models/" + file + ".yaml";
  std::string why;
  gaussgen::support::Source source(path, gaussgen::support::read_file(path, why).value(),
                                   gaussgen::support::read_regular_file);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  if (!model) throw std::runtime_error(gaussgen::support::render(diagnostics, source));
  return *model;
}

/// One state as doubles, which every evaluation takes as exact.
struct State {
  double time = 0;
  std::vector<double> configuration;
  std::vector<double> speeds;
};

/// States away from the poles of Euler angles only by chance; speeds need not satisfy the constraints, since every form
/// solves the same linear problem at any speeds.
class RandomStates {
 public:
  RandomStates(const gaussgen::kinematics::Symbols& symbols, unsigned seed) : symbols_(symbols), random_(seed) {}

  State next() {
    State state;
    state.time = uniform(0, 10);
    for (std::size_t i = 0; i < symbols_.configuration.size(); ++i) state.configuration.push_back(uniform(-1.5, 1.5));
    for (std::size_t i = 0; i < symbols_.speeds.size(); ++i) state.speeds.push_back(uniform(-3, 3));
    for (const auto first : symbols_.first_quaternion_component) normalise(&state.configuration[first.value]);
    return state;
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private:
  static void normalise(double* e) {
    const double norm = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
    for (int i = 0; i < 4; ++i) e[i] /= norm;
  }

  const gaussgen::kinematics::Symbols& symbols_;
  std::mt19937 random_;
};

/// A double in the number type of an evaluator.
inline double as(const gaussgen::evaluate::Arithmetic<double>&, double value) { return value; }
inline long double as(const gaussgen::evaluate::Arithmetic<long double>&, double value) { return value; }
inline cln::cl_F as(const gaussgen::evaluate::Arithmetic<cln::cl_F>& arithmetic, double value) {
  return arithmetic.number(value);
}
inline gaussgen::evaluate::Scaled<double> as(
    const gaussgen::evaluate::Arithmetic<gaussgen::evaluate::Scaled<double>>& arithmetic, double value) {
  return arithmetic.input(value);
}
inline gaussgen::evaluate::Scaled<cln::cl_F> as(
    const gaussgen::evaluate::Arithmetic<gaussgen::evaluate::Scaled<cln::cl_F>>& arithmetic, double value) {
  return arithmetic.input(gaussgen::evaluate::Arithmetic<cln::cl_F>(50).number(value));
}

template <class T>
void bind(const gaussgen::kinematics::Symbols& symbols, const State& state,
          gaussgen::evaluate::Evaluator<T>& evaluator) {
  evaluator.bind(symbols.time, as(evaluator.arithmetic(), state.time));
  for (const auto i : symbols.configuration.indices()) {
    evaluator.bind(symbols.configuration[i].symbol, as(evaluator.arithmetic(), state.configuration[i.value]));
  }
  for (const auto i : symbols.speeds.indices()) {
    evaluator.bind(symbols.speeds[i].symbol, as(evaluator.arithmetic(), state.speeds[i.value]));
  }
}

}  // namespace agreement
