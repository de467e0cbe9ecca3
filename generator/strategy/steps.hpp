#pragma once
// What was computed, in words: groups of named values that the emitter prints together under one comment.

#include <string>
#include <utility>
#include <vector>

#include "ir/expr.hpp"
#include "ir/traverse.hpp"
#include "ir/vector3.hpp"

namespace gaussgen::strategy {

struct Step {
  std::string comment;
  std::string
      subject;  ///< constraint or held coordinate that the step is about, so that its line can be named; may be empty
  std::vector<std::pair<ir::NodeId, std::string>> values;
};

/// Collects steps in the order of the computation.
class Steps {
 public:
  void begin(std::string comment, std::string subject = "") {
    steps_.push_back({std::move(comment), std::move(subject), {}});
  }

  /// Values named elsewhere, into the current step.
  void append(const std::vector<std::pair<ir::NodeId, std::string>>& values) {
    steps_.back().values.insert(steps_.back().values.end(), values.begin(), values.end());
  }

  void append(const Steps& others) { steps_.insert(steps_.end(), others.steps_.begin(), others.steps_.end()); }

  /// Gives `value` its physical name in the current step and returns it as later steps shall use it.
  ir::Expr name(ir::Expr value, const std::string& name) {
    const ir::Expr result = value.named(name);
    if (steps_.empty()) begin("");
    // What has another name already, or is as simple as sin(theta), keeps what it is called.
    if (value.graph().label(result.id()) == name) steps_.back().values.emplace_back(result.id(), name);
    return result;
  }

  /// Likewise, unless parameters alone make the value: 1/m says more than the name of the one unknown that is equal to it.
  ir::Expr name_varying(ir::Expr value, const std::string& name) {
    return ir::is_of_parameters(value.graph(), value.id()) ? value : this->name(value, name);
  }

  /// The three components as <name>_x, <name>_y, <name>_z.
  ir::Vector3 name(const ir::Vector3& v, const std::string& name) {
    return {this->name(v[0], name + "_x"), this->name(v[1], name + "_y"), this->name(v[2], name + "_z")};
  }

  const std::vector<Step>& all() const { return steps_; }

 private:
  std::vector<Step> steps_;
};

}  // namespace gaussgen::strategy
