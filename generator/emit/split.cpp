#include "emit/split.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "emit/operations.hpp"

namespace gaussgen::emit {

namespace {

using Names = std::vector<std::string>;

/// What stands before the first dot: of `prepared.m` the argument.
std::string object_of(const std::string& text) { return text.substr(0, text.find('.')); }

void add_atoms(const cpp::Expression& expression, std::set<std::string>& atoms) {
  if (expression.kind == cpp::Expression::Kind::atom) atoms.insert(expression.text);
  for (const cpp::Expression& operand : expression.operands) add_atoms(operand, atoms);
}

struct AtomsOf {
  std::set<std::string>& atoms;

  void operator()(const cpp::Definition& s) const { add_atoms(s.value, atoms); }
  void operator()(const cpp::Evaluation& s) const { add_atoms(s.expression, atoms); }
  void operator()(const cpp::Return& s) const { add_atoms(s.value, atoms); }
  void operator()(const cpp::EarlyReturn& s) const {
    add_atoms(s.condition, atoms);
    add_atoms(s.value, atoms);
  }
  void operator()(const cpp::Assignment& s) const {
    add_atoms(s.target, atoms);
    add_atoms(s.value, atoms);
  }
  template <class Other>
  void operator()(const Other&) const {}
};

std::set<std::string> atoms_of(const std::vector<cpp::Statement>& statements) {
  std::set<std::string> atoms;
  for (const cpp::Statement& statement : statements) std::visit(AtomsOf{atoms}, statement);
  return atoms;
}

int cost_of(const std::vector<cpp::Statement>& statements) { return total(operations_of(statements)); }

/// Statements that stay together: a definition, sines and cosines with their declarations, a result.
struct Step {
  std::string comment;
  std::vector<cpp::Statement> statements;
  Names defined;
  bool is_condition = false;
  std::set<std::string> atoms = {};
  std::pair<std::size_t, std::size_t> place =
      {};  ///< among the others; the second number orders what moved to one place
};

constexpr std::size_t k_nowhere = static_cast<std::size_t>(-1);

class Splitter {
 public:
  Splitter(FunctionCode code, int most) : code_(std::move(code)), most_(most) {}

  Parts run() {
    if (cost_of(code_.function.body) < 2 * most_) return {std::nullopt, {}, std::move(code_.function)};
    take_apart();
    move_up();
    find_ranges();
    cut();
    return assembled();
  }

 private:
  struct Value {
    std::size_t defined = 0;    ///< step
    std::size_t last_used = 0;  ///< step
    bool is_condition = false;
    std::size_t place = 0;            ///< in order_
    std::size_t written = k_nowhere;  ///< step that writes it into a result,
    std::string home = {};            ///< where it is from then on
  };

  void take_apart() {
    std::vector<cpp::Statement>& body = code_.function.body;
    for (std::size_t i = 0; i < code_.reads; ++i) {
      if (const auto* read = std::get_if<cpp::Definition>(&body[i])) reads_.push_back(*read);
    }
    Step step;
    for (std::size_t i = code_.reads; i < body.size(); ++i) {
      if (auto* comment = std::get_if<cpp::Comment>(&body[i])) {
        step.comment = comment->text;
      } else if (std::holds_alternative<cpp::Return>(body[i])) {
        end_ = body[i];
      } else if (!std::holds_alternative<cpp::BlankLine>(body[i])) {
        add(step, std::move(body[i]));
      }
    }
    body.clear();  // every part starts from a copy of the function
  }

  // A declaration waits for the call that fills it.
  void add(Step& step, cpp::Statement statement) {
    const auto* declaration = std::get_if<cpp::Declaration>(&statement);
    const bool is_complete = declaration == nullptr;
    if (declaration != nullptr)
      step.defined.insert(step.defined.end(), declaration->names.begin(), declaration->names.end());
    if (const auto* definition = std::get_if<cpp::Definition>(&statement)) {
      step.defined.push_back(definition->name);
      step.is_condition = definition->type == "const Bool";
    }
    step.statements.push_back(std::move(statement));
    if (!is_complete) return;
    step.atoms = atoms_of(step.statements);
    steps_.push_back(std::move(step));
    step = {};
  }

