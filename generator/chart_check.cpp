#include "chart_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "chart_search.hpp"
#include "model/ast.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

namespace {

constexpr double k_quarter = 1.57079632679489661923;

/// "0", "pi", "-pi/2", or a number.
std::string value_of(double value) {
  const double quarters = value / k_quarter;
  if (std::abs(quarters - std::round(quarters)) > 1e-9) return fmt::format("{:.4g}", value);
  switch (static_cast<int>(std::round(quarters))) {
    case 0: return "0";
    case 1: return "pi/2";
    case -1: return "-pi/2";
    case 2: return "pi";
    case -2: return "-pi";
    default: return fmt::format("{:.4g}", value);
  }
}

bool mentions(const model::Ast& ast, const std::string& name) {
  return (ast.kind == model::AstKind::symbol && ast.name == name) ||
         std::any_of(ast.children.begin(), ast.children.end(),
                     [&](const model::Ast& child) { return mentions(child, name); });
}

std::string with_and(const std::vector<std::string>& words) {
  if (words.size() < 2) return support::joined(words);
  return support::joined({words.begin(), words.end() - 1}) + " and " + words.back();
}

class ChartCheck {
 public:
  ChartCheck(Mechanics& mechanics, support::Diagnostics& diagnostics)
      : mechanics_(mechanics), diagnostics_(diagnostics) {}

  void run() {
    const std::vector<SingularPlace> places = singular_places(mechanics_);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto is_like = [&](const SingularPlace& other) { return is_along(other, places[i]); };
      if (std::any_of(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), is_like)) continue;
      std::vector<SingularPlace> like;
      std::copy_if(places.begin() + static_cast<std::ptrdiff_t>(i), places.end(), std::back_inserter(like), is_like);
      report(like);
    }
  }

 private:
  /// Other values of the same coordinates.
  static bool is_along(const SingularPlace& a, const SingularPlace& b) {
    return a.is_instance == b.is_instance && a.is_of_speeds == b.is_of_speeds &&
           std::equal(a.pins.begin(), a.pins.end(), b.pins.begin(), b.pins.end(),
                      [](const auto& x, const auto& y) { return x.coordinate == y.coordinate; });
  }

  const std::string& name(std::size_t coordinate) const {
    return mechanics_.symbols.configuration[kinematics::ConfigurationIndex{coordinate}].name;
  }

  std::string place(const std::vector<SingularPlace>& like) const {
    if (like[0].pins.size() == 1) {
      std::vector<std::string> values;
      for (const SingularPlace& one : like) values.push_back(value_of(one.pins[0].value));
      return fmt::format("{} = {}", name(like[0].pins[0].coordinate), with_and(values));
    }
    std::vector<std::string> values;
    for (const auto& pin : like[0].pins)
      values.push_back(fmt::format("{} = {}", name(pin.coordinate), value_of(pin.value)));
    return with_and(values);
  }

  std::vector<std::string> labels(const SingularPlace& place) const {
    std::vector<std::string> result;
    for (const std::size_t speed : place.speeds) result.push_back("'" + mechanics_.dynamics.labels[speed] + "'");
    return result;
  }

  /// Whether the angle between some axes contains the coordinate.
  bool turns_something(const std::string& coordinate) const {
    const auto has = [&](const model::Turn& turn) { return mentions(turn.angle, coordinate); };
    return std::any_of(mechanics_.model.frames.begin(), mechanics_.model.frames.end(), [&](const model::Frame& frame) {
      const auto* turns = std::get_if<model::Turns>(&frame.attitude);
      return turns != nullptr && std::any_of(turns->begin(), turns->end(), has);
    });
  }

  std::string alternative(const SingularPlace& place) const {
    if (place.is_of_speeds) return "declare speeds that determine the rates everywhere, or stay away from there";
    const bool is_attitude = std::all_of(place.pins.begin(), place.pins.end(),
                                         [&](const auto& pin) { return turns_something(name(pin.coordinate)); });
    return is_attitude
               ? "a quaternion under 'orientations', or a joint of type 'spherical' or 'free', has no such place"
               : "Cartesian coordinates have no such place; what is given between them becomes a constraint";
  }

  void report(const std::vector<SingularPlace>& like) {
    const SingularPlace& first = like[0];
    const support::Span span = span_of_speed(mechanics_.model, name(first.pins[0].coordinate));
    if (!reported_.insert(span.begin).second) return;  // a copy of the same entry
    const std::vector<std::string> idle = labels(first);
    const std::string cause = first.is_of_speeds ? "the speeds do not determine the rates of the coordinates"
                              : idle.size() == 1 ? fmt::format("{} moves nothing", idle[0])
                                                 : fmt::format("{} do not move apart from each other", with_and(idle));
    diagnostics_.warning(support::code::k_singular_chart, span,
                         fmt::format("there are no {} at {}{}: {}", first.is_of_speeds ? "rates" : "accelerations",
                                     place(like), first.is_instance ? ", for instance" : "", cause),
                         alternative(first));
  }

  Mechanics& mechanics_;
  support::Diagnostics& diagnostics_;
  std::set<std::uint32_t> reported_;
};

}  // namespace

void check_chart(Mechanics& mechanics, support::Diagnostics& diagnostics) {
  const auto& all = diagnostics.all();
  const bool is_said = std::any_of(all.begin(), all.end(), [](const support::Diagnostic& finding) {
    return finding.code == support::code::k_singular_start.id;
  });
  if (!is_said) ChartCheck(mechanics, diagnostics).run();
}

}  // namespace gaussgen
