#pragma once
// The few elements of SVG that a chart has.

#include <string>
#include <vector>

#include "sim/plot/polyline.hpp"

namespace gausssim::plot {

/// Text as XML takes it.
std::string escaped(const std::string& text);

class Svg {
 public:
  Svg(double width, double height, const std::string& title);

  void line(Point from, Point to, const char* look);
  void rectangle(Point corner, double width, double height, const char* look);
  void polyline(const std::vector<Point>& points, const std::string& look);
  void dots(const std::vector<Point>& points, const std::string& look);
  /// `anchor`: start, middle or end; `turn` in degrees.
  void text(Point at, const std::string& words, const char* anchor, const char* look, double turn = 0);
  /// About all that follows until it ends, for readers that show what is under a pointer.
  void begin_group(const std::string& title);
  void end_group();

  std::string finished() const;

 private:
  std::string body_;
};

/// Classes of lines: a colour each that also those tell apart who see few, and dashes where there are more lines than colours.
std::string look_of_line(std::size_t i);
/// The same colours.
std::string look_of_dots(std::size_t i);

}  // namespace gausssim::plot
