#pragma once
// Names of one function, and where their values are.

#include <absl/container/flat_hash_map.h>

#include <string>
#include <vector>

#include "sim/interpreter/place.hpp"
#include "sim/interpreter/writer.hpp"

namespace gausssim {

/// Scalars one after the other.
struct Reference {
  bool is_argument = false;
  std::uint32_t place = 0;  ///< first slot, or argument
  std::size_t offset = 0;   ///< in what the argument refers to
  Shape shape;              ///< {} of a scalar, and of a struct
  const Layout* layout = nullptr;

  std::size_t size() const { return layout == nullptr ? count_of(shape) : layout->size; }
  bool is_scalar() const { return layout == nullptr && shape.empty(); }
};

class Scope {
 public:
  explicit Scope(Writer& writer) : writer_(writer) {}

  void bind(const std::string& name, Reference reference) { variables_[name] = {std::move(reference), {}}; }
  /// An array of constants.
  void bind(const std::string& name, std::vector<Slot> elements, Shape shape) {
    variables_[name] = {{false, 0, 0, std::move(shape), nullptr}, std::move(elements)};
  }
  /// Of a name that is defined; of one that is defined again, as in the next round of a loop, the same.
  Reference define(const std::string& name, Shape shape, const Layout* layout);

  /// Throws std::invalid_argument where there is no such name.
  Reference operator[](const std::string& text) const;
  /// Of a name that is a scalar in the frame; null else.
  const Slot* scalar(const std::string& name) const;
  const std::vector<Slot>& elements(const std::string& name) const;

  /// Each has a place of its own: what does not depend on each other may be done in any order then.
  Slot temporary() { return writer_.slots(); }

 private:
  struct Variable {
    Reference reference;
    std::vector<Slot> elements;
  };

  Reference member(Reference object, const Place& place) const;
  std::size_t index(std::string_view text, std::size_t extent) const;

  Writer& writer_;
  absl::flat_hash_map<std::string, Variable> variables_;
};

}  // namespace gausssim
