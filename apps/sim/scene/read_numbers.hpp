#pragma once
// Numbers in a scene, with what is said where they are none.

#include <optional>
#include <string>

#include "model/fields.hpp"

namespace gausssim {

class NumberReader {
 public:
  explicit NumberReader(gaussgen::model::Reading& reading) : reading_(reading) {}

  /// Nothing, which is reported, where it is none or beyond the bounds; the hint has what is `usual`.
  std::optional<long> whole(const gaussgen::spec::Node& node, gaussgen::support::Span owner, long least, long most,
                            long usual);

  /// Of numbers alone. Nothing, which is reported, where it is not above 0; nothing without a word where there is no such key.
  std::optional<double> positive(const gaussgen::spec::Node& map, const std::string& key);

  /// Of numbers and pi.
  std::optional<double> real(const gaussgen::spec::Node& node, gaussgen::support::Span owner);

 private:
  std::optional<gaussgen::support::Rational> exact(const gaussgen::spec::Node& node, gaussgen::support::Span owner);
  void refuse(gaussgen::support::Span span, const std::string& message, const std::string& hint);
  bool is_sound(const gaussgen::model::Ast& ast);

  gaussgen::model::Reading& reading_;
  bool is_reported_ = false;  ///< what is wrong with the last number
};

}  // namespace gausssim
