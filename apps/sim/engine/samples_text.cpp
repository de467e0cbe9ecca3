#include "sim/engine/samples_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "sim/model/layout.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

/// Beyond it, what is saved at samples is not worth the time of the compiler.
constexpr std::size_t k_most_statements = 400;

bool is_known_call(const std::string& function) {
  return function == "S" || function == "Bool" || function == "StatusOf<S>" || function.rfind("Math<S>::", 0) == 0 ||
         function.rfind("Angles<S>::", 0) == 0;
}

bool is_straight(const cpp::Expression& expression) {
  if (expression.kind == cpp::Expression::Kind::call && !is_known_call(expression.text)) return false;
  return std::all_of(expression.operands.begin(), expression.operands.end(),
                     [](const cpp::Expression& one) { return is_straight(one); });
}

/// Neither loops nor ways that depend on values, and nothing is called but mathematics.
struct StraightStatement {
  bool operator()(const cpp::Definition& one) const { return is_straight(one.value); }
  bool operator()(const cpp::Assignment& one) const { return is_straight(one.value); }
  bool operator()(const cpp::Evaluation& one) const { return is_straight(one.expression); }
  bool operator()(const cpp::Return& one) const { return is_straight(one.value); }
  bool operator()(const cpp::Declaration&) const { return true; }
  bool operator()(const cpp::Alias&) const { return true; }
  bool operator()(const cpp::BlankLine&) const { return true; }
  bool operator()(const cpp::Comment&) const { return true; }
  bool operator()(const cpp::EarlyReturn&) const { return false; }
  bool operator()(const cpp::Array&) const { return false; }
  bool operator()(const cpp::Loop&) const { return false; }
};

bool is_straight(const cpp::Function& function) {
  return std::all_of(function.body.begin(), function.body.end(),
                     [](const cpp::Statement& one) { return std::visit(StraightStatement{}, one); });
}

/// The function, or that of its two ways which is taken as long as its result is ok; null where it is no straight code.
const cpp::Function* straight_function(const cpp::File& tree, const std::string& name) {
  for (const std::string& one : {name, name + "_regular"}) {
    const cpp::Function* const function = find_function(tree, one);
    if (function != nullptr && is_straight(*function)) return function;
  }
  return nullptr;
}

/// With arguments of these names, and one result. Empty: it takes something else.
std::string call_of(const cpp::Function& function, const std::string& name_space, const std::string& result) {
  std::string arguments;
  bool has_result = false;
  for (const cpp::Argument& argument : function.arguments) {
    const std::string& type = argument.type;
    std::string given = type == "const S&"             ? "t"
                        : type == "const State<S>&"    ? "state"
                        : type == "const Inputs<S>&"   ? "inputs"
                        : type == "const Prepared<S>&" ? "prepared"
                                                       : result;
    const bool is_result = given == result;
    if (is_result && (has_result || type.rfind("const ", 0) == 0)) return "";
    has_result = has_result || is_result;
    arguments += (arguments.empty() ? "" : ", ") + given;
  }
  return has_result ? fmt::format("::{}::{}({})", name_space, function.name, arguments) : "";
}

/// `State` of `State<S>&`.
std::string result_type(const cpp::Function& function) {
  const std::string& type = function.arguments.back().type;
  return type.substr(0, type.find('<'));
}

}  // namespace

std::string samples_name(const std::vector<std::string>& functions) {
  return fmt::format("samples_of_{}", fmt::join(functions, "_"));
}

std::string sampled_text(const cpp::File& tree, const std::vector<std::string>& functions) {
  const std::string& name_space = tree.name_space;
  std::string projection = "result = state, gauss_sim_glue::LanesStatus{}";
  std::size_t statements = 0;
  if (find_function(tree, "project") != nullptr) {
    const cpp::Function* const function = straight_function(tree, "project");
    if (function == nullptr) return "";
    projection = call_of(*function, name_space, "result");
    statements += function->body.size();
  }
  std::string members, calls = "gauss_sim_glue::LanesStatus{}";
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const cpp::Function* const function = straight_function(tree, functions[i]);
    const std::string call = function == nullptr ? "" : call_of(*function, name_space, fmt::format("results.of_{}", i));
    if (call.empty()) return "";
    members += fmt::format("    ::{}::{}<Lanes> of_{};\n", name_space, result_type(*function), i);
    calls += " |\n           " + call;
    statements += function->body.size();
  }
  if (projection.empty() || statements > k_most_statements) return "";
  return fmt::format(R"(
struct GaussSimSampled {{
  using Lanes = gauss_sim_glue::Lanes;
  using State = GaussSimModel::State<Lanes>;
  using Prepared = GaussSimModel::Prepared<Lanes>;
  using Inputs = GaussSimModel::Inputs<Lanes>;
  struct Results {{
{}  }};
  static gauss_sim_glue::LanesStatus project(const Lanes& t, const State& state, const Prepared& prepared, State& result) {{
    return {};
  }}
  static gauss_sim_glue::LanesStatus functions(const Lanes& t, const State& state, const Inputs& inputs, const Prepared& prepared,
                                               Results& results) {{
    return {};
  }}
}};
)",
                     members, projection, calls);
}

}  // namespace gausssim
