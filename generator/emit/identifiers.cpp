#include "emit/identifiers.hpp"

#include <cctype>
#include <unordered_set>

#include "emit/macros.hpp"

namespace gaussgen::emit {

namespace {

using NameSet = std::unordered_set<std::string_view>;

// C++20, so that a header that works with C++17 goes on working, and C keywords that some compilers keep.
const NameSet k_keywords = {"alignas",
                            "alignof",
                            "and",
                            "and_eq",
                            "asm",
                            "auto",
                            "bitand",
                            "bitor",
                            "bool",
                            "break",
                            "case",
                            "catch",
                            "char",
                            "char16_t",
                            "char32_t",
                            "char8_t",
                            "class",
                            "co_await",
                            "co_return",
                            "co_yield",
                            "compl",
                            "concept",
                            "const",
                            "const_cast",
                            "consteval",
                            "constexpr",
                            "constinit",
                            "continue",
                            "decltype",
                            "default",
                            "delete",
                            "do",
                            "double",
                            "dynamic_cast",
                            "else",
                            "enum",
                            "explicit",
                            "export",
                            "extern",
                            "false",
                            "final",
                            "float",
                            "for",
                            "friend",
                            "goto",
                            "if",
                            "import",
                            "inline",
                            "int",
                            "long",
                            "module",
                            "mutable",
                            "namespace",
                            "new",
                            "noexcept",
                            "not",
                            "not_eq",
                            "nullptr",
                            "operator",
                            "or",
                            "or_eq",
                            "override",
                            "private",
                            "protected",
                            "public",
                            "register",
                            "reinterpret_cast",
                            "requires",
                            "restrict",
                            "return",
                            "short",
                            "signed",
                            "sizeof",
                            "static",
                            "static_assert",
                            "static_cast",
                            "struct",
                            "switch",
                            "template",
                            "this",
                            "thread_local",
                            "throw",
                            "true",
                            "try",
                            "typedef",
                            "typeid",
                            "typename",
                            "typeof",
                            "union",
                            "unsigned",
                            "using",
                            "virtual",
                            "void",
                            "volatile",
                            "wchar_t",
                            "while",
                            "xor",
                            "xor_eq"};

// Template parameter, types, arguments, tables and members of emitted code, and what it reaches by these names.
const NameSet k_own_names = {"Angles",
                             "Bool",
                             "Derivative",
                             "Inputs",
                             "Math",
                             "Parameters",
                             "Prepared",
                             "Quantity",
                             "S",
                             "State",
                             "Status",
                             "StatusOf",
                             "accelerations",
                             "constraint_table",
                             "coordinate_table",
                             "derivative",
                             "gauss",
                             "initial_state",
                             "input_members",
                             "input_table",
                             "inputs",
                             "live",
                             "n_constraints",
                             "n_inputs",
                             "n_parameters",
                             "n_q",
                             "n_v",
                             "name_of_model",
                             "out",
                             "parameter_members",
                             "parameter_table",
                             "parameters",
                             "prepare",
                             "prepared",
                             "from",
                             "solved",
                             "speed_table",
                             "state",
                             "status",
                             "std",
                             "t",
                             "values"};

}  // namespace

bool is_reserved(std::string_view name) {
  return k_keywords.count(name) != 0 || is_macro(name) || k_own_names.count(name) != 0;
}

std::string mangled(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool is_letter = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
    const char kept = is_letter ? c : '_';
    // Two underscores in a row, and one in front, belong to the compiler.
    if (kept != '_' || (!result.empty() && result.back() != '_')) result += kept;
  }
  if (result.empty() || std::isdigit(static_cast<unsigned char>(result[0])) != 0) result.insert(0, "v");
  return is_reserved(result) ? result + "_" : result;
}

std::string snake_case(const std::string& type_name) {
  std::string result;
  for (const char c : type_name) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (is_upper && !result.empty()) result += '_';
    result += is_upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

std::string pascal_case(const std::string& name) {
  std::string result;
  bool upper = true;
  for (const char c : name) {
    if (c == '_') {
      upper = true;
    } else {
      result += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = false;
    }
  }
  return result;
}

}  // namespace gaussgen::emit
