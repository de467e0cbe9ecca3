#include "sim/scene/read_ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/scene/read_numbers.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
namespace spec = gaussgen::spec;
using gaussgen::support::Span;

constexpr std::array<Section, 3> k_sections{Section::parameters, Section::initial, Section::inputs};

/// How a quantity may be varied, by the key that says so.
const std::vector<std::string>& ways() {
  static const std::vector<std::string> k_ways{"uniform", "normal", "log_uniform", "sweep", "values"};
  return k_ways;
}

std::vector<double> spread(double from, double to, long count, bool is_logarithmic) {
  std::vector<double> points;
  const double first = is_logarithmic ? std::log(from) : from, last = is_logarithmic ? std::log(to) : to;
  for (long k = 0; k < count; ++k) {
    const double share = count == 1 ? 0 : static_cast<double>(k) / static_cast<double>(count - 1);
    const double at = first + (last - first) * share;
    points.push_back(is_logarithmic ? std::exp(at) : at);
  }
  // Ends are what the file says, to the last bit.
  points.front() = from;
  if (count > 1) points.back() = to;
  return points;
}

class EnsembleReader {
 public:
  EnsembleReader(const spec::Node& node, const spec::Node& scene, model::Reading& reading)
      : node_(node), scene_(scene), reading_(reading) {}

  Ensemble read() {
    result_.span = node_.span;
    for (const spec::Entry& entry : scene_.entries) {
      if (entry.key.text == "ensemble") result_.span = entry.key.span;
    }
    if (!model::expect_map(node_, result_.span, "'ensemble'", reading_)) return {};
    model::check_keys(node_, "the ensemble", {"trajectories", "seed", "parameters", "initial", "inputs", "record"},
                      reading_);
    for (const Section section : k_sections) {
      model::read_section(node_, name_of(section), reading_,
                          [&](const spec::Entry& entry) { read_varied(section, entry); });
    }
    if (const spec::Node* const seed = spec::find(node_, "seed")) {
      if (const auto value = numbers_.whole(*seed, seed->span, 0, k_largest_seed, 1))
        result_.seed = static_cast<std::uint64_t>(*value);
    }
    read_record();
    read_count();
    return std::move(result_);
  }

 private:
  void error(const std::string& id, Span span, const std::string& message, const std::string& hint = "") {
    reading_.diagnostics.error(id, span, message, hint);
  }

  void read_record() {
    const spec::Node* const record = spec::find(node_, "record");
    if (record == nullptr || !model::expect_scalar(*record, node_.span, "'record'", reading_)) return;
    const std::string& word = record->scalar.text;
    result_.records_samples = word == "samples";
    if (word != "samples" && word != "end")
      error(code::k_unknown_word, record->span, fmt::format("there is no record '{}'", word),
            "it is 'end', a row for each trajectory, or 'samples', a row for each sample");
  }

  void read_count() {
    const spec::Node* const count = spec::find(node_, "trajectories");
    if (count != nullptr) {
      const auto value = numbers_.whole(*count, count->span, 1, k_most_trajectories, 1000);
      if (!value) return;
      result_.trajectories = *value;
    }
    if (has_mistakes_) return;
    const auto& varied = result_.varied;
    const bool draws =
        std::any_of(varied.begin(), varied.end(), [](const Varied& one) { return one.distribution.is_random(); });
    if (varied.empty()) {
      error(code::k_missing_key, result_.span, "the ensemble varies nothing",
            "add 'parameters', 'initial' or 'inputs', such as parameters: {m: {uniform: [1, 2]}}");
    } else if (draws && count == nullptr) {
      error(code::k_missing_key, result_.span, "the ensemble does not say how many values are drawn",
            "add 'trajectories', such as trajectories: 1000");
    } else if (!draws && count != nullptr) {
      error(code::k_conflicting_keys, count->span,
            "nothing is drawn, so sweeps alone say how many trajectories there are", "leave 'trajectories' out");
    }
    refuse_too_many(count == nullptr ? result_.span : count->span);
  }

  void refuse_too_many(Span span) {
    const double all = points_of(result_) * static_cast<double>(result_.trajectories);
    if (all <= static_cast<double>(k_most_trajectories)) return;
    error(code::k_out_of_range, span,
          fmt::format("these are {:.6g} trajectories; there may be {}", all, k_most_trajectories),
          "take fewer points of sweeps, or fewer draws");
  }

  void read_varied(Section section, const spec::Entry& entry) {
    refuse_second(section, entry);
    const std::size_t before = reading_.diagnostics.all().size();
    Varied varied{section, entry.key.text, {}, entry.key.span};
    if (model::expect_map(entry.value, entry.key.span, fmt::format("'{}'", varied.name), reading_))
      read_distribution(entry, varied.distribution);
    has_mistakes_ = has_mistakes_ || reading_.diagnostics.all().size() > before;
    result_.varied.push_back(std::move(varied));
  }

  /// The scene cannot give a value to what varies.
  void refuse_second(Section section, const spec::Entry& entry) {
    const spec::Node* const given = spec::find(scene_, name_of(section));
    if (given == nullptr || given->kind != spec::NodeKind::map || spec::find(*given, entry.key.text) == nullptr) return;
    error(code::k_conflicting_keys, entry.key.span,
          fmt::format("'{}' has a value under '{}' of the scene", entry.key.text, name_of(section)),
          "leave one of the two out");
  }

