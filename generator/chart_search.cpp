#include "chart_search.hpp"

#include <algorithm>
#include <cmath>

#include "chart_map.hpp"
#include "ir/graph.hpp"
#include "nearest_position.hpp"
#include "position_equations.hpp"
#include "repeated_numbers.hpp"
#include "spans.hpp"

namespace gaussgen {

namespace {

using Configuration = std::vector<double>;

constexpr double k_pi = 3.14159265358979323846;
constexpr double k_singular = 1e-10;    ///< of the least singular value where nothing is singled out
constexpr double k_usual = 1e-6;        ///< of the largest: below, nothing can be told from rounding
constexpr double k_same = 1e-6;         ///< of a turn or a size: places closer than that are one
constexpr double k_displacement = 0.8;  ///< of coordinates of their size, and of angles
constexpr int k_states = 3;
constexpr int k_samples = 12;
constexpr int k_golden_steps = 70;
constexpr std::size_t k_most_work = 1'000'000;    ///< nodes evaluated, some 50 ms
constexpr std::size_t k_decomposition = 10;       ///< nodes, of one that has n² entries
constexpr std::size_t k_steps_to_positions = 15;  ///< of Newton's method, most times
constexpr std::size_t k_most_of_pairs = 6;        ///< coordinates

class Search {
 public:
  explicit Search(Mechanics& mechanics)
      : mechanics_(mechanics),
        map_(mechanics),
        equations_(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), 0),
        work_(k_most_work) {}

  std::vector<SingularPlace> run() {
    if (!prepare()) return {};
    const std::size_t n = mechanics_.symbols.plain_count();
    if (!mechanics_.model.speeds.empty()) search_rates();
    for (std::size_t c = 0; c < n; ++c) {
      for (const double value : special_values(c)) take_if_singular({{c, value}}, false);
    }
    if (n <= k_most_of_pairs) search_pairs(n);
    for (std::size_t c = 0; c < n; ++c) {
      if (!is_pinned(c)) search_along(c);
    }
    return std::move(found_);
  }

 private:
  bool is_angle(std::size_t c) const {
    const std::string& unit = mechanics_.symbols.configuration[kinematics::ConfigurationIndex{c}].unit;
    return unit == "rad" || unit.empty();
  }

  std::vector<double> special_values(std::size_t c) const {
    return is_angle(c) ? std::vector<double>{0, k_pi, k_pi / 2, -k_pi / 2} : std::vector<double>{0};
  }

  double size(std::size_t c) const { return is_angle(c) || start_[c] == 0 ? 1 : std::abs(start_[c]); }

  /// Usual states, and how large the least singular value is at them.
  bool prepare() {
    if (!equations_.start()) return false;
    start_ = equations_.position();
    spans_ = spans_at(mechanics_, equations_);
    Configuration other = start_;
    for (int k = 0; k < 4 * k_states && states_.size() < k_states; ++k) {
      for (std::size_t c = 0; c < other.size(); ++c) other[c] = start_[c] + k_displacement * size(c) * number_();
      if (auto state = on_positions(other, {})) add_state(std::move(*state));
    }
    if (states_.size() < 2) return false;
    usual_ = least(states_[0]).value_or(0);
    for (const Configuration& state : states_) usual_ = std::min(usual_, least(state).value_or(0));
    return usual_ > k_usual;
  }

  void add_state(Configuration state) {
    const auto map = map_(state);
    if (!map) return;
    const Eigen::VectorXd columns = map->topRows(map_.inertial_rows()).colwise().norm();
    if (columns.minCoeff() <= 0) return;
    if (states_.empty()) {
      columns_ = columns;
      Eigen::MatrixXd scaled = *map * columns_.cwiseInverse().asDiagonal();
      rows_ = scaled.rowwise().norm();
    }
    states_.push_back(std::move(state));
  }

  /// Nodes, and what a decomposition takes beside them; false once all is spent.
  bool spend(std::size_t times) {
    const std::size_t n = mechanics_.dynamics.n();
    const std::size_t price = times * (map_.nodes() + k_decomposition * n * n);
    work_ = price < work_ ? work_ - price : 0;
    return work_ > 0;
  }

