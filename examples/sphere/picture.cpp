#include "picture.hpp"

#include <algorithm>
#include <cstdio>

namespace sphere {

namespace {

constexpr double k_pi = 3.14159265358979323846;

constexpr const char* k_ink = "#24292f";
constexpr const char* k_soft = "#8c959f";
constexpr const char* k_line = "#d0d7de";
constexpr const char* k_blue = "#0550ae";
constexpr const char* k_red = "#cf222e";
constexpr const char* k_green = "#1a7f37";

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

struct Pixel {
  double x, y;
};

std::string text_at(Pixel p, const std::string& words, const char* colour, const char* anchor = "start") {
  return format("<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"%s\">%s</text>\n", p.x, p.y, colour, anchor,
                words.c_str());
}

std::string segment(Pixel a, Pixel b, const char* colour, double width = 1) {
  return format("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"%g\"/>\n", a.x, a.y, b.x, b.y, colour,
                width);
}

std::string polyline(const std::vector<Pixel>& points, const char* colour, double width, const char* more = "") {
  if (points.size() < 2) return "";
  std::string path = "<path d=\"M";
  for (const Pixel& p : points) path += format("%.1f %.1f ", p.x, p.y);
  path.back() = '"';
  return path + format(" stroke=\"%s\" stroke-width=\"%g\" %s/>\n", colour, width, more);
}

/// From above and in front: y points away from the eye.
class Scene {
 public:
  explicit Scene(const ClosedForm& exact) : data_(exact.data()) {}

  Pixel project(const SpaceVector& r) const {
    return {k_middle + k_scale * r[0], k_zero - k_scale * (r[2] * k_flat + r[1] * k_tilt)};
  }

  SpaceVector on_circle(double radius, const Motion& m) const {
    return {radius * std::cos(m.chi), radius * std::sin(m.chi), m.z};
  }
  SpaceVector centre(const Motion& m) const { return on_circle(data_.R - data_.r, m); }
  bool is_behind(const Motion& m) const { return std::sin(m.chi) > 0; }

  std::string rim(double z, bool back, bool front) const {
    const double a = k_scale * data_.R, b = a * k_tilt;
    const Pixel c = project({0, 0, z});
    std::string arcs;
    for (const bool is_back : {true, false}) {
      if (!(is_back ? back : front)) continue;
      arcs += format("<path d=\"M%.1f %.1fA%.1f %.1f 0 0 %d %.1f %.1f\" stroke=\"%s\"%s/>\n", c.x - a, c.y, a, b,
                     is_back ? 1 : 0, c.x + a, c.y, k_soft, is_back ? " stroke-dasharray=\"3 3\"" : "");
    }
    return arcs;
  }

  std::string wall(double top, double bottom) const {
    std::string lines;
    for (const double side : {-data_.R, data_.R}) {
      lines += segment(project({side, 0, top}), project({side, 0, bottom}), k_soft);
    }
    return lines;
  }

  std::string ball(const Motion& m) const {
    const Pixel c = project(centre(m));
    return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"url(#ball)\" stroke=\"%s\"%s/>\n", c.x, c.y,
                  k_scale * data_.r, k_blue, is_behind(m) ? " opacity=\"0.45\"" : "");
  }

  /// The force of the wall, at the contact.
  std::string force(const Motion& m) const {
    const SpaceVector contact = on_circle(data_.R, m);
    const double normal = k_metres_per_newton * m.reaction[0];
    const SpaceVector tip{contact[0] + normal * std::cos(m.chi), contact[1] + normal * std::sin(m.chi),
                          contact[2] + k_metres_per_newton * m.reaction[2]};
    const Pixel a = project(contact), b = project(tip);
    return format("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"1.8\" marker-end=\"url(#tip)\"%s/>\n",
                  a.x, a.y, b.x, b.y, k_red, is_behind(m) ? " opacity=\"0.5\"" : "");
  }

  std::string way(const std::vector<Motion>& motions, bool behind) const {
    std::string parts;
    std::vector<Pixel> part;
    for (const Motion& m : motions) {
      const bool is_ours = is_behind(m) == behind;
      // The first point on the other side closes a part, so that the two sides meet.
      if (is_ours || !part.empty()) part.push_back(project(centre(m)));
      if (!is_ours || &m == &motions.back()) {
        parts += polyline(part, k_blue, behind ? 1 : 1.6, behind ? "opacity=\"0.35\"" : "");
        part.clear();
      }
    }
    return parts;
  }

 private:
  static constexpr double k_middle = 150, k_zero = 66, k_scale = 108;  // pixels, pixels, pixels per metre
  static constexpr double k_tilt = 0.28, k_flat = 0.96;
  static constexpr double k_metres_per_newton = 0.045;
  const Data& data_;
};

/// One diagram over time.
struct Diagram {
  double top, bottom;        // pixels
  double least, most, step;  // of the values
  double duration;           // s

  static constexpr double k_left = 400, k_right = 930;

  Pixel at(double t, double value) const {
    return {k_left + (k_right - k_left) * t / duration, bottom - (bottom - top) * (value - least) / (most - least)};
  }

