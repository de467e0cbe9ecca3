#include "passes/optimise.hpp"

#include <chrono>

#include "ir/cost.hpp"
#include "passes/angles.hpp"
#include "passes/factor.hpp"
#include "passes/pairs.hpp"
#include "passes/quotients.hpp"
#include "passes/scale.hpp"
#include "passes/terms.hpp"

namespace gaussgen::passes {

const std::vector<Pass>& identities() {
  static const std::vector<Pass> k_identities{{"angles", join_angles}, {"turns", turn_back}};
  return k_identities;
}

// Quotients first, where Schur complements stand as they were made; once more where units have made divisors short. Pairs before
// factors, since what several values share is worth more than what one of them saves; then pairs of what is left.
const std::vector<Pass>& passes() {
  static const std::vector<Pass> k_passes{
      {"turns", turn_back},     {"quotients", join_quotients}, {"units", choose_units},  {"quotients", join_quotients},
      {"pairs", share_factors}, {"factors", factor_out},       {"pairs", share_factors}, {"terms", share_terms}};
  return k_passes;
}

Request optimise(Graph& graph, const Request& request, const std::vector<Pass>& passes,
                 std::vector<PassEffect>* effects) {
  Request best = request;
  int operations = ir::operations(graph, best.outputs);
  for (const Pass& pass : passes) {
    const auto begin = std::chrono::steady_clock::now();
    Request next = pass.run(graph, best);
    const int before = operations;
    const int after = ir::operations(graph, next.outputs);
    if (after < before) {
      best = std::move(next);
      operations = after;
    }
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    if (effects != nullptr) effects->push_back({pass.name, before, operations, taken.count()});
  }
  return best;
}

}  // namespace gaussgen::passes