  /// The nearest configuration on the equations of positions, with pinned coordinates where they are.
  std::optional<Configuration> on_positions(const Configuration& q, const std::vector<SingularPlace::Pin>& pins) {
    std::vector<bool> movable(mechanics_.dynamics.n(), true);
    for (const auto& pin : pins) movable[pin.coordinate] = false;
    equations_.set(q, std::move(movable));
    const auto here = equations_.linearised();
    if (!here) return std::nullopt;
    if (here->f.empty()) return equations_.position();
    if (!spend(k_steps_to_positions) || !nearest_solution(equations_, spans_)) return std::nullopt;
    const Configuration& solved = equations_.position();
    for (const auto& pin : pins) {
      if (std::abs(solved[pin.coordinate] - q[pin.coordinate]) > k_singular * size(pin.coordinate)) return std::nullopt;
    }
    return solved;
  }

  /// Columns in units of usual speeds, rows of constraints in those of usual gradients.
  std::optional<Eigen::JacobiSVD<Eigen::MatrixXd>> decomposed(const Configuration& q, unsigned vectors = 0) {
    if (!spend(1)) return std::nullopt;
    auto map = map_(q);
    if (!map || map->rows() < map->cols()) return std::nullopt;
    *map = *map * columns_.cwiseInverse().asDiagonal();
    for (Eigen::Index i = map_.inertial_rows(); i < map->rows(); ++i) {
      if (rows_[i] > 0) map->row(i) /= rows_[i];
    }
    return Eigen::JacobiSVD<Eigen::MatrixXd>(*map, vectors);
  }

  std::optional<double> least(const Configuration& q) {
    const auto svd = decomposed(q);
    if (!svd) return std::nullopt;
    const auto& values = svd->singularValues();
    return values[values.size() - 1];
  }

  std::optional<Configuration> pinned(const Configuration& state, const std::vector<SingularPlace::Pin>& pins) {
    Configuration q = state;
    for (const auto& pin : pins) q[pin.coordinate] = pin.value;
    return on_positions(q, pins);
  }

  /// At the pins, and wherever else the others are.
  bool is_singular(const std::vector<SingularPlace::Pin>& pins, std::size_t states) {
    for (std::size_t k = 0; k < states; ++k) {
      const auto q = pinned(states_[k], pins);
      const auto value = q ? least(*q) : std::nullopt;
      if (!value || *value > k_singular * usual_) return false;
    }
    return true;
  }

  bool take_if_singular(const std::vector<SingularPlace::Pin>& pins, bool is_instance) {
    if (!is_singular(pins, is_instance ? 1 : states_.size())) return false;
    found_.push_back({pins, is_instance, null_speeds(*pinned(states_[0], pins)), false});
    return true;
  }

  std::vector<std::size_t> null_speeds(const Configuration& q) {
    const auto svd = decomposed(q, Eigen::ComputeThinV);
    std::vector<std::size_t> speeds;
    if (!svd) return speeds;
    const Eigen::VectorXd null = svd->matrixV().rightCols(1);
    for (Eigen::Index i = 0; i < null.size(); ++i) {
      if (std::abs(null[i]) > k_same) speeds.push_back(static_cast<std::size_t>(i));
    }
    return speeds;
  }

  bool is_pinned(std::size_t c) const {
    return std::any_of(found_.begin(), found_.end(), [c](const SingularPlace& place) {
      return std::any_of(place.pins.begin(), place.pins.end(), [c](const auto& pin) { return pin.coordinate == c; });
    });
  }

