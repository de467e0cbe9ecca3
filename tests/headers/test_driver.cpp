// A driver that knows nothing but model_concept.hpp runs every header.

#include <cmath>
#include <cstring>

#include "catch_shim.hpp"
#include "gauss/model_concept.hpp"

#include "folded_headers.inc"
#include "paper_headers.inc"
#include "plain_headers.inc"

#define GAUSS_TESTED_MODEL(name_space) \
  namespace name_space {               \
  GAUSS_MODEL(Model, name_space);      \
  }
#include "folded_models.inc"
#include "paper_models.inc"
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL

namespace {

/// Heun's steps from a state without motion of the parameters or inputs, until the status objects.
template <class Model, class S>
int steps_taken(int wanted) {
  static_assert(gauss::is_model<Model, S>);
  const auto prepared = Model::prepare(typename Model::template Parameters<S>{});
  const typename Model::template Inputs<S> inputs{};
  typename Model::template State<S> state{};
  // Any state with quaternions of unit length will do.
  for (int i = 0; i < Model::n_q + Model::n_v; ++i) state.values[i] = S(1) / S(2 + i);
  (void)project(S(0), typename Model::template State<S>(state), prepared, state);
  // Short beside the decay of the stiff spring pendulum, 1e-4 s, which ends Heun's steps otherwise.
  const S h = S(1) / S(100000);
  S t = S(0);
  for (int step = 0; step < wanted; ++step, t += h) {
    typename Model::template Derivative<S> first, second;
    typename Model::template State<S> ahead;
    if (Model::rhs(t, state, inputs, prepared, first) != gauss::Status::ok) return step;
    for (int i = 0; i < Model::n_q + Model::n_v; ++i) ahead.values[i] = state.values[i] + h * first.values[i];
    if (Model::rhs(t + h, ahead, inputs, prepared, second) != gauss::Status::ok) return step;
    for (int i = 0; i < Model::n_q + Model::n_v; ++i) {
      state.values[i] += h / S(2) * (first.values[i] + second.values[i]);
    }
  }
  return wanted;
}

template <class Model>
int named(const gauss::Quantity* table) {
  int count = 0;
  while (table[count].name != nullptr) ++count;
  return count;
}

template <class Model>
void drive(const char* name_space) {
  INFO(name_space);
  CHECK(steps_taken<Model, double>(100) == 100);
  CHECK(steps_taken<Model, float>(100) == 100);
  CHECK(std::strstr(name_space, Model::name) != nullptr);
  CHECK(named<Model>(Model::coordinates) == Model::n_q);
  CHECK(named<Model>(Model::speeds) == Model::n_v);
}

}  // namespace

TEST_CASE("every header is a model by model_concept.hpp, and a driver written against that alone runs it") {
#define GAUSS_TESTED_MODEL(name_space) drive<name_space::Model>(#name_space);
#include "folded_models.inc"
#include "paper_models.inc"
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
}
