#define GAUSS_TEST_TYPE Wide
#include "as_scalar.inc"

#include <random>

namespace headertest {

namespace {

class Nudge {
 public:
  void operator()(Wide& value) { value *= 1 + Wide("1e-20") * direction_(random_); }

  template <class S, class Members>
  void all(S& object, const Members& members) {
    for (std::size_t i = 0; members[i] != nullptr; ++i) (*this)(object.*members[i]);
  }

 private:
  std::mt19937 random_{20};
  std::uniform_real_distribution<double> direction_{-1, 1};
};

template <class M>
std::array<Wide, k_parts.size()> sensitivity(const Sample& sample) {
  const auto here = answer<M, Wide>(point<M, Wide>(sample));
  std::array<Wide, k_parts.size()> largest_change{};
  Nudge nudge;
  for (int direction = 0; direction < 4; ++direction) {
    Point<M, Wide> near_by = point<M, Wide>(sample);
    nudge(near_by.t);
    for (Wide& value : near_by.state.values) nudge(value);
    nudge.all(near_by.parameters, M::template parameters<Wide>());
    nudge.all(near_by.inputs, M::template inputs<Wide>());
    const auto there = answer<M, Wide>(near_by);
    for (std::size_t p = 0; p < k_parts.size(); ++p) {
      const Wide change = largest_difference(here.parts[p], there.parts[p]) * Wide("1e20");
      if (!(change <= largest_change[p])) largest_change[p] = change;
    }
  }
  return largest_change;
}

}  // namespace

std::vector<Sensitivity> sensitivities() {
  return {
#define GAUSS_TESTED_MODEL(name_space) sensitivity<name_space::Tested>,
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
  };
}

}  // namespace headertest
