// Compiled headers of random mechanisms against newton/reference.hpp. check_maximal_coordinates.py builds the headers.
//
//   maximal_coordinates write SEED COUNT FOLDER      the models, m<seed>.yaml
//   maximal_coordinates check SEED COUNT LIBRARY     of which each mechanism is a function gauss_m<seed>; exits with 1 where a state is wrong

#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>

#include "newton/random_mechanism.hpp"
#include "newton/reference.hpp"

namespace {

using agreement::newton::Real;
using agreement::newton::Reference;

constexpr int k_states = 5, k_tries = 10;
constexpr double k_eps = 2.220446049250313e-16;
/// sqrt(eps), of rows that may be eps^(1/4) of their usual length: what constrained.hpp takes for rounding.
constexpr double k_small_beside_forces = 1.3e-4;

/// Sines below this are rounding of double: at a double state, rows that follow from others are not parallel in a hundred digits.
constexpr double k_rounding_of_rows = 1e-12;

enum Status { ok, singular_mass_matrix, dependent_constraints, not_finite, violated_constraints };

/// Brings a state onto the constraints, where it can; accelerations of speeds, bᵀλ along them, and the statuses of projection and of both. Returns
/// the number of speeds.
using Emitted = int (*)(double t, double* state, double* accelerations, double* reactions, int* statuses);

struct Count {
  int models = 0, refused = 0, states = 0, compared = 0, wrong = 0;
  int beside = 0;  ///< states that projection leaves beside the constraints
  std::map<std::string, int> explained;
  void explain(const std::string& why) { ++explained[why]; }
  std::map<std::string, int> left_open;  ///< by where
  void leave_open(const std::string& where) { ++left_open[where]; }
  std::map<int, int> statuses;
  double worst = 0, worst_reaction = 0;  ///< by the bar
};

bool is_on_constraints(int status_of_projection) {
  return status_of_projection == ok || status_of_projection == dependent_constraints;
}

std::optional<gaussgen::model::Model> parsed(const std::string& text) {
  gaussgen::support::Source source("model.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  auto model = gaussgen::read_model(source, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return model;
}

Eigen::Index rank_to(const Reference& reference, double tolerance) {
  Eigen::Index rank = 0;
  for (Eigen::Index k = 0; k < reference.sines.size(); ++k) rank += reference.sines[k] > tolerance ? 1 : 0;
  return rank;
}

/// Why a status other than ok is right, or nothing where it is not.
std::string reason(const Reference& reference, int status) {
  const Eigen::Index l = reference.sines.size();
  const bool is_beyond_double = !reference.is_determined || reference.condition > 1e10;
  switch (status) {
    case dependent_constraints: return rank_to(reference, 1e-7) < l ? "rows depend on each other" : "";
    case violated_constraints:
      if (reference.contradiction > 1e-12) return "rows contradict each other";
      return rank_to(reference, k_rounding_of_rows) < reference.rank
                 ? "rows that differ by rounding contradict each other"
                 : "";
    case singular_mass_matrix: return is_beyond_double ? "nothing determines all accelerations in double" : "";
    default: return "";
  }
}

double relative(const Real& error, const Real& bar) {
  const Real result = error / bar;
  return error == 0 ? 0 : static_cast<double>(result);
}

void wrong(unsigned seed, int state, const char* what, double figure, const Reference& reference) {
  std::printf("WRONG: seed %u, state %d: %s (%.3g), kappa %.2g, rank %d of %d, least sine %.2g, contradiction %.2g\n",
              seed, state, what, figure, reference.condition, static_cast<int>(reference.rank),
              static_cast<int>(reference.sines.size()),
              reference.sines.size() == 0 ? 1.0 : reference.sines[reference.sines.size() - 1],
              static_cast<double>(reference.contradiction));
}

/// Errors of a state whose status is ok, each by 100 kappa eps of the terms; the larger one beyond 1 is wrong. `moved`: what a rounding of time
/// makes of the accelerations, where held coordinates pass through zero as differences of laws in time.
void compare(const Reference& reference, const Real& moved, const std::vector<double>& a, const std::vector<double>& r,
             bool has_reactions, double& worst, double& worst_reaction) {
  // Where rows contradict each other by a little, whatever lies between them is an answer.
  const Real bar = 100 * reference.condition * (k_eps + reference.contradiction) * reference.size + 100 * moved;
  for (Eigen::Index i = 0; i < reference.accelerations.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Real error = abs(Real(reference.accelerations[i] - a[k])) * reference.units[i];
    const double now = relative(error, bar);
    if (!(now <= worst)) worst = now;
    if (!has_reactions) continue;
    const double of_reaction = relative(abs(Real(reference.reactions[i] - r[k])) / reference.units[i], bar);
    if (!(of_reaction <= worst_reaction)) worst_reaction = of_reaction;
  }
}

/// By which a rounding of time moves accelerations, in units.
using Moved = std::function<Real()>;

/// Of a state of which all is known; what is wrong with it, and by how much.
void check_results(const Reference& reference, const std::vector<double>& a, const std::vector<double>& r,
                   const int* statuses, bool has_positions, const Moved& moved, Count& count,
                   const std::function<void(const char*, double)>& fail) {
  if (statuses[0] != ok) {
    const std::string why = reason(reference, statuses[0]);
    if (why.empty()) return fail("status of rhs without a reason", statuses[0]);
    return count.explain(why);
  }
  if (!reference.is_determined) return fail("ok, but nothing determines all accelerations", 0);
  if (rank_to(reference, k_rounding_of_rows) < reference.rank) return count.leave_open("up to rounding of the state");
  if (reference.contradiction > 1e-3) {
    if (!is_on_constraints(statuses[2])) return count.explain("projection finds no position, where rows agree");
    // What decision 0012 leaves open: beside equations of positions nobody asks, and what is small beside the forces is taken for rounding.
    if (has_positions) return count.leave_open("beside equations of positions");
    if (reference.open < k_small_beside_forces * reference.size)
      return count.leave_open("by little, beside the forces");
    return fail("ok, but rows contradict each other", 0);
  }
  if (statuses[1] != ok && reason(reference, statuses[1]).empty())
    return fail("status of reactions without a reason", statuses[1]);
  if (statuses[1] == ok && reference.rank < reference.sines.size())
    return fail("multipliers are not unique, and ok", 0);
  const bool has_reactions = statuses[1] == ok || statuses[1] == dependent_constraints;
  double worst = 0, worst_reaction = 0;
  compare(reference, 0, a, r, has_reactions, worst, worst_reaction);
  if (!(std::max(worst, worst_reaction) <= 1)) {
    worst = worst_reaction = 0;
    compare(reference, moved(), a, r, has_reactions, worst, worst_reaction);
  }
  ++count.compared;
  if (!(worst <= 1)) fail("accelerations", worst);
  if (!(worst_reaction <= 1)) fail("reactions", worst_reaction);
  if (!(worst <= count.worst)) count.worst = worst;
  if (!(worst_reaction <= count.worst_reaction)) count.worst_reaction = worst_reaction;
}

bool has_positions(const gaussgen::model::Model& model) {
  return std::any_of(model.constraints.begin(), model.constraints.end(), [](const auto& constraint) {
    return std::holds_alternative<gaussgen::model::PositionLaw>(constraint.law);
  });
}

struct Answer {
  agreement::State state;  ///< on the constraints, if that was found
  std::vector<double> a, r;
  int statuses[3] = {ok, ok, ok};
  int speeds = 0;
};

Answer answer(Emitted emitted, const agreement::State& start) {
  Answer result;
  std::vector<double> y = start.configuration;
  y.insert(y.end(), start.speeds.begin(), start.speeds.end());
  result.a.resize(start.speeds.size() + 1);
  result.r.resize(start.speeds.size() + 1);
  result.speeds = emitted(start.time, y.data(), result.a.data(), result.r.data(), result.statuses);
  const auto q = static_cast<std::ptrdiff_t>(start.configuration.size());
  result.state = {start.time, {y.begin(), y.begin() + q}, {y.begin() + q, y.end()}};
  return result;
}

void check_state(unsigned seed, int i, const gaussgen::model::Model& model, const Answer& found, Count& count) {
  const Reference reference(model, agreement::newton::constants(model), found.state);
  const auto fail = [&](const char* what, double figure) {
    ++count.wrong;
    wrong(seed, i, what, figure, reference);
  };
  ++count.states;
  ++count.statuses[found.statuses[0]];
  count.beside += is_on_constraints(found.statuses[2]) ? 0 : 1;
  if (found.speeds != static_cast<int>(found.state.speeds.size())) return fail("number of speeds", found.speeds);
  const Moved moved = [&] {
    agreement::State later = found.state;
    later.time += k_eps * std::max(1.0, std::abs(later.time));
    const Reference there(model, agreement::newton::constants(model), later);
    Real most = 0;
    for (Eigen::Index k = 0; k < reference.accelerations.size() && there.is_determined; ++k)
      most = std::max(most, Real(abs(Real(there.accelerations[k] - reference.accelerations[k])) * reference.units[k]));
    return most;
  };
  check_results(reference, found.a, found.r, found.statuses, has_positions(model), moved, count, fail);
}

void check_model(unsigned seed, void* library, Count& count) {
  const auto model = parsed(agreement::newton::extreme_mechanism(seed));
  const auto emitted = reinterpret_cast<Emitted>(dlsym(library, ("gauss_m" + std::to_string(seed)).c_str()));
  ++count.models;
  if (!model || emitted == nullptr) {
    ++count.refused;
    return;
  }
  const gaussgen::ModelGraph graph(*model, false);
  agreement::RandomStates states(graph.symbols, seed);
  for (int i = 0; i < k_states; ++i) {
    // From some states the constraints cannot be reached.
    Answer found = answer(emitted, states.next());
    for (int tries = 1; tries < k_tries && !is_on_constraints(found.statuses[2]); ++tries)
      found = answer(emitted, states.next());
    check_state(seed, i, *model, found, count);
  }
}

int report(const Count& count) {
  static const char* const k_names[] = {"ok", "singular mass matrix", "dependent constraints", "not finite",
                                        "violated constraints"};
  std::printf("%d mechanisms, %d refused by gauss-gen; %d states, %d of them beside the constraints\n", count.models,
              count.refused, count.states, count.beside);
  for (const auto& [status, times] : count.statuses) std::printf("  %4d %s\n", times, k_names[status]);
  for (const auto& [why, times] : count.explained)
    std::printf("  %4d states with a status because %s\n", times, why.c_str());
  int left_open = 0;
  for (const auto& [where, times] : count.left_open) {
    left_open += times;
    std::printf("  %4d states ok where rows contradict each other %s\n", times, where.c_str());
  }
  std::printf("worst of %d states compared: accelerations %.2g, reactions %.2g of 100 kappa eps\n", count.compared,
              count.worst, count.worst_reaction);
  std::printf("%d wrong\n", count.wrong);
  // For whoever adds up several ranges.
  std::printf("counted: %d %d %d %d %d\n", count.models, count.refused, count.states, count.compared, left_open);
  return count.wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto first = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
  const auto end = first + static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10));
  if (std::strcmp(argv[1], "write") == 0) {
    for (unsigned seed = first; seed != end; ++seed) {
      std::string text = agreement::newton::extreme_mechanism(seed);
      text.replace(text.find("name: m"), 7, "name: m" + std::to_string(seed));
      std::ofstream(std::string(argv[4]) + "/m" + std::to_string(seed) + ".yaml") << text;
    }
    return 0;
  }
  void* library = dlopen(argv[4], RTLD_NOW);
  if (library == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 2;
  }
  Count count;
  for (unsigned seed = first; seed != end; ++seed) check_model(seed, library, count);
  return report(count);
}
