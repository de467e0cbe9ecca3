#include "emit/outputs.hpp"

#include <algorithm>

#include "support/assert.hpp"

namespace gaussgen::emit {

namespace {

constexpr auto k_conditions = std::tuple_size_v<Status>;

class Collector {
 public:
  Collector(const Plan& plan, const Task& task) : plan_(plan), values_(task.request.outputs) {
    const Artefact& artefact = *task.artefact;
    const Unit& unit = plan.unit;
    if (!artefact.derivative.empty()) {
      for (const std::string& rate : unit.configuration_rates) add_member("derivative", plan.names.of(rate));
      for (const Entry& entry : unit.accelerations) add_member("derivative", plan.names.of(entry));
    }
    if (!artefact.state.empty()) {
      const std::string suffix = artefact.takes_state ? "_new" : "";
      for (const Entry& entry : unit.configuration) add_member("state", plan.names.of(entry), suffix);
      for (const Entry& entry : unit.speeds) add_member("state", plan.names.of(entry), suffix);
    }
    for (const Group& group : artefact.groups) {
      for (const Field& field : group.fields) add_field(artefact.result_type, group, field);
    }
    GAUSS_ASSERT(outputs.size() + k_conditions == values_.size(), "{}: {} places for {} values", artefact.name,
                 outputs.size(), values_.size());
  }

  std::vector<Output> outputs;

 private:
  void add(const std::string& place, const std::string& name) {
    outputs.push_back({values_[outputs.size()], place, name});
  }

  void add_member(const std::string& object, const std::string& member, const std::string& suffix = "") {
    add(object + "." + member + "()", member + suffix);
  }

  void add_field(const std::string& type, const Group& group, const Field& field) {
    const std::string path = plan_.result_types.path(type, group.name, field.name);
    const std::string name = group.name.empty() ? field.name : group.name + "_" + field.name;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      const std::string index = index_text(field.shape, i);
      std::string suffix = index;
      std::replace(suffix.begin(), suffix.end(), '[', '_');
      suffix.erase(std::remove(suffix.begin(), suffix.end(), ']'), suffix.end());
      add(path + index, name + suffix);
    }
  }

  static std::string index_text(const std::vector<int>& shape, std::size_t position) {
    std::string text;
    for (auto size = shape.rbegin(); size != shape.rend(); ++size) {
      const auto extent = static_cast<std::size_t>(*size);
      text.insert(0, "[" + std::to_string(position % extent) + "]");
      position /= extent;
    }
    return text;
  }

  const Plan& plan_;
  const std::vector<NodeId>& values_;
};

}  // namespace

std::vector<Output> outputs_of(const Plan& plan, const Task& task) { return Collector(plan, task).outputs; }

Status status_of(const Task& task) {
  const std::vector<NodeId>& values = task.request.outputs;
  Status status{
      {{{}, "singular_mass_matrix"}, {{}, "dependent_constraints"}, {{}, "not_finite"}, {{}, "violated_constraints"}}};
  auto value = values.end() - k_conditions;
  for (Condition& condition : status) condition.node = *value++;
  return status;
}

}  // namespace gaussgen::emit
