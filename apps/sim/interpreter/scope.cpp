#include "sim/interpreter/scope.hpp"

#include <absl/strings/string_view.h>

#include <stdexcept>
#include <utility>

namespace gausssim {

Reference Scope::define(const std::string& name, Shape shape, const Layout* layout) {
  Reference reference{false, 0, 0, std::move(shape), layout};
  const auto known = variables_.find(name);
  const bool is_again = known != variables_.end() && !known->second.reference.is_argument &&
                        known->second.elements.empty() && known->second.reference.size() == reference.size();
  reference.place = is_again ? known->second.reference.place : writer_.slots(reference.size());
  variables_[name] = {reference, {}};
  return reference;
}

const Slot* Scope::scalar(const std::string& name) const {
  const auto found = variables_.find(name);
  if (found == variables_.end()) return nullptr;
  const Reference& reference = found->second.reference;
  return reference.is_argument || !reference.is_scalar() ? nullptr : &reference.place;
}

const std::vector<Slot>& Scope::elements(const std::string& name) const {
  const auto found = variables_.find(name);
  if (found == variables_.end() || found->second.elements.empty())
    throw std::invalid_argument("'" + name + "' is no list of numbers");
  return found->second.elements;
}

Reference Scope::operator[](const std::string& text) const {
  const Place place = place_of(text);
  const auto found = variables_.find(absl::string_view(place.object.data(), place.object.size()));
  if (found == variables_.end()) throw std::invalid_argument("'" + text + "' is not known");
  Reference reference = found->second.reference;
  if (!place.member.empty()) reference = member(std::move(reference), place);
  if (place.indices.size() > reference.shape.size() || (place.is_access && place.member.empty()))
    throw std::invalid_argument("'" + text + "' is no value");
  for (const std::string_view text_of_index : place.indices) {
    const std::size_t chosen = index(text_of_index, reference.shape.front());
    reference.shape.erase(reference.shape.begin());
    reference.offset += chosen * count_of(reference.shape);
  }
  if (reference.is_argument) return reference;
  if (!found->second.elements.empty()) {
    if (!reference.is_scalar()) throw std::invalid_argument("'" + text + "' is a list of numbers");
    reference.place = found->second.elements[reference.offset];
  } else {
    reference.place += static_cast<std::uint32_t>(reference.offset);
  }
  reference.offset = 0;
  return reference;
}

Reference Scope::member(Reference object, const Place& place) const {
  const Layout* const layout = object.layout;
  if (layout == nullptr) throw std::invalid_argument("'" + std::string(place.object) + "' has no members");
  object.layout = nullptr;
  if (place.is_access) {
    const auto found = layout->access.find(std::string(place.member));
    if (found == layout->access.end())
      throw std::invalid_argument(layout->name + " has no " + std::string(place.member) + "()");
    object.offset += found->second;
    return object;
  }
  const auto found = layout->places.find(std::string(place.member));
  if (found == layout->places.end())
    throw std::invalid_argument(layout->name + " has no member " + std::string(place.member));
  const Member& member = layout->members[found->second];
  object.offset += member.offset;
  object.shape = member.shape;
  return object;
}

std::size_t Scope::index(std::string_view text, std::size_t extent) const {
  const int value = writer_.integers(text);
  if (value < 0 || static_cast<std::size_t>(value) >= extent)
    throw std::invalid_argument("[" + std::string(text) + "] is outside of an array");
  return static_cast<std::size_t>(value);
}

}  // namespace gausssim
