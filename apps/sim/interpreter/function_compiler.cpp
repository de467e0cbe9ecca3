#include "sim/interpreter/function_compiler.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "sim/interpreter/type_text.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

void FunctionCompiler::compile(const cpp::Function& function) {
  type_ = function.type;
  Function made;
  made.name = function.name;
  for (const cpp::Argument& argument : function.arguments) add_parameter(argument, made);
  const bool gives_value = type_ != "void" && type_ != "StatusOf<S>";
  if (gives_value) made.parameters.push_back({struct_in(type_), "result", true});
  writer_.add(made);
  bind_parameters(writer_.program().functions.back());
  for (const cpp::Statement& statement : function.body) write(statement);
  if (!has_ended_) writer_.write({Op::give_nothing});
  writer_.end_of_function();
}

void FunctionCompiler::add_parameter(const cpp::Argument& argument, Function& function) {
  const bool is_result = argument.type.rfind("const ", 0) != 0 && argument.type != "S";
  const ArrayName array = array_in(argument.name);
  if (array.extents.empty()) {
    function.parameters.push_back({struct_in(argument.type), argument.name, is_result});
    return;
  }
  // S (&piece)[5]
  const int count = writer_.integers(array.extents[0]);
  function.parameters.push_back({"S[" + std::to_string(count) + "]", array.name, true});
}

void FunctionCompiler::bind_parameters(const Function& function) {
  const bool gives_value = type_ != "void" && type_ != "StatusOf<S>";
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const bool is_returned = gives_value && i + 1 == function.parameters.size();
    bind_parameter(function.parameters[i], function.first_argument + i, is_returned);
  }
}

// What is one number, and only read, is read once.
void FunctionCompiler::bind_parameter(const Parameter& parameter, std::size_t argument, bool is_returned) {
  Reference reference{true, static_cast<std::uint32_t>(argument), 0, {}, nullptr};
  const bool is_scalar = parameter.type == "S" || parameter.type == "StatusOf";
  if (const ArrayName array = array_in(parameter.type); !array.extents.empty()) {
    reference.shape = {static_cast<std::size_t>(writer_.integers(array.extents[0]))};
  } else if (!is_scalar) {
    reference.layout = layout(parameter.type);
  }
  if (is_returned) {
    returned_ = reference;
  } else if (is_scalar && !parameter.is_result) {
    const Reference copied = scope_.define(parameter.name, {}, nullptr);
    writer_.load(copied.place, reference.place, 0);
  } else {
    scope_.bind(parameter.name, reference);
  }
}

const Layout* FunctionCompiler::layout(const std::string& type) const {
  const Layout* const found = writer_.layout(type);
  if (found == nullptr) throw std::invalid_argument("the type '" + type + "'");
  return found;
}

void FunctionCompiler::write(const Statement& statement) {
  std::visit([this](const auto& one) { this->statement(one); }, statement);
}

void FunctionCompiler::statement(const cpp::Definition& definition) {
  const TypeText type = type_in(definition.type);
  if (type.name == "int") return define_numbers(definition);
  if (type.name == "S" || type.name == "Bool" || type.name == "StatusOf")
    return define_scalar(definition, type.is_const && type.is_reference);
  if (definition.value.kind != cpp::Expression::Kind::atom)
    throw std::invalid_argument("a definition of a " + type.name);
  const Reference made = scope_.define(definition.name, {}, layout(type.name));
  expressions_.copy(scope_[definition.value.text], made);
}

// A name for what has one stays a name: nobody changes what is called const.
void FunctionCompiler::define_scalar(const cpp::Definition& definition, bool is_reference) {
  const bool is_name = definition.value.kind == cpp::Expression::Kind::atom;
  if (is_reference && is_name) {
    const Reference known = scope_[definition.value.text];
    if (!known.is_argument && known.is_scalar()) return scope_.bind(definition.name, known);
  }
  const Reference made = scope_.define(definition.name, {}, nullptr);
  expressions_.put(definition.value, made.place);
}

/// const int by_one[n_q + n_v] = {1, 0};
void FunctionCompiler::define_numbers(const cpp::Definition& definition) {
  if (definition.value.kind != cpp::Expression::Kind::list) throw std::invalid_argument("a definition of an int");
  std::vector<Slot> elements;
  for (const cpp::Expression& element : definition.value.operands)
    elements.push_back(writer_.number(writer_.integers(element.text)));
  const std::size_t count = elements.size();
  scope_.bind(array_in(definition.name).name, std::move(elements), {count});
}

void FunctionCompiler::statement(const cpp::Declaration& declaration) {
  const TypeText type = type_in(declaration.type);
  for (const std::string& name : declaration.names) {
    if (type.name == "detail::Newton") {
      // It is on its way.
      writer_.move(scope_.define(name, {}, nullptr).place, writer_.number(1));
    } else if (type.name == "S") {
      const ArrayName array = array_in(name);
      Shape shape;
      for (const std::string& extent : array.extents)
        shape.push_back(static_cast<std::size_t>(writer_.integers(extent)));
      (void)scope_.define(array.name, std::move(shape), nullptr);
    } else {
      (void)scope_.define(name, {}, layout(type.name));
    }
  }
}

