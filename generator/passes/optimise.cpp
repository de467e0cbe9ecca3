#include "passes/optimise.hpp"

#include <chrono>
#include <utility>

#include "ir/cost.hpp"
#include "passes/angles.hpp"
#include "passes/cancellation.hpp"
#include "passes/factor.hpp"
#include "passes/pairs.hpp"
#include "passes/quotients.hpp"
#include "passes/rotations.hpp"
#include "passes/scale.hpp"
#include "passes/terms.hpp"

namespace gaussgen::passes {

namespace {

/// Numbers of a mechanism that stand in several places are rounded alike, and the motion is that of a mechanism nearby; in units of
/// their own they are not. So units have to be worth it.
constexpr double k_least_worth = 0.97;
constexpr int k_fewest_saved = 4;

/// What units save by themselves, of all operations, for the rest to be tried in them, too. Sharing makes more of it: seven times as much of the
/// 1 % of a row of 80 planar pendulums. Of the 0.1 % of 100 links in space it makes nothing, and takes as long as all other passes.
constexpr double k_least_promise = 0.002;

const Pass k_turns{"turns", turn_back};
const Pass k_quotients{"quotients", join_quotients};
const Pass k_units{"units", choose_units};
const Pass k_pairs{"pairs", share_factors};
const Pass k_factors{"factors", factor_out};
const Pass k_terms{"terms", share_terms};

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

struct Outcome {
  Request request;
  int operations = 0;
  std::vector<PassEffect> effects;
};

void run(Graph& graph, const Pass& pass, Outcome& outcome) {
  const auto begin = Clock::now();
  Request next = pass.run(graph, outcome.request);
  const int before = outcome.operations;
  const bool is_same = next.outputs == outcome.request.outputs;
  const int after = is_same ? before : ir::operations(graph, next.outputs);
  if (after < before) {
    outcome.request = std::move(next);
    outcome.operations = after;
  }
  outcome.effects.push_back({pass.name, before, outcome.operations, since(begin)});
}

void run(Graph& graph, const std::vector<Pass>& passes, Outcome& outcome) {
  for (const Pass& pass : passes) run(graph, pass, outcome);
}

Outcome begun(Graph& graph, const Request& request) { return {request, ir::operations(graph, request.outputs), {}}; }

// Turns once more, now that products of parameters are one symbol each. Quotients where Schur complements stand as they were made.
const std::vector<Pass> k_beginning{k_turns, k_quotients};

// Where units have made divisors short, there are more quotients.
const std::vector<Pass> k_in_units{k_units, k_quotients};

// What several values share, terms and then factors, before what one of them saves by taking factors out; then what is left to share.
const std::vector<Pass> k_sharing{k_terms, k_pairs, k_factors, k_pairs, k_terms};

std::vector<Pass> joined(const std::vector<std::vector<Pass>>& parts) {
  std::vector<Pass> all;
  for (const std::vector<Pass>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Request taken(Outcome outcome, std::vector<PassEffect>* effects) {
  if (effects != nullptr) effects->insert(effects->end(), outcome.effects.begin(), outcome.effects.end());
  return std::move(outcome.request);
}

bool is_promising(int saved, int operations) { return saved >= operations * k_least_promise; }

/// What the passes of `other` took behind those that it has in common with `outcome`, which is taken instead.
void add_left_out(const Outcome& other, Outcome& outcome) {
  double milliseconds = 0;
  for (std::size_t i = k_beginning.size(); i < other.effects.size(); ++i) milliseconds += other.effects[i].milliseconds;
  outcome.effects.push_back({"left out", outcome.operations, outcome.operations, milliseconds});
}

}  // namespace

const std::vector<Pass>& identities() {
  static const std::vector<Pass> k_identities{{"angles", join_angles}, k_turns};
  return k_identities;
}

const std::vector<std::vector<Pass>>& orders() {
  static const std::vector<std::vector<Pass>> k_orders{joined({k_beginning, k_sharing}),
                                                       joined({k_beginning, k_in_units, k_sharing})};
  return k_orders;
}

Request apply(Graph& graph, const Request& request, const std::vector<Pass>& passes, std::vector<PassEffect>* effects) {
  Outcome outcome = begun(graph, request);
  run(graph, passes, outcome);
  return taken(std::move(outcome), effects);
}

Request apply_best_order(Graph& graph, const Request& request, std::vector<PassEffect>* effects) {
  Outcome best = begun(graph, request);
  run(graph, k_beginning, best);
  Outcome in_units = best;
  run(graph, k_sharing, best);
  run(graph, k_in_units, in_units);
  const PassEffect& units = in_units.effects[k_beginning.size()];
  const bool goes_on = units.after < units.before && is_promising(units.before - in_units.operations, units.before);
  if (goes_on) run(graph, k_sharing, in_units);
  const int saved = best.operations - in_units.operations;
  const bool is_worth_it = goes_on && saved >= k_fewest_saved && in_units.operations < best.operations * k_least_worth;
  if (is_worth_it) std::swap(best, in_units);
  add_left_out(in_units, best);
  return taken(std::move(best), effects);
}

namespace {

/// Whatever operations it takes.
template <class Run>
Request apply_anyway(Graph& graph, const Request& request, const char* name, const Run& run,
                     std::vector<PassEffect>* effects) {
  const auto begin = Clock::now();
  Request next = run(graph, request);
  if (effects == nullptr) return next;
  const int before = ir::operations(graph, request.outputs);
  const int after = next.outputs == request.outputs ? before : ir::operations(graph, next.outputs);
  effects->push_back({name, before, after, since(begin)});
  return next;
}

}  // namespace

Request apply_cancellation(Graph& graph, const Request& request, std::vector<PassEffect>* effects,
                           const std::vector<std::string>& as_written) {
  const auto keep = [&as_written](Graph& of, const Request& values) {
    return keep_digits_except(of, values, as_written);
  };
  return apply_anyway(graph, request, "cancellation", keep, effects);
}

Request apply_rotations(Graph& graph, const Request& request, std::vector<PassEffect>* effects) {
  return apply_anyway(graph, request, "rotations", rotate_angles, effects);
}

}  // namespace gaussgen::passes
