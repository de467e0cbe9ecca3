#pragma once
// Changes of a model that keep most of it readable, so that fuzzing gets behind the reader of YAML.

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fuzz {

class Mutation {
 public:
  Mutation(std::string text, unsigned seed) : text_(std::move(text)), random_(seed) {}

  /// Whether this one is left to libFuzzer, which knows bytes and the dictionary.
  bool is_of_bytes() { return below(4) == 0; }

  /// Lines doubled, dropped, moved; values and parts of expressions put in the place of others.
  Mutation& within_itself() { return with(text_); }

  /// The same with lines and values of another file.
  Mutation& with(const std::string& donor);

  /// Number of bytes; what is beyond `most` is cut off.
  std::size_t copied_to(std::uint8_t* out, std::size_t most) const;

 private:
  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }
  Range any_of(const std::vector<Range>& ranges) { return ranges.empty() ? Range{} : ranges[below(ranges.size())]; }
  void put(Range place, const std::string& piece) { text_.replace(place.begin, place.end - place.begin, piece); }
  void change(const std::string& donor);

  static std::vector<Range> lines(const std::string& text);
  static std::vector<Range> values(const std::string& text);
  static std::vector<Range> tokens(const std::string& text);

  std::string text_;
  std::mt19937 random_;
};

}  // namespace fuzz
