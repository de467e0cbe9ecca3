// The type with 50 digits is what all others are compared with, so it has to have them: a double anywhere in emitted
// code, such as a constant that does not come from exact integers, would show here and nowhere else.

#include "agreement/models.hpp"
#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "samples.hpp"

namespace {

using headertest::Wide;

constexpr int k_digits = 60;
constexpr std::size_t k_states = 10;

/// Accelerations by the interpreter in CLN, with no compiler involved.
class Interpreted {
 public:
  explicit Interpreted(const std::string& file)
      : model_(agreement::load(file)), mechanics_(model_, {}), evaluator_(mechanics_.graph, Arithmetic(k_digits)) {
    gaussgen::bind_parameters(mechanics_, evaluator_);
  }

  std::vector<Wide> accelerations(const headertest::Sample& sample) {
    const auto speeds = sample.y.begin() + static_cast<std::ptrdiff_t>(mechanics_.symbols.configuration.size());
    agreement::bind(mechanics_.symbols, {sample.t, {sample.y.begin(), speeds}, {speeds, sample.y.end()}}, evaluator_);
    std::vector<Wide> values;
    for (const auto& acceleration : mechanics_.solution.accelerations) {
      const auto value = evaluator_(acceleration.id());
      REQUIRE(value);
      values.emplace_back(gaussgen::evaluate::to_decimal(*value, k_digits));
    }
    return values;
  }

 private:
  using Arithmetic = gaussgen::evaluate::Arithmetic<cln::cl_F>;

  gaussgen::model::Model model_;
  gaussgen::Mechanics mechanics_;
  gaussgen::evaluate::Evaluator<cln::cl_F> evaluator_;
};

}  // namespace

TEST_CASE("emitted code in 50 digits has 45 of them right, by an evaluation that no compiler takes part in") {
  const auto doubles = headertest::plain_models<double>();
  const auto wides = headertest::plain_models<Wide>();
  const auto sensitivities = headertest::sensitivities();
  for (std::size_t m = 0; m < wides.size(); ++m) {
    INFO(wides[m].name);
    Interpreted interpreted(wides[m].name);
    for (const auto& sample : headertest::random_samples(doubles.at(m), k_states, false)) {
      const std::vector<Wide> compiled = wides[m].answers({sample}).at(0).parts[1];
      const std::vector<Wide> expected = interpreted.accelerations(sample);
      const Wide scale = headertest::largest(expected) + sensitivities.at(m)(sample)[1];
      REQUIRE(expected.size() == compiled.size());
      CHECK(headertest::largest_difference(compiled, expected) <= Wide("1e-45") * scale);
    }
  }
}
