#include "passes/rotations.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "passes/rewrite.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

using ir::Function;
using ir::Kind;
using ir::Node;
using ir::Rational;
using ir::Term;

namespace {

/// On x86-64, of the GNU C library and g++ -O3: a call for a sine or a cosine, for both, and three operations in its place.
constexpr double k_instructions_of_one = 90, k_instructions_of_rotation = 3.6, k_instructions_of_pair = 140;
/// Each adds 8 cycles to what waits for the angle, and some tenths of a rounding unit to its error.
constexpr int k_most_rotations = 2;
/// Sums of more terms are not taken apart into three.
constexpr std::size_t k_most_terms = 8;

/// constant + Σ coefficient * atom, none of them zero. Atoms are counted as they come up in the program.
struct Angle {
  Rational constant = 0;
  std::map<std::size_t, Rational> terms;

  bool operator<(const Angle& other) const {
    return constant != other.constant ? constant < other.constant : terms < other.terms;
  }

  Rational size() const {
    Rational sum = 0;
    for (const auto& [atom, coefficient] : terms) sum += cln::abs(coefficient);
    return sum;
  }

  /// Whether every term of `sign` times `part` is one of this angle, or some of it.
  bool contains(int sign, const Angle& part) const {
    return std::all_of(part.terms.begin(), part.terms.end(), [&](const auto& term) {
      const auto own = terms.find(term.first);
      const Rational wanted = sign * term.second;
      return own != terms.end() && own->second * wanted > 0 && cln::abs(wanted) <= cln::abs(own->second);
    });
  }

  Angle without(int sign, const Angle& part) const {
    Angle rest = *this;
    rest.constant -= sign * part.constant;
    for (const auto& [atom, coefficient] : part.terms) rest.add(atom, -sign * coefficient);
    return rest;
  }

