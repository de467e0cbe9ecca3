// Batches, a sample in each lane, and the same lanes one at a time.

#include "compute.hpp"
#include "lane.hpp"
#include "plain_models.hpp"

namespace headertest {

namespace {

template <class M, class T>
Point<M, xsimd::batch<T>> packed(const std::vector<Sample>& samples, std::size_t first) {
  using Batch = xsimd::batch<T>;
  const auto gather = [&](const auto& number_of) {
    T lanes[Batch::size];
    for (std::size_t i = 0; i < Batch::size; ++i) {
      lanes[i] = static_cast<T>(number_of(samples[std::min(first + i, samples.size() - 1)]));
    }
    return Batch::load_unaligned(lanes);
  };
  Point<M, Batch> at;
  at.t = gather([](const Sample& sample) { return sample.t; });
  for (std::size_t k = 0; k < samples[0].y.size(); ++k) {
    at.state.values[k] = gather([k](const Sample& sample) { return sample.y[k]; });
  }
  return at;
}

template <class M, class T>
Computed in_batches() {
  using Batch = xsimd::batch<T>;
  return {M::name, M::n_q, M::n_v, [](const std::vector<Sample>& samples) {
            std::vector<Answer> answers;
            for (std::size_t first = 0; first < samples.size(); first += Batch::size) {
              const auto found = results<M, Batch>(packed<M, T>(samples, first));
              const auto values = parts<M, Batch>(found);
              for (std::size_t i = 0; i < Batch::size && first + i < samples.size(); ++i) {
                Answer answer;
                for (const auto& status : found.statuses) answer.statuses.push_back(status.lane(i));
                for (std::size_t p = 0; p < values.size(); ++p) {
                  for (const Batch& value : values[p]) answer.parts[p].push_back(widened(value.get(i)));
                }
                answers.push_back(std::move(answer));
              }
            }
            return answers;
          }};
}

}  // namespace

#define GAUSS_MODELS_AS(type, function, argument) \
  template <>                                     \
  std::vector<Computed> plain_models<type>() {    \
    return models_##function<argument>();         \
  }

template <class T>
std::vector<Computed> models_in_batches() {
  return {
#define GAUSS_TESTED_MODEL(name_space) in_batches<name_space::Tested, T>(),
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
  };
}

template <class T>
std::vector<Computed> models_lane_by_lane() {
  return {
#define GAUSS_TESTED_MODEL(name_space) computed<name_space::Tested, Lane<T>>(),
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
  };
}

GAUSS_MODELS_AS(xsimd::batch<float>, in_batches, float)
GAUSS_MODELS_AS(xsimd::batch<double>, in_batches, double)
GAUSS_MODELS_AS(Lane<float>, lane_by_lane, float)
GAUSS_MODELS_AS(Lane<double>, lane_by_lane, double)

}  // namespace headertest
