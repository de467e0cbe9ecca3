#pragma once
// Lays out one statement on lines of limited length.

#include <string>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit::cpp {

/// A statement under construction: text with places where it may be broken, each with its depth in brackets.
class Line {
 public:
  explicit Line(std::size_t indent) : indent_(indent) {}

  Line& text(std::string_view part);
  Line& expression(const Expression& expression);

  /// With line breaks, the outermost possible ones, and without a final one.
  std::string str() const;

 private:
  struct Piece {
    std::string text;
    int depth;  ///< of the break before it; 0: none is allowed
  };

  void write(const Expression& expression, int outer);
  void write_sum(const Expression& sum);
  void write_list(const std::vector<Expression>& operands);
  void break_here() { pieces_.push_back({{}, depth_}); }

  std::size_t indent_;
  int depth_ = 1;
  std::vector<Piece> pieces_;
};

}  // namespace gaussgen::emit::cpp
