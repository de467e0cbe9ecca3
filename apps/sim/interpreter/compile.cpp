#include <algorithm>
#include <stdexcept>
#include <variant>

#include "sim/interpreter/function_compiler.hpp"
#include "sim/interpreter/not_runnable.hpp"
#include "sim/interpreter/program.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

/// What a run would fail on is found here, and said with the function that it is in.
template <class Work>
void named(const std::string& name, const Work& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    throw NotRunnable(name, error.what());
  }
}

bool has_defaults(const cpp::Struct& type) {
  return std::any_of(type.members.begin(), type.members.end(),
                     [](const cpp::Member& member) { return member.type == "S" && member.value.has_value(); });
}

std::vector<int> numbers_in(const cpp::Expression& list, const Integers& integers) {
  std::vector<int> numbers;
  for (const cpp::Expression& item : list.operands) numbers.push_back(integers(item.text));
  return numbers;
}

Pattern pattern_of(const cpp::Struct& type, const Integers& integers) {
  Pattern pattern;
  pattern.name = type.name;
  for (const cpp::Member& member : type.members) {
    if (member.name == "rows") pattern.rows = integers(member.value->text);
    if (member.name == "columns") pattern.columns = integers(member.value->text);
    if (member.name == "row_begin") pattern.row_begin = numbers_in(*member.value, integers);
    if (member.name == "column") pattern.column = numbers_in(*member.value, integers);
  }
  return pattern;
}

class HeaderCompiler {
 public:
  Program run(const cpp::File& tree) {
    for (const cpp::Item& item : tree.items) declare(item);
    add_solution();
    for (const cpp::Item& item : tree.items) define(item);
    return std::move(writer_).finished();
  }

 private:
  /// Functions may use structs that stand behind them.
  void declare(const cpp::Item& item) {
    if (const auto* constant = std::get_if<cpp::Constant>(&item)) {
      if (constant->type == "int") writer_.integers.set(constant->name, writer_.integers(constant->value.text));
    } else if (const auto* type = std::get_if<cpp::Struct>(&item)) {
      named(type->name, [&] {
        if (type->is_template) {
          writer_.add(layout_of(*type, writer_.integers));
        } else {
          writer_.add(pattern_of(*type, writer_.integers));
        }
      });
    }
  }

  void add_solution() {
    const auto count = [this](const char* name) {
      return writer_.integers.has(name) ? static_cast<std::size_t>(writer_.integers(name)) : 0;
    };
    if (count("n_constraints") > 0) writer_.add(layout_of_solution(count("n_v"), count("n_constraints")));
  }

  void define(const cpp::Item& item) {
    const auto* type = std::get_if<cpp::Struct>(&item);
    if (type != nullptr && has_defaults(*type))
      named(type->name, [&] { FunctionCompiler(writer_).compile_defaults(*type); });
    const auto* function = std::get_if<cpp::Function>(&item);
    if (function != nullptr && function->name != "dense")
      named(function->name, [&] { FunctionCompiler(writer_).compile(*function); });
  }

  Writer writer_;
};

}  // namespace

Program compile(const cpp::File& tree) { return HeaderCompiler().run(tree); }

int Program::find(std::string_view function) const {
  const auto found =
      std::find_if(functions.begin(), functions.end(), [&](const Function& one) { return one.name == function; });
  return found == functions.end() ? -1 : static_cast<int>(found - functions.begin());
}

const Layout* Program::struct_of(std::string_view type) const {
  const auto found = std::find_if(structs.begin(), structs.end(), [&](const Layout& one) { return one.name == type; });
  return found == structs.end() ? nullptr : &*found;
}

}  // namespace gausssim
