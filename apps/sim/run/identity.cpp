#include "sim/run/identity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <variant>

#include "emit/cpp_printer.hpp"
#include "sim/engine/plugin_text.hpp"
#include "support/content_hash.hpp"

namespace gausssim {

namespace {

namespace cpp = gaussgen::emit::cpp;

bool is_of_values(const cpp::Item& item) {
  if (const auto* const type = std::get_if<cpp::Struct>(&item))
    return type->name == "Parameters" || type->name == "Inputs";
  const auto* const function = std::get_if<cpp::Function>(&item);
  return function != nullptr && function->name == "initial_state";
}

/// What is named like something else in the header has one of these at its end, and the header has what the method asks for.
std::string without_last_underscores(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    if (text[i] != '_' || std::isalnum(next) != 0 || next == '_') result += text[i];
  }
  return result;
}

}  // namespace

std::string identity_of(const PreparedModel& prepared) {
  cpp::File tree = prepared.model.tree;
  tree.before.clear();
  // Of a start that was derived by itself.
  const std::string start = prepared.model.start ? cpp::print(prepared.model.start->tree) : "";
  return gaussgen::support::content_hash(cpp::print(tree) + start);
}

std::string identity_of_problem(const PreparedModel& prepared) {
  cpp::File values;
  std::copy_if(prepared.model.tree.items.begin(), prepared.model.tree.items.end(), std::back_inserter(values.items),
               is_of_values);
  remove_words(values);
  // Forces may depend on the time, errors are those at the samples, and longest steps are those of all runs.
  const std::string times = fmt::format("{:a} {} {:a}\n", prepared.span.start, prepared.span.samples,
                                        prepared.scene.longest_step.value_or(0));
  std::string effects = prepared.has_effects() ? "effects" : "";
  for (const std::string& name : prepared.effects) effects += " " + name;
  return gaussgen::support::content_hash(times + effects + without_last_underscores(cpp::print(values)) +
                                         prepared.model_text);
}

}  // namespace gausssim