  // Two coordinates are both special, as those of parabolas at their common focus; a place of one alone says more.
  void search_pairs(std::size_t n) {
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t d = c + 1; d < n; ++d) {
        if (is_pinned(c) || is_pinned(d)) continue;
        for (const double first : special_values(c)) {
          for (const double second : special_values(d)) take_pair({{c, first}, {d, second}});
        }
      }
    }
  }

  // Half a turn of one beside the other may be a relation between both, which the search along one finds.
  void take_pair(const std::vector<SingularPlace::Pin>& pins) {
    if (!is_singular(pins, states_.size())) return;
    const double away = 0.37;
    for (const double sign : {1.0, -1.0}) {
      auto both = pins;
      both[0].value += away * size(both[0].coordinate);
      both[1].value += sign * away * size(both[1].coordinate);
      if (is_singular(both, 1)) return;
    }
    take_if_singular(pins, false);
  }

  /// Least singular value with one coordinate there.
  double along(std::size_t state, std::size_t c, double value) {
    const auto q = pinned(states_[state], {{c, value}});
    return (q ? least(*q) : std::nullopt).value_or(usual_);
  }

  void search_along(std::size_t c) {
    const double reach = is_angle(c) ? k_pi : 3 * size(c);
    std::vector<double> at, values;
    for (int k = 0; k <= k_samples + 1; ++k) {
      at.push_back(-reach + 2 * reach * (k - 0.317) / k_samples);
      values.push_back(along(0, c, at.back()));
      if (work_ == 0) return;
    }
    for (std::size_t k = 1; k + 1 < at.size(); ++k) {
      if (values[k] > values[k - 1] || values[k] > values[k + 1] || values[k] >= usual_) continue;
      take_minimum(c, refined(0, c, at[k - 1], at[k + 1]));
    }
  }

  double refined(std::size_t state, std::size_t c, double low, double high) {
    const double part = (std::sqrt(5.0) - 1) / 2;
    double left = high - part * (high - low), right = low + part * (high - low);
    double at_left = along(state, c, left), at_right = along(state, c, right);
    for (int i = 0; i < k_golden_steps && work_ > 0; ++i) {
      if (at_left < at_right) {
        high = right;
        right = left;
        at_right = at_left;
        at_left = along(state, c, left = high - part * (high - low));
      } else {
        low = left;
        left = right;
        at_left = at_right;
        at_right = along(state, c, right = low + part * (high - low));
      }
    }
    return at_left < at_right ? left : right;
  }

  void take_minimum(std::size_t c, double value) {
    if (along(0, c, value) > k_singular * usual_) return;
    if (take_if_singular({{c, value}}, false)) return;
    std::vector<SingularPlace::Pin> pins;
    const auto here = pinned(states_[0], {{c, value}});
    for (std::size_t d = 0; here && d < mechanics_.symbols.plain_count(); ++d) {
      if (d == c || matters(*here, d)) pins.push_back({d, (*here)[d]});
    }
    const bool is_known = std::any_of(found_.begin(), found_.end(), [&](const SingularPlace& place) {
      return place.is_instance && place.pins.size() == pins.size() &&
             std::equal(pins.begin(), pins.end(), place.pins.begin(),
                        [](const auto& a, const auto& b) { return a.coordinate == b.coordinate; });
    });
    if (here && !is_known) found_.push_back({pins, true, null_speeds(*here), false});
  }

  bool matters(const Configuration& singular, std::size_t d) {
    Configuration q = singular;
    q[d] += 0.1 * size(d);
    return least(q).value_or(usual_) > std::sqrt(k_singular) * usual_;
  }

  // The largest singular value of ∂q̇/∂u grows without bounds, as one over the distance or faster.
  void search_rates() {
    const std::size_t n = mechanics_.symbols.plain_count();
    for (std::size_t c = 0; c < n; ++c) {
      for (const double value : special_values(c)) {
        const bool has_pole = std::all_of(states_.begin(), states_.end(), [&](const Configuration& state) {
          const double far = gain(state, c, value, 1e-4), near = gain(state, c, value, 1e-6);
          return near > 50 * far && near > 1e3 * gain(state, c, state[c], 0);
        });
        if (has_pole) found_.push_back({{{c, value}}, false, {}, true});
      }
    }
  }

  double gain(const Configuration& state, std::size_t c, double value, double off) {
    const auto q = pinned(state, {{c, value + off * size(c)}});
    const auto rates = q ? map_.rates(*q) : std::nullopt;
    return rates ? rates->norm() : 0;
  }

  Mechanics& mechanics_;
  ChartMap map_;
  PositionEquations equations_;
  std::vector<double> spans_;
  std::size_t work_;
  RepeatedNumbers number_;
  Configuration start_;
  std::vector<Configuration> states_;
  Eigen::VectorXd columns_, rows_;
  double usual_ = 0;
  std::vector<SingularPlace> found_;
};

}  // namespace

std::vector<SingularPlace> singular_places(Mechanics& mechanics) {
  const std::size_t n = mechanics.dynamics.n();
  if (n == 0 || n > k_most_charted_speeds) return {};
  try {
    return Search(mechanics).run();
  } catch (const ir::TooManyNodes&) {
    return {};  // the equations themselves are smaller
  }
}

}  // namespace gaussgen
