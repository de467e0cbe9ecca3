// Where both axes of oblique coordinates fall together, the mass matrix is singular: a status has to say so, whichever
// linear system a function solves, and in a batch for that lane alone.

#include <cmath>
#include <limits>

#include "catch_shim.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "oblique.hpp"
#include "oblique_rail.hpp"
#include "oblique_skate.hpp"
#include "tested_model.hpp"

GAUSS_MAKE_TESTED(gauss::oblique)
GAUSS_MAKE_TESTED(gauss::oblique_rail)
GAUSS_MAKE_TESTED(gauss::oblique_skate)

namespace {

using gauss::Status;

/// Where each pair of axes stands.
template <class S>
struct Angles {
  S phi, psi;
};

template <class M, class S>
typename M::template State<S> state_at(const Angles<S>& angles) {
  return {{S(0.5), S(0.75), angles.phi, S(0.25), S(0.375), angles.psi, S(-0.5), S(1), S(0.25), S(0.5), S(-0.125),
           S(0.625)}};
}

template <class S>
struct Statuses {
  gauss::StatusOf<S> rhs, reactions, both, forces;
};

template <class M, class S>
Statuses<S> statuses(const typename M::template State<S>& state) {
  const auto prepared = prepare(typename M::template Parameters<S>{});
  const typename M::template Inputs<S> inputs{};
  typename M::template Derivative<S> derivative{};
  typename M::template ReactionsOrNone<S> found{};
  typename M::template ForcesOf<S> forces{};
  return {rhs(S(0), state, inputs, prepared, derivative), reactions(S(0), state, inputs, prepared, found),
          rhs_and_reactions(S(0), state, inputs, prepared, derivative, found),
          reaction_forces(S(0), state, inputs, prepared, forces)};
}

template <class M, class S>
void every_function_says(const Angles<S>& angles, Status expected) {
  INFO(M::name << ", phi = " << angles.phi << ", psi = " << angles.psi);
  const Statuses<S> found = statuses<M, S>(state_at<M>(angles));
  CHECK(found.rhs == expected);
  CHECK(found.reactions == expected);
  CHECK(found.both == expected);
  CHECK(found.forces == expected);
}

template <class S>
void in_every_model(const Angles<S>& angles, Status expected) {
  every_function_says<gauss::oblique::Tested>(angles, expected);
  every_function_says<gauss::oblique_rail::Tested>(angles, expected);
  every_function_says<gauss::oblique_skate::Tested>(angles, expected);
}

// m - m cos² phi is what is left of a diagonal entry m, and a quarter of the digits has to be: eps^(3/4) m. One of two pivots is enough, whichever
// comes first in the factorisation.
template <class S>
void lost_digits_are_told_from_few() {
  const S least = std::pow(std::numeric_limits<S>::epsilon(), S(0.375));
  const S regular(0.75);
  for (const S lost : {S(0), least / 1024, least / 2}) {
    in_every_model<S>({lost, regular}, Status::singular_mass_matrix);
    in_every_model<S>({regular, lost}, Status::singular_mass_matrix);
    in_every_model<S>({lost, lost}, Status::singular_mass_matrix);
  }
  in_every_model<S>({least * 2, regular}, Status::ok);
  in_every_model<S>({regular, least * 2}, Status::ok);
  in_every_model<S>({regular, regular}, Status::ok);
}

template <class M>
Status of_projection(const Angles<double>& angles) {
  typename M::template State<double> projected{};
  return project(0.0, state_at<M>(angles), prepare(typename M::template Parameters<double>{}), projected);
}

template <class M>
Status of_initial_state(const Angles<double>& angles) {
  typename M::template Parameters<double> parameters;
  parameters.phi_0 = angles.phi;
  parameters.psi_0 = angles.psi;
  typename M::template State<double> state{};
  return initial_state(prepare(parameters), state);
}

template <class M>
void states_say_it_where_they_solve() {
  INFO(M::name);
  for (const Angles<double> singular : {Angles<double>{0, 0.75}, Angles<double>{0.75, 0}}) {
    CHECK(of_projection<M>(singular) == Status::singular_mass_matrix);
    CHECK(of_initial_state<M>(singular) == Status::singular_mass_matrix);
  }
  CHECK(of_projection<M>({0.75, 0.75}) == Status::ok);
  CHECK(of_initial_state<M>({0.75, 0.75}) == Status::ok);
}

template <class M, class T>
void lanes_say_it_for_themselves() {
  using S = xsimd::batch<T>;
  T phi[S::size];
  for (std::size_t i = 0; i < S::size; ++i) phi[i] = i % 2 == 0 ? T(0) : T(0.75);
  const auto found = statuses<M, S>(state_at<M, S>({S::load_unaligned(phi), S(T(0.75))}));
  for (std::size_t i = 0; i < S::size; ++i) {
    const Status expected = i % 2 == 0 ? Status::singular_mass_matrix : Status::ok;
    INFO(M::name << ", lane " << i);
    CHECK(found.rhs.lane(i) == expected);
    CHECK(found.reactions.lane(i) == expected);
    CHECK(found.both.lane(i) == expected);
    CHECK(found.forces.lane(i) == expected);
  }
}

}  // namespace

TEST_CASE(
    "a mass matrix that is singular here is reported by every function that solves with it, in every scalar type") {
  lost_digits_are_told_from_few<float>();
  lost_digits_are_told_from_few<double>();
  lost_digits_are_told_from_few<long double>();
}

TEST_CASE("so it is by project and by initial_state, where constraints make them solve") {
  states_say_it_where_they_solve<gauss::oblique_rail::Tested>();
  states_say_it_where_they_solve<gauss::oblique_skate::Tested>();
  // Without constraints there is nothing to solve.
  CHECK(of_projection<gauss::oblique::Tested>({0, 0}) == Status::ok);
  CHECK(of_initial_state<gauss::oblique::Tested>({0, 0}) == Status::ok);
}

TEST_CASE("in a batch, a singular lane says so and the lanes beside it are ok") {
  lanes_say_it_for_themselves<gauss::oblique::Tested, double>();
  lanes_say_it_for_themselves<gauss::oblique_rail::Tested, double>();
  lanes_say_it_for_themselves<gauss::oblique_skate::Tested, double>();
  lanes_say_it_for_themselves<gauss::oblique::Tested, float>();
}
