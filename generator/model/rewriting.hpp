#pragma once
// A text in which parts are replaced; every byte keeps the place in the file that it comes from.

#include <string>

#include "spec/node.hpp"

namespace gaussgen::model {

class Rewriting {
 public:
  explicit Rewriting(const spec::LocatedText& text) : text_(text) {}

  /// The next `size` bytes as they are.
  void keep(std::size_t size) {
    for (; size > 0; --size, ++at_) push(text_.text[at_], text_.origin[at_]);
  }

  /// `replacement` instead of the next `size` bytes, of which there is one at least; all of it comes from the first.
  void replace(std::size_t size, const std::string& replacement) {
    put(replacement);
    at_ += size;
  }

  /// `addition` in front of the next byte.
  void put(const std::string& addition) {
    for (const char c : addition) push(c, text_.origin[at_]);
  }

  std::size_t at() const { return at_; }
  bool is_done() const { return at_ >= text_.text.size(); }
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.text.size() ? text_.text[at_ + ahead] : '\0'; }

  spec::LocatedText result() && {
    result_.span = text_.span;
    return std::move(result_);
  }

 private:
  void push(char c, std::uint32_t origin) {
    result_.text += c;
    result_.origin.push_back(origin);
  }

  const spec::LocatedText& text_;
  std::size_t at_ = 0;
  spec::LocatedText result_;
};

}  // namespace gaussgen::model
