#include "sim/effects/ladder.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

EffectSet without_any(EffectSet acting, const std::vector<gaussgen::model::Effect>& effects) {
  while (true) {
    const std::vector<Move> moves = moves_from(acting, effects);
    const auto first = std::find_if(moves.begin(), moves.end(), [](const Move& move) { return !move.is_other_choice; });
    if (first == moves.end()) return acting;
    acting = first->left;
  }
}

/// Nothing: all moves lead to more operations, or to no motion.
std::optional<Compared> next_rung(const Measured& from, Workbench& bench) {
  std::optional<Compared> best;
  for (const Move& move : moves_from(from.acting, bench.effects())) {
    if (ends_now()) return std::nullopt;
    const Measured& found = bench.measured(move.left);
    if (!found.why.empty() || found.operations > from.operations) continue;
    const auto order = [](const Measured& one) { return std::tuple(one.change.value, one.operations); };
    if (!best || order(found) < order(best->measured)) best = Compared{move, found};
  }
  return best;
}

}  // namespace

// What falls with another effect, as wind with the air, is counted once: as its own.
int Ladder::shared_operations() const {
  struct Part {
    EffectSet absent;
    int own = 0;
  };
  std::vector<Part> parts;
  for (const Compared& one : each) {
    if (one.move.is_other_choice || !one.measured.why.empty()) continue;
    Part part{{}, all.operations - one.measured.operations};
    std::set_difference(all.acting.begin(), all.acting.end(), one.measured.acting.begin(), one.measured.acting.end(),
                        std::inserter(part.absent, part.absent.end()));
    const auto is_same = [&](const Part& other) { return other.absent == part.absent; };
    if (std::none_of(parts.begin(), parts.end(), is_same)) parts.push_back(std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.absent.size() < b.absent.size(); });
  int shared = all.operations - none.operations;
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    for (auto inner = parts.begin(); inner != part; ++inner) {
      const auto& [absent, own] = *inner;
      if (std::includes(part->absent.begin(), part->absent.end(), absent.begin(), absent.end())) part->own -= own;
    }
    shared -= part->own;
  }
  return shared;
}

Measured cheapest_within(const Ladder& ladder, double change) {
  Measured best = ladder.all;
  const auto order = [](const Measured& one) { return std::tuple(one.operations, one.acting.size()); };
  const auto take = [&](const Measured& one) {
    if (one.why.empty() && one.change.value <= change && order(one) < order(best)) best = one;
  };
  for (const auto& list : {ladder.each, ladder.rungs}) {
    for (const Compared& one : list) take(one.measured);
  }
  take(ladder.none);
  return best;
}

std::optional<Ladder> make_ladder(Workbench& bench) {
  Ladder ladder;
  ladder.all = bench.measured(bench.all());
  for (const Move& move : moves_from(bench.all(), bench.effects())) {
    ladder.each.push_back({move, bench.measured(move.left)});
    if (ends_now()) return std::nullopt;
  }
  ladder.rungs.push_back({{"all", bench.all()}, ladder.all});
  while (const auto next = next_rung(ladder.rungs.back().measured, bench)) {
    const bool is_new = std::none_of(ladder.rungs.begin(), ladder.rungs.end(),
                                     [&](const Compared& one) { return one.measured.acting == next->measured.acting; });
    if (!is_new) break;
    ladder.rungs.push_back(*next);
  }
  ladder.none = bench.measured(without_any(bench.all(), bench.effects()));
  if (ends_now()) return std::nullopt;
  return ladder;
}

}  // namespace gausssim
