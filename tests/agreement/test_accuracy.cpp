// What passes do to rounding: errors of accelerations in double against a hundred digits, with and without each pass.

#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "model_files.hpp"
#include "models.hpp"
#include "passes/optimise.hpp"

namespace {

using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;
using gaussgen::ir::NodeId;
using gaussgen::passes::Request;

constexpr int k_digits = 100;
constexpr int k_states = 1000;

struct Errors {
  double median = 0;
  double high = 0;  ///< 99 of 100 are below
};

Errors summary(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors[errors.size() * 99 / 100]};
}

template <class T>
std::vector<T> values(Evaluator<T>& evaluator, const std::vector<NodeId>& nodes) {
  std::vector<T> result;
  for (const NodeId node : nodes) {
    const auto value = evaluator(node);
    if (!value) return {};
    result.push_back(*value);
  }
  return result;
}

/// Relative to the largest acceleration.
double error(const std::vector<double>& found, const std::vector<cl_F>& exact) {
  const Arithmetic<cl_F> arithmetic(k_digits);
  cl_F size = arithmetic.number(gaussgen::ir::Rational(0)), worst = size;
  for (std::size_t i = 0; i < found.size(); ++i) {
    size = std::max(size, cl_F(cln::abs(exact[i])));
    worst = std::max(worst, cl_F(cln::abs(arithmetic.number(found[i]) - exact[i])));
  }
  return cln::zerop(size) ? 0 : cln::double_approx(worst / size);
}

using Samples =
    std::vector<std::vector<double>>;  ///< errors of the plain code, and after each pass upon those before it

gaussgen::MechanicsOptions folded() {
  gaussgen::MechanicsOptions options;
  options.fold = true;
  return options;
}

class Trial {
 public:
  /// By the order that is taken, or by another one.
  explicit Trial(const gaussgen::model::Model& model, std::optional<std::size_t> order = {})
      : mechanics_(model, folded()) {
    Request plain;
    for (const auto acceleration : mechanics_.solution.accelerations) plain.outputs.push_back(acceleration.id());
    requests_.push_back(plain);
    requests_.push_back(gaussgen::passes::apply_cancellation(mechanics_.graph, plain));
    for (const gaussgen::passes::Pass& pass : gaussgen::passes::identities()) step(pass);
    order_ = order ? *order : order_for(requests_.back());
    for (const gaussgen::passes::Pass& pass : gaussgen::passes::orders()[order_]) step(pass);
    requests_.push_back(gaussgen::passes::apply_rotations(mechanics_.graph, requests_.back()));
  }

  std::size_t order() const { return order_; }

  void add_to(Samples& samples, unsigned seed) {
    samples.resize(requests_.size());
    Evaluator<cl_F> wide(mechanics_.graph, Arithmetic<cl_F>(k_digits));
    Evaluator<double> narrow(mechanics_.graph, Arithmetic<double>());
    agreement::RandomStates states(mechanics_.symbols, seed);
    for (int s = 0; s < k_states; ++s) {
      const agreement::State state = states.next();
      agreement::bind(mechanics_.symbols, state, wide);
      agreement::bind(mechanics_.symbols, state, narrow);
      for (const auto input : mechanics_.symbols.inputs) {
        const double value = states.uniform(-1, 1);
        wide.bind(input, agreement::as(wide.arithmetic(), value));
        narrow.bind(input, value);
      }
      const std::vector<cl_F> exact = values(wide, requests_[0].outputs);
      for (std::size_t r = 0; r < requests_.size(); ++r) {
        const std::vector<double> found = values(narrow, requests_[r].outputs);
        if (!exact.empty() && !found.empty()) samples[r].push_back(error(found, exact));
      }
    }
  }

 private:
  void step(const gaussgen::passes::Pass& pass) {
    requests_.push_back(gaussgen::passes::apply(mechanics_.graph, requests_.back(), {pass}));
  }

  std::size_t order_for(const Request& request) {
    const Request best = gaussgen::passes::apply_best_order(mechanics_.graph, request);
    for (std::size_t i = 0; i < gaussgen::passes::orders().size(); ++i) {
      const auto& passes = gaussgen::passes::orders()[i];
      if (gaussgen::passes::apply(mechanics_.graph, request, passes).outputs == best.outputs) return i;
    }
    throw std::logic_error("no order leads to the best one");
  }

  Mechanics mechanics_;
  std::vector<Request> requests_;
  std::size_t order_ = 0;
};

/// The same mechanism in other sizes: numbers some per cent off.
gaussgen::model::Model varied(const gaussgen::model::Model& model, unsigned seed) {
  gaussgen::model::Model other = model;
  std::mt19937 source(seed);
  std::uniform_int_distribution<int> per_cent(-9, 9);
  for (auto& parameter : other.parameters) {
    const bool is_number = !parameter.is_formula && parameter.value.kind == gaussgen::model::AstKind::number;
    if (!is_number) continue;
    const gaussgen::ir::Rational factor = gaussgen::ir::Rational(100 + per_cent(source)) / 100;
    parameter.value = gaussgen::model::number(parameter.value.number * factor, parameter.value.span);
  }
  return other;
}

/// What passes are allowed to add to an error.
constexpr double k_bar = 1.10;

/// Errors after all passes over those of the plain code; after each of them is what is printed.
Errors ratio_of(const std::string& file, const Samples& samples) {
  const Errors plain = summary(samples[0]);
  std::printf("%-32s %6zu", file.c_str(), samples[0].size());
  Errors ratio;
  for (const std::vector<double>& list : samples) {
    const Errors e = summary(list);
    ratio = {e.median / plain.median, e.high / plain.high};
    std::printf(" | %5.3f %5.3f", ratio.median, ratio.high);
  }
  std::printf(" | %8.2g %8.2g\n", plain.median, plain.high);
  return ratio;
}

bool is_within_bars(const Errors& ratio) { return ratio.median <= k_bar && ratio.high <= k_bar; }

}  // namespace

// One set of numbers is rounded as luck will have it, and ten of a thousand states are above the 99th percentile: where that
// is not within the bars, the same is asked of sixteen sizes of the mechanism, at a thousand states each.
TEST_CASE("passes raise errors of accelerations by a tenth at most, in the median and at the 99th percentile") {
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    const gaussgen::model::Model model = agreement::load(file);
    Samples samples;
    Trial trial(model);
    trial.add_to(samples, 7);
    if (is_within_bars(ratio_of(file, samples))) continue;
    for (unsigned seed = 1; seed < 16; ++seed) Trial(varied(model, seed), trial.order()).add_to(samples, 7 + seed);
    const Errors ratio = ratio_of(file, samples);
    CHECK(ratio.median <= k_bar);
    CHECK(ratio.high <= k_bar);
  }
}