  // Results, and checks of them, as soon as their values are there, so that fewer values are live.
  void move_up() {
    std::unordered_map<std::string, std::size_t> defined;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      Step& step = steps_[i];
      const bool is_result = std::holds_alternative<cpp::Assignment>(step.statements.back());
      step.place = {i, 0};
      if (step.is_condition || (is_result && !code_.may_alias)) {
        std::size_t last = 0;
        for (const std::string& atom : step.atoms) {
          if (const auto found = defined.find(atom); found != defined.end()) last = std::max(last, found->second);
        }
        step.place = {last, i + 1};
      }
      for (const std::string& name : step.defined) defined[name] = step.place.first;
    }
    std::stable_sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) { return a.place < b.place; });
  }

  void find_ranges() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      for (const std::string& name : steps_[i].defined) {
        values_[name] = {i, i, steps_[i].is_condition, order_.size()};
        order_.push_back(name);
      }
      for (const std::string& atom : steps_[i].atoms) use(atom, i);
      find_home(i);
    }
    std::set<std::string> at_the_end;
    std::visit(AtomsOf{at_the_end}, end_);
    for (const std::string& atom : at_the_end) use(atom, steps_.size());
  }

  void use(const std::string& name, std::size_t step) {
    if (const auto found = values_.find(name); found != values_.end()) found->second.last_used = step;
  }

  void find_home(std::size_t step) {
    const auto* result = std::get_if<cpp::Assignment>(&steps_[step].statements.back());
    if (result == nullptr || code_.may_alias) return;
    const auto value = values_.find(result->value.text);
    if (value == values_.end() || value->second.written != k_nowhere) return;
    value->second.written = step;
    value->second.home = result->target.text;
  }

  // Where the fewest values are live, between half of a part and one and a half.
  void cut() {
    std::vector<int> change(steps_.size() + 1);
    for (const std::string& name : order_) {
      const Value& value = values_.at(name);
      ++change[value.defined];
      --change[std::min(value.last_used, value.written)];
    }
    int live = 0, cost = 0, fewest = 0;
    std::size_t best = k_nowhere;
    begins_ = {0};
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      live += change[i];
      cost += cost_of(steps_[i].statements);
      if (2 * cost >= most_ && (best == k_nowhere || live <= fewest)) {
        best = i + 1;
        fewest = live;
        cost_at_best_ = cost;
      }
      if (2 * cost < 3 * most_) continue;
      begins_.push_back(best);
      cost -= cost_at_best_;
      best = k_nowhere;
    }
    if (begins_.back() == steps_.size()) begins_.pop_back();
  }

  Parts assembled() {
    Parts parts;
    cpp::Function main = code_.function;
    main.body.clear();
    for (cpp::Argument& argument : main.arguments) argument.is_used = true;
    std::vector<cpp::Expression> arguments;
    for (const cpp::Argument& argument : main.arguments) arguments.push_back(cpp::atom(argument.name));
    arguments.push_back(cpp::atom(k_live));
    for (std::size_t p = 0; p < begins_.size(); ++p) {
      const bool is_last = p + 1 == begins_.size();
      parts.functions.push_back(part(p, is_last ? steps_.size() : begins_[p + 1], is_last));
      cpp::Expression call = cpp::call(parts.functions.back().name, arguments);
      if (is_last) {
        main.body.emplace_back(cpp::Return{std::move(call)});
      } else {
        main.body.emplace_back(cpp::Evaluation{std::move(call)});
      }
    }
    parts.live = live_struct();
    main.body.insert(main.body.begin(), cpp::Declaration{parts.live->name + "<S>", {k_live}});
    parts.function = std::move(main);
    return parts;
  }

  std::string type_of_live() const {
    std::string name = "LiveIn";
    bool is_first = true;
    for (const char c : code_.function.name) {
      if (c != '_') name += is_first && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
      is_first = c == '_';
    }
    return name;
  }

  cpp::Struct live_struct() const {
    cpp::Struct type;
    type.comment = "What the parts of " + code_.function.name + " hand on.";
    type.name = type_of_live();
    for (const std::string& name : order_) {
      if (handed_on_.count(name) == 0) continue;
      const char* const kind = values_.at(name).is_condition ? "typename Math<S>::Bool" : "S";
      type.members.push_back({kind, name, {}, std::nullopt, {}});
    }
    return type;
  }

  cpp::Function part(std::size_t p, std::size_t end, bool is_last) {
    const std::size_t begin = begins_[p];
    cpp::Function function = code_.function;
    function.comment = "Part " + std::to_string(p + 1) + " of " + code_.function.name + ".";
    function.prefix = "GAUSS_PART";
    function.name = code_.function.name + "_part_" + std::to_string(p + 1);
    if (!is_last) function.type = "void";
    function.body = body_of(begin, end, is_last);

    std::set<std::string> objects;
    for (const std::string& atom : atoms_of(function.body)) objects.insert(object_of(atom));
    for (cpp::Argument& argument : function.arguments) argument.is_used = objects.count(argument.name) != 0;
    function.arguments.push_back({type_of_live() + "<S>&", k_live, objects.count(k_live) != 0});
    return function;
  }

  // Each step is in one part.
  std::vector<cpp::Statement> body_of(std::size_t begin, std::size_t end, bool is_last) {
    std::vector<cpp::Statement> work;
    for (std::size_t i = begin; i < end; ++i) {
      Step& step = steps_[i];
      if (!step.comment.empty()) {
        work.emplace_back(cpp::BlankLine{});
        work.emplace_back(cpp::Comment{step.comment});
      }
      std::move(step.statements.begin(), step.statements.end(), std::back_inserter(work));
    }
    if (is_last) {
      work.emplace_back(cpp::BlankLine{});
      work.push_back(end_);
    }
    std::vector<cpp::Statement> body = beginning(begin, end, atoms_of(work));
    if (!body.empty() && (work.empty() || !std::holds_alternative<cpp::BlankLine>(work.front())))
      body.emplace_back(cpp::BlankLine{});
    std::move(work.begin(), work.end(), std::back_inserter(body));
    if (!is_last) hand_on(begin, end, body);
    return body;
  }

  /// Local names for what a part reads, of the arguments and of earlier parts.
  std::vector<cpp::Statement> beginning(std::size_t begin, std::size_t end, const std::set<std::string>& atoms) {
    std::vector<cpp::Statement> body;
    for (const cpp::Definition& read : reads_) {
      if (atoms.count(read.name) != 0) body.emplace_back(read);
    }
    bool has_conditions = false;
    for (std::size_t i = begin; i < end; ++i) has_conditions = has_conditions || steps_[i].is_condition;
    for (const std::size_t i : places_before(begin, atoms)) {
      const std::string& name = order_[i];
      const Value& value = values_.at(name);
      const bool is_written = value.written < begin;
      has_conditions = has_conditions || value.is_condition;
      const std::string place = is_written ? value.home : k_live + ("." + name);
      body.emplace_back(cpp::Definition{value.is_condition ? "const Bool&" : "const S&", name, cpp::atom(place)});
    }
    if (has_conditions) body.insert(body.begin(), cpp::Alias{"Bool", "typename Math<S>::Bool"});
    return body;
  }

  /// Where in order_ those of the atoms are that earlier parts define.
  std::vector<std::size_t> places_before(std::size_t begin, const std::set<std::string>& atoms) const {
    std::vector<std::size_t> places;
    for (const std::string& atom : atoms) {
      const auto found = values_.find(atom);
      if (found != values_.end() && found->second.defined < begin) places.push_back(found->second.place);
    }
    std::sort(places.begin(), places.end());
    return places;
  }

  void hand_on(std::size_t begin, std::size_t end, std::vector<cpp::Statement>& body) {
    Names own;
    for (std::size_t i = begin; i < end; ++i) own.insert(own.end(), steps_[i].defined.begin(), steps_[i].defined.end());
    bool is_first = true;
    for (const std::string& name : own) {
      const Value& value = values_.at(name);
      const bool is_needed = value.last_used >= end && value.written >= end;
      if (!is_needed) continue;
      if (is_first) body.emplace_back(cpp::BlankLine{});
      is_first = false;
      handed_on_.insert(name);
      body.emplace_back(cpp::Assignment{cpp::atom(k_live + ("." + name)), cpp::atom(name)});
    }
  }

  inline static const std::string k_live = "live";

  FunctionCode code_;
  int most_;
  std::vector<cpp::Definition> reads_;
  std::vector<Step> steps_;
  cpp::Statement end_ = cpp::BlankLine{};
  std::unordered_map<std::string, Value> values_;
  Names order_;  ///< of definition
  std::vector<std::size_t> begins_;
  int cost_at_best_ = 0;
  std::set<std::string> handed_on_;
};

}  // namespace

Parts split(FunctionCode code, int most) {
  if (code.type) return {std::move(code.type), {}, std::move(code.function)};
  return Splitter(std::move(code), most).run();
}

}  // namespace gaussgen::emit