void FunctionCompiler::statement(const cpp::Assignment& assignment) {
  if (assignment.target.kind != cpp::Expression::Kind::atom) throw std::invalid_argument("an assignment to no name");
  const Reference target = scope_[assignment.target.text];
  if (!target.is_scalar()) {
    if (assignment.value.kind != cpp::Expression::Kind::atom) throw std::invalid_argument("a value of a struct");
    return expressions_.copy(scope_[assignment.value.text], target);
  }
  if (replace(target, assignment)) return;
  const Slot value = expressions_.value(assignment.value);
  expressions_.copy({false, value, 0, {}, nullptr}, target);
}

/// x = select(condition, value, x)
bool FunctionCompiler::replace(const Reference& target, const cpp::Assignment& assignment) {
  const cpp::Expression& value = assignment.value;
  const bool may = !target.is_argument && value.text == "Math<S>::select" && value.operands.size() == 3 &&
                   value.operands[2].kind == cpp::Expression::Kind::atom &&
                   value.operands[2].text == assignment.target.text;
  if (!may) return false;
  const Slot condition = expressions_.value(value.operands[0]), yes = expressions_.value(value.operands[1]);
  writer_.write({Op::replace, 1, target.place, condition, yes});
  return true;
}

void FunctionCompiler::statement(const cpp::Evaluation& evaluation) { expressions_.evaluate(evaluation.expression); }

void FunctionCompiler::statement(const cpp::Return& end) {
  give(end.value);
  has_ended_ = true;
}

void FunctionCompiler::give(const cpp::Expression& value) {
  if (type_ == "StatusOf<S>") {
    writer_.write({Op::give_status, 1, 0, expressions_.value(value), 0});
    return;
  }
  if (type_ == "void") throw std::invalid_argument("a value of a function without one");
  const bool is_struct = returned_.layout != nullptr;
  if (is_struct && value.kind != cpp::Expression::Kind::atom) throw std::invalid_argument("a value of a struct");
  const Reference from = is_struct ? scope_[value.text] : Reference{false, expressions_.value(value), 0, {}, nullptr};
  expressions_.copy(from, returned_);
  writer_.write({Op::give_nothing});
}

void FunctionCompiler::statement(const cpp::EarlyReturn& end) {
  const std::size_t jump = writer_.jump_if_zero(expressions_.value(end.condition));
  give(end.value);
  writer_.land(jump);
}

void FunctionCompiler::statement(const cpp::Array& array) {
  std::vector<Slot> elements;
  for (const auto& row : array.rows) {
    for (const cpp::Expression& element : row) {
      elements.push_back(expressions_.value(element));
      if (writer_.constant_at(elements.back()) == nullptr) throw std::invalid_argument("an array of what is no number");
    }
  }
  scope_.bind(array.name, std::move(elements), {array.rows.size(), array.rows.front().size()});
}

// Round by round, each with the numbers of its own: no index is left.
void FunctionCompiler::statement(const cpp::Loop& loop) {
  const int from = writer_.integers(loop.from), to = writer_.integers(loop.to);
  std::vector<std::size_t> ends;
  for (int round = from; round < to; ++round) {
    writer_.integers.set(loop.index, round);
    if (!loop.condition.empty()) {
      const std::string brackets = "()";
      const std::string callee = loop.condition.substr(0, loop.condition.size() - brackets.size());
      ends.push_back(writer_.jump_if_zero(expressions_.value(cpp::call(callee, {}))));
    }
    for (const cpp::AnyStatement& inner : loop.body) write(inner.statement);
  }
  for (const std::size_t end : ends) writer_.land(end);
}

void FunctionCompiler::statement(const cpp::Alias& alias) {
  if (alias.name != "Bool") throw std::invalid_argument("the type '" + alias.name + "'");
}

void FunctionCompiler::compile_defaults(const cpp::Struct& type) {
  type_ = "void";
  Function made;
  made.name = type.name;
  made.parameters.push_back({type.name, "filled", true});
  writer_.add(made);
  const Layout& members = *layout(type.name);
  const auto filled = static_cast<std::uint32_t>(writer_.program().functions.back().first_argument);
  for (const cpp::Member& member : type.members) {
    if (!member.value) throw std::invalid_argument("the member '" + member.name + "' has no default value");
    const Slot value = expressions_.value(*member.value);
    const std::size_t offset = members.members[members.places.at(member.name)].offset;
    writer_.store(value, filled, offset);
  }
  writer_.write({Op::give_nothing});
  writer_.end_of_function();
}

}  // namespace gausssim
