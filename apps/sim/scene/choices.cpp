#include "sim/scene/choices.hpp"

#include "mechanics.hpp"
#include "sim/methods/methods.hpp"

namespace gausssim {

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> k_names = [] {
    std::vector<std::string> names{"auto"};
    for (const MethodInfo& method : methods()) names.push_back(method.name);
    return names;
  }();
  return k_names;
}

const std::vector<std::string>& number_names() {
  static const std::vector<std::string> k_names{"double", "float", "long-double", "float128"};
  return k_names;
}

const std::vector<std::string>& projection_names() {
  static const std::vector<std::string> k_names = [] {
    std::vector<std::string> names;
    for (const auto& one : k_projections) names.push_back(one.first);
    return names;
  }();
  return k_names;
}

const std::vector<std::string>& strategy_names() {
  using gaussgen::Strategy;
  static const std::vector<std::string> k_names{gaussgen::name_of(Strategy::automatic),
                                                gaussgen::name_of(Strategy::tree), gaussgen::name_of(Strategy::metric),
                                                gaussgen::name_of(Strategy::multipliers)};
  return k_names;
}

const std::vector<std::string>& code_names() {
  static const std::vector<std::string> k_names{"optimised", "expanded", "folded"};
  return k_names;
}

std::string form_by_strategy(const std::string& form, const std::string& strategy) { return form + ", " + strategy; }

const std::vector<std::string>& engine_names() {
  static const std::vector<std::string> k_names{"auto", "compiled", "interpreted"};
  return k_names;
}

}  // namespace gausssim
