// What passes do to rounding: errors of accelerations in double against a hundred digits, with and without each pass.

#include <algorithm>
#include <cstdio>

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

class Trial {
 public:
  explicit Trial(const std::string& file) : model_(agreement::load(file)), mechanics_(model_, options()) {
    for (const auto acceleration : mechanics_.solution.accelerations) plain_.outputs.push_back(acceleration.id());
    requests_.push_back(plain_);
    for (const auto* list : {&gaussgen::passes::identities(), &gaussgen::passes::passes()}) {
      for (const gaussgen::passes::Pass& pass : *list) requests_.push_back(pass.run(mechanics_.graph, plain_));
    }
    const Request simple = gaussgen::passes::optimise(mechanics_.graph, plain_, gaussgen::passes::identities());
    requests_.push_back(gaussgen::passes::optimise(mechanics_.graph, simple, gaussgen::passes::passes()));
  }

  /// Of the plain code, of it after each pass, and after all.
  std::vector<Errors> run() {
    Evaluator<cl_F> wide(mechanics_.graph, Arithmetic<cl_F>(k_digits));
    Evaluator<double> narrow(mechanics_.graph, Arithmetic<double>());
    agreement::RandomStates states(mechanics_.symbols, 7);
    std::vector<std::vector<double>> errors(requests_.size());
    for (int s = 0; s < k_states; ++s) {
      const agreement::State state = states.next();
      agreement::bind(mechanics_.symbols, state, wide);
      agreement::bind(mechanics_.symbols, state, narrow);
      for (const auto input : mechanics_.symbols.inputs) {
        const double value = states.uniform(-1, 1);
        wide.bind(input, agreement::as(wide.arithmetic(), value));
        narrow.bind(input, value);
      }
      const std::vector<cl_F> exact = values(wide, plain_.outputs);
      for (std::size_t r = 0; r < requests_.size(); ++r) {
        const std::vector<double> found = values(narrow, requests_[r].outputs);
        if (!exact.empty() && !found.empty()) errors[r].push_back(error(found, exact));
      }
    }
    std::vector<Errors> result;
    for (auto& list : errors) result.push_back(summary(std::move(list)));
    return result;
  }

 private:
  static gaussgen::MechanicsOptions options() {
    gaussgen::MechanicsOptions options;
    options.fold = true;
    return options;
  }

  gaussgen::model::Model model_;
  Mechanics mechanics_;
  Request plain_;
  std::vector<Request> requests_;
};

}  // namespace

// Reached so far with all passes: in the median 1.3 times for double_pendulum_planar, 1.2 for rotor_on_platform, where units turn round
// numbers into others; in the 99th percentile, 1.6 times for the disc and 1.4 times for the
// parallel bars, which have states near singular ones among the random ones.
constexpr double k_bar_of_median = 1.35;
constexpr double k_bar_of_high = 1.7;

TEST_CASE("passes leave the errors of accelerations as they are, but for a little") {
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    const std::vector<Errors> errors = Trial(file).run();
    std::printf("%-32s", file.c_str());
    for (const Errors& e : errors) std::printf(" %8.2g %8.2g |", e.median / errors[0].median, e.high / errors[0].high);
    std::printf(" %8.2g %8.2g\n", errors[0].median, errors[0].high);
    CHECK(errors.back().median <= k_bar_of_median * errors[0].median);
    CHECK(errors.back().high <= k_bar_of_high * errors[0].high);
  }
}