  std::string frame(const std::string& title, double shaded) const {
    const Pixel corner = at(shaded, least);
    std::string lines =
        format("<rect x=\"%g\" y=\"%g\" width=\"%.1f\" height=\"%g\" fill=\"#ddf4ff\" stroke=\"none\"/>\n", k_left, top,
               corner.x - k_left, bottom - top);
    for (double value = least; value <= most + step / 2; value += step) {
      lines += segment(at(0, value), at(duration, value), k_line);
      lines += text_at({k_left - 8, at(0, value).y + 4}, format("%g", value), k_soft, "end");
    }
    for (int t = 0; t <= static_cast<int>(duration); t += 2) {
      lines += text_at({at(t, least).x, bottom + 17}, format(t == 0 ? "%d s" : "%d", t), k_soft, "middle");
    }
    return lines + text_at({k_left, top - 10}, title, k_ink);
  }
};

using Value = double (*)(const Motion&);

std::string curve(const Diagram& diagram, const Run& run, const ClosedForm& exact, Value value, const char* colour) {
  std::vector<Pixel> points;
  for (std::size_t k = 0; k < run.samples.size(); k += 3) {
    points.push_back(diagram.at(run.samples[k].t, value(run.samples[k].motion)));
  }
  std::string lines = polyline(points, colour, 1.8);
  for (double t = 0.25; t < diagram.duration; t += 0.5) {
    const Pixel p = diagram.at(t, value(exact.at(t)));
    lines += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.6\" stroke=\"%s\" fill=\"white\"/>\n", p.x, p.y, colour);
  }
  return lines;
}

std::string level(const Diagram& diagram, double value, const std::string& words) {
  const Pixel a = diagram.at(0, value), b = diagram.at(diagram.duration, value);
  return format("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-dasharray=\"5 4\"/>\n", a.x, a.y, b.x, b.y,
                k_ink) +
         text_at({diagram.at(6, value).x, b.y - 5}, words, k_ink, "middle");
}

std::string cylinder(const Run& run, const ClosedForm& exact, double period) {
  constexpr int k_balls = 12;
  const Scene scene(exact);
  std::vector<Motion> first;
  for (const Sample& sample : run.samples) {
    if (sample.t <= period) first.push_back(sample.motion);
  }
  std::vector<Motion> shown;
  for (int k = 0; k < k_balls; ++k) {
    shown.push_back(first[static_cast<std::size_t>(k) * (first.size() - 1) / k_balls]);
  }
  const double top = 0.3, bottom = exact.lowest_height() - 0.25;
  std::string lines = scene.rim(top, true, true) + scene.rim(bottom, true, true) + scene.wall(top, bottom);
  for (const bool behind : {true, false}) {
    lines += scene.way(first, behind);
    for (const Motion& m : shown) {
      if (scene.is_behind(m) == behind) lines += scene.ball(m) + scene.force(m);
    }
  }
  return lines;
}

}  // namespace

std::string picture_of(const Run& run, const ClosedForm& exact) {
  const double period = 2 * k_pi / exact.frequency();
  const double duration = run.samples.back().t;
  const Diagram height{50, 215, -4, 1, 1, duration};
  const Diagram force{285, 450, -6, 10, 4, duration};

  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 490\" font-family=\"sans-serif\" font-size=\"13\" "
      "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
      "<title>A ball that rolls inside a cylinder: its way, and the force of the wall</title>\n"
      "<defs><radialGradient id=\"ball\" cx=\"0.35\" cy=\"0.3\"><stop stop-color=\"#ddf4ff\"/>"
      "<stop offset=\"1\" stop-color=\"#54aeff\"/></radialGradient>\n";
  svg += format(
      "<marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"6\" refY=\"4\" markerWidth=\"4\" markerHeight=\"4\" "
      "orient=\"auto\">"
      "<path d=\"M0 0L8 4L0 8z\" fill=\"%s\"/></marker></defs>\n",
      k_red);
  svg += "<rect width=\"960\" height=\"490\" rx=\"8\" fill=\"white\"/>\n<g stroke=\"none\">\n";
  svg += text_at({235, 445}, "way of the centre in", k_blue) +
         text_at({235, 461}, format("one swing, %.2f s", period), k_blue);
  svg += text_at({235, 66}, "force of the wall", k_red) + "</g>\n";
  svg += cylinder(run, exact, period);

  svg += height.frame("height of the centre [m]: it does not fall", period);
  svg += curve(
      height, run, exact, [](const Motion& m) { return m.z; }, k_blue);
  svg += force.frame("force of the wall on the ball [N]", period);
  svg += level(force, exact.data().m * exact.data().g, "weight");
  svg += curve(
      force, run, exact, [](const Motion& m) { return m.reaction[2]; }, k_red);
  svg += curve(
      force, run, exact, [](const Motion& m) { return m.reaction[0]; }, k_green);
  svg += text_at({force.at(0.08, 9.1).x, force.at(0, 9.1).y}, "along the axis, upwards", k_red);
  svg += text_at({force.at(0.08, -5.4).x, force.at(0, -5.4).y}, "normal, positive outwards", k_green);
  svg += text_at({Diagram::k_right, 482}, "lines: generated code; circles: closed form", k_soft, "end");
  return svg + "</svg>\n";
}

}  // namespace sphere
