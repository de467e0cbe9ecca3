#include "sim/output/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "description.hpp"
#include "emit/identifiers.hpp"
#include "sim/engine/result_layouts.hpp"
#include "sim/model/layout.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;

/// a.b is in group a, a[0] likewise.
bool is_in(const std::string& name, const std::string& group) {
  if (name == group) return true;
  if (name.size() <= group.size() || name.compare(0, group.size(), group) != 0) return false;
  return name[group.size()] == '.' || name[group.size()] == '[';
}

class Chooser {
 public:
  explicit Chooser(const Described& model)
      : model_(model),
        is_energy_conserved_(find_struct(model.tree, "Energy") != nullptr &&
                             energy_layout_of(model.tree).is_conserved) {
    add_state();
    for (const std::string& output : sampled_outputs()) add_results(output);
  }

  const std::vector<Column>& all() const { return all_; }

  std::vector<std::string> groups() const {
    std::vector<std::string> names{"state", "accelerations"};
    for (const SampledFunction& one : functions_) {
      if (one.function != "rhs") names.push_back(one.function);
    }
    return names;
  }

  /// Indices into all().
  std::vector<std::size_t> named(const std::string& name) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const Column& column = all_[i];
      const bool is_wanted = name == "state"           ? column.is_state
                             : name == "accelerations" ? is_acceleration(column)
                                                       : is_in(column.name, name);
      if (is_wanted) found.push_back(i);
    }
    return found;
  }

  Columns take(const std::vector<std::size_t>& indices) const {
    Columns result;
    std::vector<std::size_t> place(functions_.size(), k_none);
    for (const std::size_t i : indices) {
      Column column = all_[i];
      if (!column.is_state) {
        std::size_t& at = place[column.source];
        if (at == k_none) {
          at = result.functions.size();
          result.functions.push_back(functions_[column.source]);
        }
        column.source = at;
      }
      result.columns.push_back(std::move(column));
    }
    return result;
  }

 private:
  static constexpr std::size_t k_none = static_cast<std::size_t>(-1);

  bool is_acceleration(const Column& column) const {
    return !column.is_state && functions_[column.source].function == "rhs";
  }

  void add_state() {
    std::size_t next = 0;
    for (const auto* entries : {&model_.unit.configuration, &model_.unit.speeds}) {
      for (const auto& entry : *entries) all_.push_back({entry.name, entry.unit, entry.about, true, next++, 0});
    }
    functions_.push_back({"rhs", model_.size()});
    std::size_t slot = model_.n_q();
    for (const auto& entry : model_.unit.accelerations)
      all_.push_back({entry.name, entry.unit, entry.about, false, 0, slot++});
  }

  void add_results(const std::string& output) {
    if (find_function(model_.tree, output) == nullptr) return;
    const std::vector<ResultNumber> slots = layout_of(model_.tree, gaussgen::emit::pascal_case(output));
    if (slots.empty()) return;
    for (std::size_t i = 0; i < slots.size(); ++i)
      all_.push_back({output + "." + slots[i].name, unit_of(slots[i]), slots[i].about, false, functions_.size(), i,
                      output == "energy" && slots[i].name == "total" && is_energy_conserved_});
    functions_.push_back({output, slots.size()});
  }

  /// Entries of one array may differ in their units: emitted code has none for them.
  std::string unit_of(const ResultNumber& slot) const {
    if (!slot.unit.empty()) return slot.unit;
    const auto begins_behind = [&](const char* member) {
      const std::size_t at = slot.name.rfind(member);
      return at == std::string::npos ? at : at + std::char_traits<char>::length(member);
    };
    if (begins_behind(".rotation[") != std::string::npos) return "1";
    const std::size_t begin = begins_behind(".generalized[");
    if (begin == std::string::npos) return "";
    const std::size_t speed = std::stoul(slot.name.substr(begin));
    return gaussgen::generalized_unit(model_.unit.speeds.at(speed).unit);
  }

  const Described& model_;
  bool is_energy_conserved_;
  std::vector<Column> all_;
  std::vector<SampledFunction> functions_;
};

/// Of a name one part of which is `part`, as far as that part; empty: there is none.
std::string member_with(const std::string& part, const std::vector<Column>& columns) {
  for (const Column& column : columns) {
    for (std::size_t dot = column.name.find('.'); dot != std::string::npos; dot = column.name.find('.', dot + 1)) {
      const std::size_t end = column.name.find_first_of(".[", dot + 1);
      if (column.name.substr(dot + 1, end - dot - 1) == part) return column.name.substr(0, end);
    }
  }
  return "";
}

std::string hint_for_output(const std::string& name, const Described& model) {
  const Chooser chooser(model);
  const std::string one =
      name.substr(0, name.find_last_not_of('s') + 1);  // of what somebody asks for in all, such as multipliers
  // Texts of `gauss-gen evaluate` name parts otherwise: multipliers.road, tip.z.
  const std::string last = name.substr(name.rfind('.') + 1), first = name.substr(0, name.find('.'));
  for (const std::string& part : {name, one, last, first}) {
    if (const std::string member = member_with(part, chooser.all()); !member.empty())
      return "did you mean '" + member + "'?";
  }
  for (const auto& held : model.unit.held) {
    if (held.name == name) return fmt::format("it is held at {}; the model tells it under `quantities`", held.held_at);
  }
  std::string near = gaussgen::support::did_you_mean(name, output_names(model));
  if (!near.empty()) return near;
  return "there are " + gaussgen::support::joined(chooser.groups()) +
         ", coordinates and speeds, and members such as energy.total";
}

std::vector<Word> usual() { return {{"state", {}}, {"energy", {}}}; }

}  // namespace

std::vector<std::string> names_of(const std::vector<SampledFunction>& functions) {
  std::vector<std::string> names;
  for (const SampledFunction& one : functions) names.push_back(one.function);
  return names;
}

const std::vector<std::string>& sampled_outputs() {
  static const std::vector<std::string> k_names{"reactions", "reaction_forces", "joint_reactions",
                                                "energy",    "mobility",        "mass_matrix",
                                                "jacobian",  "quantities",      "poses"};
  return k_names;
}

std::vector<std::string> output_names(const Described& model) {
  const Chooser chooser(model);
  std::vector<std::string> names = chooser.groups();
  for (const Column& column : chooser.all()) names.push_back(column.name);
  return names;
}

Columns choose_columns(const Described& model, const std::vector<Word>& wanted,
                       gaussgen::support::Diagnostics& diagnostics, const ListEverything& list) {
  const Chooser chooser(model);
  std::optional<Described> everything;
  std::vector<std::size_t> indices;
  for (const Word& word : wanted.empty() ? usual() : wanted) {
    const std::vector<std::size_t> found = chooser.named(word.text);
    if (found.empty() && !wanted.empty()) {
      if (!everything) everything = list ? list() : model;
      diagnostics.error(code::k_wrong_reference, word.span, fmt::format("the model has no output '{}'", word.text),
                        hint_for_output(word.text, *everything));
    }
    for (const std::size_t i : found) {
      if (std::find(indices.begin(), indices.end(), i) == indices.end()) indices.push_back(i);
    }
  }
  return chooser.take(indices);
}

std::vector<std::string> generator_outputs(const std::vector<Word>& wanted) {
  std::vector<std::string> outputs;
  for (const std::string& output : sampled_outputs()) {
    const auto asks = [&](const Word& word) { return is_in(word.text, output); };
    if (std::any_of(wanted.begin(), wanted.end(), asks)) outputs.push_back(output);
  }
  return outputs;
}

}  // namespace gausssim