  void read_distribution(const spec::Entry& entry, Distribution& to) {
    model::check_keys(entry.value, fmt::format("'{}'", entry.key.text), ways(), reading_);
    const auto& given = entry.value.entries;
    if (given.size() > 1)
      return error(code::k_conflicting_keys, given[1].key.span,
                   fmt::format("'{}' and '{}' exclude each other", given[0].key.text, given[1].key.text),
                   "leave one of the two out");
    if (given.empty())
      return error(code::k_missing_key, entry.key.span, fmt::format("'{}' does not say how it varies", entry.key.text),
                   "there are " + gaussgen::support::joined(ways()));
    const spec::Entry& how = given.front();
    if (how.key.text == "uniform") to = between(Distribution::Kind::uniform, how);
    if (how.key.text == "normal") to = normal(how);
    if (how.key.text == "log_uniform") to = between(Distribution::Kind::log_uniform, how);
    if (how.key.text == "sweep") to.points = sweep(how);
    if (how.key.text == "values") to.points = values(how);
  }

  std::optional<std::pair<double, double>> two(const spec::Entry& how, const char* hint) {
    if (!model::expect_list(how.value, how.key.span, fmt::format("'{}'", how.key.text), reading_, hint) ||
        !model::expect_length(how.value, 2, fmt::format("'{}'", how.key.text), reading_, hint))
      return std::nullopt;
    const auto a = numbers_.real(how.value.items[0], how.value.span);
    const auto b = numbers_.real(how.value.items[1], how.value.span);
    if (!a || !b) return std::nullopt;
    return std::pair(*a, *b);
  }

  Distribution between(Distribution::Kind kind, const spec::Entry& how) {
    const auto ends = two(how, "it is a list of two numbers, the smaller one first");
    if (!ends) return {};
    const auto [a, b] = *ends;
    const bool is_logarithmic = kind == Distribution::Kind::log_uniform;
    const auto refuse = [&](const spec::Node& at, const char* why) {
      error(code::k_out_of_range, at.span, why,
            is_logarithmic ? "such as log_uniform: [0.1, 10]" : "such as uniform: [1, 2]");
      return Distribution{};
    };
    if (!(a < b)) return refuse(how.value, "the first number must be below the second one");
    if (is_logarithmic && a <= 0) return refuse(how.value.items[0], "only numbers above 0 have a logarithm");
    if (!std::isfinite(b - a)) return refuse(how.value, "these are too far from each other");
    return {kind, a, b, {}};
  }

  Distribution normal(const spec::Entry& how) {
    const auto both = two(how, "it is a list of two numbers, the mean and the standard deviation");
    if (!both) return {};
    if (!(both->second > 0))
      error(code::k_out_of_range, how.value.items[1].span, "a standard deviation is above 0",
            "such as normal: [1, 0.1]");
    return {Distribution::Kind::normal, both->first, both->second, {}};
  }

  std::vector<double> sweep(const spec::Entry& how) {
    const spec::Node& map = how.value;
    if (!model::expect_map(map, how.key.span, "'sweep'", reading_)) return {};
    model::check_keys(map, "the sweep", {"from", "to", "count", "spacing"}, reading_);
    const auto from = end_of_sweep(how, "from"), to = end_of_sweep(how, "to");
    const spec::Node* const node = model::required(map, "count", how.key.span, "the sweep", reading_);
    std::optional<long> count;
    if (node != nullptr) count = numbers_.whole(*node, node->span, 2, k_most_trajectories, 11);
    const std::string spacing = model::text_field(map, "spacing", reading_);
    const bool is_logarithmic = spacing == "logarithmic";
    if (!spacing.empty() && spacing != "linear" && !is_logarithmic)
      error(code::k_unknown_word, spec::find(map, "spacing")->span, fmt::format("there is no spacing '{}'", spacing),
            "it is 'linear' or 'logarithmic'");
    if (!from || !to || !count) return {};
    if (is_logarithmic && !(*from > 0 && *to > 0)) {
      error(code::k_out_of_range, map.span, "only numbers above 0 have a logarithm",
            "such as sweep: {from: 0.1, to: 10, count: 11, spacing: logarithmic}");
    } else if (*from == *to || !std::isfinite(*to - *from)) {
      error(code::k_out_of_range, map.span,
            *from == *to ? "a sweep has two different ends" : "these are too far from each other",
            "such as sweep: {from: 1, to: 2, count: 11}");
    } else {
      return spread(*from, *to, *count, is_logarithmic);
    }
    return {};
  }

  std::optional<double> end_of_sweep(const spec::Entry& how, const char* key) {
    const spec::Node* const node = model::required(how.value, key, how.key.span, "the sweep", reading_);
    return node == nullptr ? std::nullopt : numbers_.real(*node, how.key.span);
  }

  std::vector<double> values(const spec::Entry& how) {
    std::vector<double> all;
    if (!model::expect_list(how.value, how.key.span, "'values'", reading_)) return all;
    for (const spec::Node& item : how.value.items) {
      if (const auto value = numbers_.real(item, how.value.span)) all.push_back(*value);
    }
    if (how.value.items.empty())
      error(code::k_wrong_count, how.value.span, "'values' is a list of at least one number");
    return all;
  }

  const spec::Node& node_;
  const spec::Node& scene_;
  model::Reading& reading_;
  NumberReader numbers_{reading_};
  Ensemble result_;
  bool has_mistakes_ = false;  ///< in what is varied, so that nothing is said of how many there are
};

}  // namespace

const char* name_of(Section section) {
  return section == Section::parameters ? "parameters" : section == Section::initial ? "initial" : "inputs";
}

double points_of(const Ensemble& ensemble) {
  double all = 1;
  for (const Varied& one : ensemble.varied) {
    if (!one.distribution.is_random()) all *= static_cast<double>(one.distribution.points.size());
  }
  return all;
}

Ensemble read_ensemble(const spec::Node& node, const spec::Node& scene, model::Reading& reading) {
  return EnsembleReader(node, scene, reading).read();
}

}  // namespace gausssim
