#pragma once
// What a scene and its instances say by the same keys.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/read_numbers.hpp"
#include "sim/scene/scene.hpp"

namespace gausssim {

/// Of one map. What is wrong is reported, and left out.
class FieldReader {
 public:
  /// `owner`: where a value is reported that has no place of its own.
  FieldReader(const gaussgen::spec::Node& map, gaussgen::support::Span owner, gaussgen::model::Reading& reading)
      : map_(map), owner_(owner), reading_(reading) {}

  /// One word, or a list of them.
  void effects(std::vector<Word>& to);
  void outputs(std::vector<Word>& to);
  /// A section of values by names.
  void given(const std::string& section, std::vector<Given>& to);
  std::optional<Word> choice(const std::string& key, const std::vector<std::string>& words);
  /// `places` gets that of the value.
  std::optional<double> positive(const std::string& key, std::map<std::string, gaussgen::support::Span>& places);
  void refuse_pair(const std::string& first, const std::string& second);

 private:
  void error(const std::string& id, gaussgen::support::Span span, const std::string& message, const std::string& hint);

  const gaussgen::spec::Node& map_;
  gaussgen::support::Span owner_;
  gaussgen::model::Reading& reading_;
  NumberReader numbers_{reading_};
};

}  // namespace gausssim
