#pragma once
// The functions that an expression may call.

#include <string>
#include <string_view>
#include <vector>

namespace gaussgen::model {

inline constexpr const char* k_dot = "dot";  ///< the total time derivative, a call of one argument

inline constexpr const char* k_distance = "distance";  ///< of two places by name
inline constexpr const char* k_piecewise = "piecewise";
inline constexpr std::size_t k_most_arguments = 64;

struct Function {
  const char* name;
  std::size_t arguments;                   ///< at least so many
  std::size_t most_arguments = arguments;  ///< and at most
};

/// nullptr for anything else; `dot` is among them.
const Function* find_function(std::string_view name);

std::vector<std::string> function_names();

/// How to write what another program's function gives: "write log(x)" for ln; empty for names that are no such function.
std::string substitute_for(std::string_view name);

/// Names that expressions already give a meaning: functions, `t`, `pi`, and `I`, which is an imaginary unit elsewhere.
bool is_reserved(std::string_view name);

}  // namespace gaussgen::model
