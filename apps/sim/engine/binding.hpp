#pragma once
// An engine's functions with the parameters and inputs of a run.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/unit.hpp"
#include "sim/drive/motion_model.hpp"
#include "sim/engine/engine.hpp"

namespace gausssim {

/// A compiled model description, as the generator hands it over.
struct Described {
  gaussgen::emit::cpp::File tree;
  gaussgen::emit::Unit unit;
  /// Of a body that shares its code with others: what was derived for its start, with parameters and inputs in the same order. Null: the tree has the start.
  std::shared_ptr<const Described> start = nullptr;

  std::size_t n_q() const { return unit.configuration.size(); }
  std::size_t n_v() const { return unit.speeds.size(); }
  std::size_t size() const { return n_q() + n_v(); }
  /// Of a state.
  const std::string& component(std::size_t i) const {
    return i < n_q() ? unit.configuration[i].name : unit.speeds[i - n_q()].name;
  }
};

/// A function of the tree in an engine; an empty one where either lacks it.
template <class S>
Callable<S> callable(const Engine& engine, const Described& model, const std::string& function);

/// Of values of parameters or inputs.
template <class S>
using Change = std::function<void(std::vector<S>&)>;

/// With the values of the model's file, as `change` leaves them.
template <class S>
std::shared_ptr<Functions<S>> bind(const Engine& engine, const Described& model, const Change<S>& change = nullptr);

/// That of the model's file, on the constraints.
template <class S>
gauss::Status initial_state(const Engine& engine, const Described& model, const Functions<S>& functions,
                            Numbers<S>& state);

}  // namespace gausssim
