#include "sim/run/shared_codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "sim/engine/plugin_text.hpp"
#include "sim/model/layout.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;
namespace model = gaussgen::model;

const SharedCode* SharedCodes::find(const std::string& key) const {
  const auto found =
      std::find_if(codes_.begin(), codes_.end(), [&](const SharedCode& code) { return code.key == key; });
  return found == codes_.end() ? nullptr : &*found;
}

std::size_t SharedCodes::add(SharedCode code, bool may_be_shared) {
  ++derivations_;
  const std::size_t number = number_of(code);
  if (number == texts_.size()) texts_.push_back(code.text);
  if (may_be_shared) codes_.push_back(std::move(code));
  return number;
}

std::size_t SharedCodes::number_of(const SharedCode& code) const {
  return static_cast<std::size_t>(std::find(texts_.begin(), texts_.end(), code.text) - texts_.begin());
}

namespace {

/// Which initial values are given, and which are guesses: what is open is found by searches that are emitted.
std::string given_start(const model::Model& read) {
  std::string text;
  for (const model::Coordinate& one : read.coordinates)
    text += fmt::format("{}{}{}{} ", one.initial ? "i" : "", one.guess ? "g" : "", one.initial_rate ? "r" : "",
                        one.rate_guess ? "h" : "");
  for (const model::Orientation& one : read.orientations) {
    text += one.is_open ? "o" : "";
    for (const auto& component : one.initial_angular_velocity) text += component ? "r" : "";
    text += " ";
  }
  return text;
}

}  // namespace

std::string key_of_code(const model::Model& read, const gaussgen::PipelineOptions& options) {
  std::string key = fmt::format("{} {} {}\n{}\n{}\n", gaussgen::name_of(options.strategy), options.fold, options.plain,
                                fmt::join(options.outputs, " "), fmt::join(options.where_possible, " "));
  for (const auto& [name, count] : options.choices.counts) key += fmt::format("{}={} ", name, count);
  for (const model::Effect& effect : read.effects) key += effect.acts ? "+" + effect.name.text + " " : "";
  for (const model::Parameter& one : read.parameters) key += one.is_formula ? "f" : "n";
  for (const auto& input : read.inputs) key += input.is_load ? "l" : "s";
  return key + "\n" + given_start(read);
}

bool may_be_shared(const gaussgen::PipelineResult& derived, const gaussgen::PipelineOptions& options) {
  const auto& artefacts = derived.unit.artefacts;
  const bool has_ways =
      std::any_of(artefacts.begin(), artefacts.end(), [](const auto& one) { return one.ways.has_value(); });
  return !options.fold && derived.unit.constraints.empty() && !has_ways;
}

namespace {

/// By their places: names differ where one of the two headers has a function that is called so.
void take_values(const cpp::Struct& from, cpp::Struct& to) {
  if (from.members.size() != to.members.size()) throw std::logic_error("instances differ in " + to.name);
  for (std::size_t i = 0; i < to.members.size(); ++i) {
    to.members[i].value = from.members[i].value;
    to.members[i].comment = from.members[i].comment;
  }
}

}  // namespace

gaussgen::PipelineResult with_values_of(const gaussgen::PipelineResult& start, const gaussgen::PipelineResult& code) {
  gaussgen::PipelineResult result = code;
  auto& items = result.tree.items;
  const auto is_start = [](const cpp::Item& item) {
    const auto* const function = std::get_if<cpp::Function>(&item);
    return function != nullptr && is_of_start(function->name);
  };
  items.erase(std::remove_if(items.begin(), items.end(), is_start), items.end());
  for (cpp::Item& item : items) {
    auto* const type = std::get_if<cpp::Struct>(&item);
    if (type == nullptr || (type->name != "Parameters" && type->name != "Inputs")) continue;
    take_values(*find_struct(start.tree, type->name), *type);
  }
  return result;
}

}  // namespace gausssim
