#include "sim/plot/svg.hpp"

#include <fmt/format.h>

#include <array>

namespace gausssim::plot {

namespace {

/// Of Okabe and Ito; what is too dark or too light for one of the two grounds has another lightness there.
constexpr std::array<const char*, 6> k_on_light{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#444444"};
constexpr std::array<const char*, 6> k_on_dark{"#56b4e9", "#ff8c42", "#2fc79b", "#e9a3c9", "#f0e442", "#dddddd"};
constexpr std::array<const char*, 4> k_dashes{"", "6 3", "2 3", "9 3 2 3"};

std::string colours(const std::array<const char*, 6>& of, const std::string& ground, const std::string& ink,
                    const std::string& grid) {
  std::string text = fmt::format(":root{{--ground:{};--ink:{};--grid:{}", ground, ink, grid);
  for (std::size_t i = 0; i < of.size(); ++i) text += fmt::format(";--c{}:{}", i, of[i]);
  return text + "}";
}

std::string style() {
  std::string text = "<style>" + colours(k_on_light, "#ffffff", "#222222", "#dddddd");
  text += "@media(prefers-color-scheme:dark){" + colours(k_on_dark, "#16181c", "#e4e4e4", "#3a3d44") + "}";
  text += "text{font:13px system-ui,sans-serif;fill:var(--ink)}.tick{font-size:12px}.title{font-weight:600}";
  text += ".ground{fill:var(--ground)}.grid{stroke:var(--grid);stroke-width:1}";
  text += ".frame{fill:none;stroke:var(--ink);stroke-width:1;opacity:.6}";
  text += ".line{fill:none;stroke-width:1.6;stroke-linejoin:round}";
  text += ".dot{fill:none;stroke-width:4;stroke-linecap:round}";
  for (std::size_t i = 0; i < k_on_light.size(); ++i) text += fmt::format(".c{}{{stroke:var(--c{})}}", i, i);
  for (std::size_t i = 1; i < k_dashes.size(); ++i) text += fmt::format(".d{}{{stroke-dasharray:{}}}", i, k_dashes[i]);
  return text + "</style>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

std::string look_of_line(std::size_t i) {
  const std::size_t dash = i / k_on_light.size() % k_dashes.size();
  return fmt::format("line c{}{}", i % k_on_light.size(), dash == 0 ? "" : fmt::format(" d{}", dash));
}

std::string look_of_dots(std::size_t i) { return fmt::format("dot c{}", i % k_on_light.size()); }

Svg::Svg(double width, double height, const std::string& title) {
  body_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n",
      width, height);
  body_ += "<title>" + escaped(title) + "</title>\n" + style();
  rectangle({0, 0}, width, height, "ground");
}

void Svg::line(Point from, Point to, const char* look) {
  body_ += fmt::format("<path class=\"{}\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", look, from.x, from.y, to.x, to.y);
}

void Svg::rectangle(Point corner, double width, double height, const char* look) {
  body_ += fmt::format("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n", look,
                       corner.x, corner.y, width, height);
}

void Svg::polyline(const std::vector<Point>& points, const std::string& look) {
  body_ += fmt::format("<polyline class=\"{}\" points=\"", look);
  const char* before = "";
  for (const Point& point : points) {
    body_ += fmt::format("{}{:.2f},{:.2f}", before, point.x, point.y);
    before = " ";
  }
  body_ += "\"/>\n";
}

void Svg::dots(const std::vector<Point>& points, const std::string& look) {
  body_ += fmt::format("<path class=\"{}\" d=\"", look);
  for (const Point& point : points) body_ += fmt::format("M{:.2f} {:.2f}h0", point.x, point.y);
  body_ += "\"/>\n";
}

void Svg::text(Point at, const std::string& words, const char* anchor, const char* look, double turn) {
  const std::string turned =
      turn == 0 ? std::string() : fmt::format(" transform=\"rotate({} {:.2f} {:.2f})\"", turn, at.x, at.y);
  body_ += fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\"{}>{}</text>\n", look, at.x,
                       at.y, anchor, turned, escaped(words));
}

void Svg::begin_group(const std::string& title) { body_ += "<g><title>" + escaped(title) + "</title>\n"; }

void Svg::end_group() { body_ += "</g>\n"; }

std::string Svg::finished() const { return body_ + "</svg>\n"; }

}  // namespace gausssim::plot