  void add(std::size_t atom, const Rational& coefficient) {
    Rational& value = terms[atom];
    value += coefficient;
    if (value == 0) terms.erase(atom);
  }
};

struct Part {
  std::size_t angle;
  int sign;
};

/// An angle whose sine and cosine the program has, or will have.
struct Entry {
  Angle angle;
  bool has_sine = false, has_cosine = false;
  std::optional<NodeId> argument{};            ///< none: the program does not ask for it
  int rotations = 0;                           ///< one after the other, until it is there
  std::optional<std::array<Part, 2>> parts{};  ///< none: by a call
};

struct Pair {
  NodeId sine, cosine;
};

class Rotator {
 public:
  Rotator(Graph& graph, const Request& request)
      : graph_(graph), order_(ir::post_order(graph, request.outputs)), rewrite_(graph) {
    for (const NodeId id : order_) collect(id);
    std::vector<std::size_t> by_size(entries_.size());
    for (std::size_t i = 0; i < by_size.size(); ++i) by_size[i] = i;
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t a, std::size_t b) { return entries_[a].angle.size() < entries_[b].angle.size(); });
    for (const std::size_t i : by_size) {
      take_apart(i);
      make_ready(i);
    }
  }

  Request run(const Request& request) {
    for (const NodeId id : order_) rewrite(id);
    return rewrite_(request);
  }

 private:
  bool is_circular(NodeId id) const {
    const Node& node = graph_[id];
    return node.kind == Kind::function && (node.function == Function::sin || node.function == Function::cos) &&
           graph_.varies(id);
  }

  std::size_t atom(NodeId id) {
    if (const std::size_t* known = atoms_.find(id)) return *known;
    nodes_.push_back(id);
    return atoms_[id] = nodes_.size() - 1;
  }

  /// Names do not hide what sums are made of.
  Angle angle_of(NodeId argument) {
    Angle angle;
    std::vector<Term> stack{{1, argument}};
    while (!stack.empty()) {
      const auto [factor, id] = stack.back();
      stack.pop_back();
      const NodeId open = unwrapped(graph_, id);
      const Node& node = graph_[open];
      if (node.kind != Kind::sum) {
        angle.add(atom(open), factor);
        continue;
      }
      angle.constant += factor * node.value;
      for (std::size_t i = node.children.size(); i-- > 0;)
        stack.push_back({factor * node.coefficients[i], node.children[i]});
    }
    return angle;
  }

  void collect(NodeId id) {
    if (!is_circular(id)) return;
    const NodeId argument = graph_[id].children[0];
    if (!entry_of_.contains(argument)) {
      entry_of_[argument] = entries_.size();
      entries_.push_back({angle_of(argument), false, false, argument});
    }
    Entry& entry = entries_[*entry_of_.find(argument)];
    (graph_[id].function == Function::sin ? entry.has_sine : entry.has_cosine) = true;
  }

  void make_ready(std::size_t index) {
    const Entry& entry = entries_[index];
    if (entry.rotations >= k_most_rotations) return;
    ready_.emplace(entry.angle, index);
    for (const auto& [atom, coefficient] : entry.angle.terms) ready_with_[atom].push_back(index);
  }

  /// One of those that are ready, or an angle of parameters alone.
  std::optional<Part> part_that_is(const Angle& angle) {
    if (const auto found = ready_.find(angle); found != ready_.end()) return Part{found->second, 1};
    if (const auto found = ready_.find(Angle().without(1, angle)); found != ready_.end()) {
      return Part{found->second, -1};
    }
    for (const auto& [atom, coefficient] : angle.terms) {
      if (graph_.varies(nodes_[atom])) return std::nullopt;
    }
    entries_.push_back({angle, true, true});
    ready_.emplace(angle, entries_.size() - 1);
    return Part{entries_.size() - 1, 1};
  }

  /// Calls `use` with each part of an angle that has its first term, the latest first, until it is true.
  template <class Use>
  bool any_part(const Angle& angle, const Use& use) {
    const auto first = std::find_if(angle.terms.begin(), angle.terms.end(),
                                    [&](const auto& term) { return graph_.varies(nodes_[term.first]); });
    if (first == angle.terms.end()) return false;
    const std::vector<std::size_t> candidates = ready_with_[first->first];
    for (auto it = candidates.rbegin(); it != candidates.rend(); ++it) {
      for (const int sign : {1, -1}) {
        if (angle.contains(sign, entries_[*it].angle) && use(Part{*it, sign})) return true;
      }
    }
    return false;
  }

  Angle without(const Angle& angle, Part part) const { return angle.without(part.sign, entries_[part.angle].angle); }

  void take_apart(std::size_t index) {
    const Angle angle = entries_[index].angle;
    const bool is_found = any_part(angle, [&](Part part) {
      const std::optional<Part> other = part_that_is(without(angle, part));
      return other && accept(index, {part, *other});
    });
    if (is_found || angle.terms.size() > k_most_terms) return;
    any_part(angle, [&](Part part) {
      const Angle rest = without(angle, part);
      return any_part(rest, [&](Part second) {
        const std::optional<Part> third = part_that_is(without(rest, second));
        return third && accept(index, {part, second, *third});
      });
    });
  }

  bool accept(std::size_t index, std::vector<Part> parts) {
    // The latest one last, so that nothing waits for it.
    std::stable_sort(parts.begin(), parts.end(), [&](Part a, Part b) { return rotations(a) < rotations(b); });
    int count = rotations(parts[0]);
    for (std::size_t i = 1; i < parts.size(); ++i) count = 1 + std::max(count, rotations(parts[i]));
    const Entry& entry = entries_[index];
    if (count > k_most_rotations || cost_of_rotations(entry, parts) >= cost_of_call(entry)) return false;
    while (parts.size() > 2) {
      parts[1] = {between(parts[0], parts[1]), 1};
      parts.erase(parts.begin());
    }
    put_together(index, {parts[0], parts[1]});
    return true;
  }

  int rotations(Part part) const { return entries_[part.angle].rotations; }

  void put_together(std::size_t index, const std::array<Part, 2>& parts) {
    Entry& entry = entries_[index];
    entry.rotations = 1 + std::max(rotations(parts[0]), rotations(parts[1]));
    entry.parts = parts;
    for (const Part& part : parts) entries_[part.angle].has_sine = entries_[part.angle].has_cosine = true;
  }

  /// An angle that the program has not asked for, on the way to one of three parts.
  std::size_t between(Part first, Part second) {
    const Angle sum = without(without(Angle(), {first.angle, -first.sign}), {second.angle, -second.sign});
    entries_.push_back({sum, true, true});
    put_together(entries_.size() - 1, {first, second});
    make_ready(entries_.size() - 1);
    return entries_.size() - 1;
  }

  double cost_of_call(const Entry& entry) const {
    return entry.has_sine && entry.has_cosine ? k_instructions_of_pair : k_instructions_of_one;
  }

  double cost_of_rotations(const Entry& entry, const std::vector<Part>& parts) const {
    const std::size_t functions = (entry.has_sine && entry.has_cosine ? 2 : 1) + 2 * (parts.size() - 2);
    double cost = k_instructions_of_rotation * static_cast<double>(functions);
    for (const Part& part : parts) cost += cost_of_rest(entries_[part.angle]);
    return cost;
  }

  /// What it takes until both the sine and the cosine of a part are there.
  double cost_of_rest(const Entry& part) const {
    if (part.has_sine && part.has_cosine) return 0;
    return part.parts ? k_instructions_of_rotation : k_instructions_of_pair - k_instructions_of_one;
  }

  void rewrite(NodeId id) {
    if (!rewrite_.knows(id)) rewrite_.replace(id, rewritten(id));
  }

  NodeId rewritten(NodeId id) {
    if (!is_circular(id)) return rewrite_.rebuilt(id);
    const std::size_t index = *entry_of_.find(graph_[id].children[0]);
    if (!entries_[index].parts) return rewrite_.rebuilt(id);
    const Pair values = pair(index);
    return graph_[id].function == Function::sin ? values.sine : values.cosine;
  }

  /// Also of what comes later in the program, as arguments of parts may.
  NodeId rewritten_first(NodeId root) {
    for (const NodeId id : ir::post_order(graph_, {root}, [&](NodeId id) { return rewrite_.knows(id); })) rewrite(id);
    return rewrite_(root);
  }

  /// What stands behind an angle are other ones, `k_most_rotations` deep at most.
  Pair pair(std::size_t index) {
    if (const auto known = pairs_.find(index); known != pairs_.end()) return known->second;
    const Entry& entry = entries_[index];
    const Pair made = entry.parts ? rotated((*entry.parts)[0], (*entry.parts)[1]) : called(entry);
    return pairs_.emplace(index, made).first->second;
  }

  Pair called(const Entry& entry) {
    const NodeId argument = entry.argument ? rewritten_first(*entry.argument) : sum(entry.angle);
    return {graph_.call(Function::sin, {argument}), graph_.call(Function::cos, {argument})};
  }

  NodeId sum(const Angle& angle) {
    std::vector<Term> terms;
    for (const auto& [atom, coefficient] : angle.terms) terms.push_back({coefficient, rewritten_first(nodes_[atom])});
    return graph_.linear(angle.constant, terms);
  }

  /// sin(a + b) = sin a cos b + cos a sin b, cos(a + b) = cos a cos b - sin a sin b
  Pair rotated(Part first, Part second) {
    const Pair a = pair(first.angle), b = pair(second.angle);
    const Rational sign_a = first.sign, sign_b = second.sign;
    const NodeId sine =
        graph_.linear(0, {{sign_a, graph_.product({a.sine, b.cosine})}, {sign_b, graph_.product({a.cosine, b.sine})}});
    const NodeId cosine = graph_.linear(
        0, {{1, graph_.product({a.cosine, b.cosine})}, {-sign_a * sign_b, graph_.product({a.sine, b.sine})}});
    return {closed(graph_, sine), closed(graph_, cosine)};
  }

  Graph& graph_;
  std::vector<NodeId> order_;
  Rewrite rewrite_;
  ir::NodeTable<std::size_t> atoms_;  ///< places in nodes_
  std::vector<NodeId> nodes_;
  ir::NodeTable<std::size_t> entry_of_;  ///< of an argument
  std::vector<Entry> entries_;
  std::map<Angle, std::size_t> ready_;                                    ///< those that may be parts
  std::unordered_map<std::size_t, std::vector<std::size_t>> ready_with_;  ///< the same by atom
  std::unordered_map<std::size_t, Pair> pairs_;
};

}  // namespace

Request rotate_angles(Graph& graph, const Request& request) { return Rotator(graph, request).run(request); }

}  // namespace gaussgen::passes
