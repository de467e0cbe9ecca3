// Prints a hash of the bits of all states of a run of each model, for comparison of compilers and their options (catalogue H25).

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "trajectory_models.inc"

namespace {

#ifndef GAUSS_TEST_STEPS
#define GAUSS_TEST_STEPS 10000
#endif
constexpr int k_steps = GAUSS_TEST_STEPS;

/// FNV-1a over the bits of doubles.
class Hash {
 public:
  template <std::size_t n>
  void add(const double (&values)[n]) {
    for (const double value : values) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int i = 0; i < 8; ++i) hash_ = (hash_ ^ ((bits >> (8 * i)) & 0xFFU)) * 0x100000001B3U;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

/// A run of `Model`, whose functions are those of its namespace, by the classical method of Runge and Kutta in steps of 1 ms.
template <class Model>
class Run {
 public:
  explicit Run(const typename Model::Prepared& prepared) : prepared_(prepared) {
    note(initial_state(prepared_, state_));
    hash_.add(state_.values);
  }

  void step(double t) {
    constexpr double h = 1e-3;
    const typename Model::Derivative first = rate(t, state_), second = rate(t + h / 2, moved(h / 2, first)),
                                     third = rate(t + h / 2, moved(h / 2, second)),
                                     fourth = rate(t + h, moved(h, third));
    for (std::size_t i = 0; i < size; ++i)
      state_.values[i] += h / 6 * (first.values[i] + 2 * second.values[i] + 2 * third.values[i] + fourth.values[i]);
    note(Model::projected(t + h, prepared_, state_));
    hash_.add(state_.values);
  }

  const typename Model::State& state() const { return state_; }
  std::uint64_t hash() const { return hash_.value(); }
  bool is_ok() const { return is_ok_; }

 private:
  static constexpr std::size_t size = sizeof(Model::State::values) / sizeof(double);

  void note(gauss::Status status) { is_ok_ = is_ok_ && status == gauss::Status::ok; }

  typename Model::Derivative rate(double t, const typename Model::State& state) {
    typename Model::Derivative result{};
    note(rhs(t, state, typename Model::Inputs{}, prepared_, result));
    return result;
  }

  typename Model::State moved(double h, const typename Model::Derivative& rate) const {
    typename Model::State result = state_;
    for (std::size_t i = 0; i < size; ++i) result.values[i] += h * rate.values[i];
    return result;
  }

  typename Model::Prepared prepared_;
  typename Model::State state_{};
  Hash hash_;
  bool is_ok_ = true;
};

/// The name, the hash, the last state in all its digits.
template <class Model>
bool print(const char* name) {
  Run<Model> run(prepare(typename Model::Parameters{}));
  for (int k = 0; k < k_steps; ++k) run.step(1e-3 * k);
  std::printf("%s %016llx", name, static_cast<unsigned long long>(run.hash()));
  for (const double value : run.state().values) std::printf(" %.17g", value);
  std::printf("%s\n", run.is_ok() ? "" : " NOT OK");
  return run.is_ok();
}

}  // namespace

#define GAUSS_TEST_STRUCT(name)                                                        \
  struct Model_##name {                                                                \
    using State = gauss::name::State<double>;                                          \
    using Derivative = gauss::name::Derivative<double>;                                \
    using Inputs = gauss::name::Inputs<double>;                                        \
    using Parameters = gauss::name::Parameters<double>;                                \
    using Prepared = decltype(prepare(Parameters{}));                                  \
    static gauss::Status projected(double t, const Prepared& prepared, State& state) { \
      return project(t, state, prepared, state);                                       \
    }                                                                                  \
  };
GAUSS_TEST_EACH(GAUSS_TEST_STRUCT)

int main() {
  bool is_ok = true;
#define GAUSS_TEST_PRINT(name) is_ok = print<Model_##name>(#name) && is_ok;
  GAUSS_TEST_EACH(GAUSS_TEST_PRINT)
  return is_ok ? 0 : 1;
}
