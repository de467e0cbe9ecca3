#include "emit/two_ways.hpp"

#include "emit/functions.hpp"
#include "emit/identifiers.hpp"
#include "emit/literal.hpp"

namespace gaussgen::emit {

namespace {

using cpp::Argument;
using cpp::Expression;

const char* const k_general = "_general";
const char* const k_kept = "begun";  ///< the state that was given, where the new one may be written over it

bool makes_state(const Artefact& artefact) { return artefact.target == Target::state; }

/// What is read, without results. A new state may be written over the one that it is made from.
std::vector<Argument> inputs_of(const Artefact& artefact, const std::string& from = "from") {
  std::vector<Argument> inputs;
  if (artefact.takes_time) inputs.push_back({"const S&", "t"});
  if (artefact.takes_start) inputs.push_back({"const State<S>&", "start"});
  if (artefact.takes_state) inputs.push_back({"const State<S>&", makes_state(artefact) ? from : "state"});
  if (artefact.takes_inputs) inputs.push_back({"const Inputs<S>&", "inputs"});
  inputs.push_back({"const Prepared<S>&", "prepared"});
  return inputs;
}

std::vector<Argument> inputs_of_system(Artefact artefact) {
  artefact.takes_start = false;
  return inputs_of(artefact);
}

const char* status_in_solution(Shown shown) {
  switch (shown) {
    case Shown::reactions: return "solved.reactions";
    case Shown::step: return "solved.step";
    default: return "solved.motion";
  }
}

Expression rank_rule(const TwoWays& ways) {
  const char* rule = ways.is_agreement_known ? "rank_on_positions<S>" : "rank_of_velocities<S>";
  if (ways.shown == Shown::step) rule = "rank_of_steps<S>";
  std::vector<Expression> arguments{cpp::atom(std::to_string(ways.usual_rank))};
  if (ways.rank_tolerance) arguments.push_back(cpp::call("rank_tolerance<S>", {literal(*ways.rank_tolerance)}));
  return cpp::call(rule, std::move(arguments));
}

std::vector<Argument> results_of(const Artefact& artefact) {
  std::vector<Argument> results;
  if (makes_state(artefact)) results.push_back({"State<S>&", "state"});
  if (!artefact.derivative.empty()) results.push_back({"Derivative<S>&", "derivative"});
  if (!artefact.result_type.empty())
    results.push_back({artefact.result_type + "<S>&", snake_case(artefact.result_type)});
  return results;
}

std::vector<Argument> operator+(std::vector<Argument> a, const std::vector<Argument>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Expression call_with(const std::string& function, const std::vector<Argument>& arguments) {
  std::vector<Expression> values;
  for (const Argument& argument : arguments) values.push_back(cpp::atom(argument.name));
  return cpp::call(function, std::move(values));
}

class GeneralWay {
 public:
  explicit GeneralWay(const Artefact& artefact) : artefact_(artefact), ways_(*artefact.ways) {}

  /// Results go to `results`; the status is in `status` then.
  void solve(cpp::Function& function, const std::vector<Argument>& results) {
    const std::vector<Argument> inputs = inputs_of(artefact_);
    const std::string type = "LinearSolution<S, n_v, n_constraints>";
    add(function, cpp::Declaration{"LinearSystem<S>", {"system"}});
    add(function,
        cpp::Definition{"StatusOf<S>", "status",
                        call_with(ways_.system, inputs_of_system(artefact_) + std::vector<Argument>{{"", "system"}})});
    add(function, cpp::Declaration{type, {"solved"}});
    add(function, cpp::Evaluation{cpp::call("solve", {cpp::atom("system"), rank_rule(ways_), cpp::atom("solved")})});
    if (ways_.shown == Shown::rank) return show_rank(function);
    worsen(function, cpp::atom(status_in_solution(ways_.shown)));
    const std::vector<Argument> solved = inputs + std::vector<Argument>{{"", "solved"}};
    worsen(function, call_with(ways_.of_solution, solved + results));
    if (ways_.rates) solve_rates(function, *ways_.rates, solved);
  }

 private:
  static void add(cpp::Function& function, cpp::Statement statement) { function.body.push_back(std::move(statement)); }

  void solve_rates(cpp::Function& function, const Rates& rates, const std::vector<Argument>& solved) const {
    const std::string count = std::to_string(rates.count), result = snake_case(artefact_.result_type) + ".";
    add(function, cpp::Declaration{rates.type + "<S>", {"sides"}});
    worsen(function, call_with(rates.sides, solved + std::vector<Argument>{{"", "sides"}}));
    add(function, cpp::Declaration{"S", {"rates[" + count + "][n_v]"}});
    worsen(function, cpp::call("solve_each", {cpp::atom("system"), rank_rule(ways_), cpp::atom("sides.f"),
                                              cpp::atom("sides.drift"), cpp::atom("rates")}));
    for (const Rates::Block& block : rates.blocks) {
      const std::string columns = std::to_string(block.columns);
      const std::string entry = result + block.member + "[" +
                                (block.base == 0 ? "" : std::to_string(block.base) + " + ") + columns + " * i + k]";
      const std::string rate = "rates[" + (block.first == 0 ? "" : std::to_string(block.first) + " + ") + "k][i]";
      cpp::Loop along{"k", "0", columns, {cpp::AnyStatement{cpp::Assignment{cpp::atom(entry), cpp::atom(rate)}}}};
      add(function, cpp::Loop{"i", "0", std::to_string(rates.speeds), {cpp::AnyStatement{std::move(along)}}});
    }
  }

  void show_rank(cpp::Function& function) const {
    const std::string result = snake_case(artefact_.result_type) + ".";
    add(function, cpp::Assignment{cpp::atom(result + "rank"), cpp::atom("solved.rank")});
    Expression left = cpp::sum({cpp::call("S", {cpp::atom("n_v")}), cpp::negated(cpp::atom("solved.rank"))});
    add(function, cpp::Assignment{cpp::atom(result + "mobility"), std::move(left)});
    cpp::Assignment copy{cpp::atom(result + "is_shared[mu]"), cpp::atom("solved.is_shared[mu]")};
    add(function, cpp::Loop{"mu", "0", std::to_string(ways_.rows), {cpp::AnyStatement{std::move(copy)}}});
  }

  static void worsen(cpp::Function& function, Expression with) {
    add(function,
        cpp::Assignment{cpp::atom("status"), cpp::call("Math<S>::worse", {cpp::atom("status"), std::move(with)})});
  }

  const Artefact& artefact_;
  const TwoWays& ways_;
};

/// For the lanes of `regular` that are lost.
cpp::Function general_function(const Artefact& artefact) {
  cpp::Function function = declared(artefact);
  function.name += k_general;
  function.comment = "Of " + artefact.name +
                     ": where constraints (nearly) follow from each other, or inertia is beyond all digits small. g a "
                     "= f + b^T lambda\n"
                     "and b a + drift = 0 are solved whatever their rank.";
  function.prefix = "GAUSS_PART";
  const std::vector<Argument> results = results_of(artefact);
  function.arguments = inputs_of(artefact) + std::vector<Argument>{{"const StatusOf<S>&", "regular"}} + results;
  std::vector<Argument> own;
  for (const Argument& result : results) {
    const std::string type = result.type.substr(0, result.type.size() - 1);
    own.push_back({result.type, "own_" + result.name});
    function.body.emplace_back(cpp::Declaration{type, {own.back().name}});
  }
  GeneralWay(artefact).solve(function, own);
  for (std::size_t i = 0; i < results.size(); ++i) {
    function.body.emplace_back(cpp::Evaluation{
        cpp::call("detail::take_lost<S>", {cpp::atom("regular"), cpp::atom(own[i].name), cpp::atom(results[i].name)})});
  }
  function.body.emplace_back(
      cpp::Return{cpp::call("detail::status_of_lost<S>", {cpp::atom("regular"), cpp::atom("status")})});
  return function;
}

}  // namespace

Parts two_ways(const Artefact& artefact) {
  const TwoWays& ways = *artefact.ways;
  const std::vector<Argument> inputs = inputs_of(artefact), results = results_of(artefact);
  cpp::Function function = declared(artefact);
  function.arguments = inputs + results;
  if (ways.regular.empty()) {
    GeneralWay(artefact).solve(function, results);
    function.body.emplace_back(cpp::Return{cpp::atom("status")});
    return {std::nullopt, {}, std::move(function)};
  }
  const std::vector<Argument> regular{{"", "regular"}};
  const bool keeps_state = makes_state(artefact) && artefact.takes_state;
  if (keeps_state) function.body.emplace_back(cpp::Definition{"const State<S>", k_kept, cpp::atom("from")});
  function.body.emplace_back(
      cpp::Definition{"const StatusOf<S>", "regular", call_with(ways.regular, inputs + results)});
  function.body.emplace_back(cpp::EarlyReturn{
      cpp::call("detail::is_lost<S>", {cpp::atom("regular")}),
      call_with(artefact.name + k_general, inputs_of(artefact, keeps_state ? k_kept : "from") + regular + results)});
  function.body.emplace_back(cpp::Return{cpp::atom("regular")});
  return {std::nullopt, {general_function(artefact)}, std::move(function)};
}

}  // namespace gaussgen::emit
