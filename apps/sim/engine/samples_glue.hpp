// States within one step of a power series, and functions of them, for four times at once: a part of plugins, compiled with the model.
// SPDX-License-Identifier: MIT
//
// Each lane rounds as one sample alone does, and functions are those of the C library, so that results are the same to the bit.
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace gauss_sim_glue {

inline constexpr std::size_t k_lanes = 4;

struct LanesMask {
  typedef long long Numbers __attribute__((vector_size(k_lanes * sizeof(long long))));
  Numbers numbers;  ///< -1 where it holds, else 0

  LanesMask(const Numbers& numbers) : numbers(numbers) {}
  explicit LanesMask(bool all = false) : numbers(Numbers{} - (all ? 1 : 0)) {}
  bool any() const { return (numbers[0] | numbers[1] | numbers[2] | numbers[3]) != 0; }
  friend LanesMask operator|(const LanesMask& a, const LanesMask& b) { return a.numbers | b.numbers; }
};

/// A number for each of four samples.
struct Lanes {
  typedef double Numbers __attribute__((vector_size(k_lanes * sizeof(double))));
  Numbers numbers;

  Lanes() = default;
  Lanes(const Numbers& numbers) : numbers(numbers) {}
  explicit Lanes(double all) : numbers(Numbers{all, all, all, all}) {}

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.numbers + b.numbers; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.numbers - b.numbers; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.numbers * b.numbers; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.numbers / b.numbers; }
  friend Lanes operator-(const Lanes& a) { return -a.numbers; }
};

/// Samples whose results are not ok are found again one by one: which status they have is seen then.
struct LanesStatus {
  LanesMask bad{false};

  friend LanesStatus operator|(const LanesStatus& a, const LanesStatus& b) { return {a.bad | b.bad}; }
};

}  // namespace gauss_sim_glue

namespace gauss {

template <>
struct Math<gauss_sim_glue::Lanes> {
  using S = gauss_sim_glue::Lanes;
  using Bool = gauss_sim_glue::LanesMask;
  using Status = gauss_sim_glue::LanesStatus;
  using One = Math<double>;

#define GAUSS_SIM_EACH(f)                                                                                      \
  static S f(const S& x) {                                                                                     \
    return S::Numbers{One::f(x.numbers[0]), One::f(x.numbers[1]), One::f(x.numbers[2]), One::f(x.numbers[3])}; \
  }
  GAUSS_SIM_EACH(sin)
  GAUSS_SIM_EACH(cos)
  GAUSS_SIM_EACH(tan)
  GAUSS_SIM_EACH(asin)
  GAUSS_SIM_EACH(acos)
  GAUSS_SIM_EACH(atan)
  GAUSS_SIM_EACH(exp)
  GAUSS_SIM_EACH(log)
  GAUSS_SIM_EACH(sinh)
  GAUSS_SIM_EACH(cosh)
  GAUSS_SIM_EACH(tanh)
  GAUSS_SIM_EACH(sqrt)
#undef GAUSS_SIM_EACH
#define GAUSS_SIM_EACH(f)                                                                      \
  static S f(const S& x, const S& y) {                                                         \
    return S::Numbers{One::f(x.numbers[0], y.numbers[0]), One::f(x.numbers[1], y.numbers[1]),  \
                      One::f(x.numbers[2], y.numbers[2]), One::f(x.numbers[3], y.numbers[3])}; \
  }
  GAUSS_SIM_EACH(atan2)
  GAUSS_SIM_EACH(pow)
#undef GAUSS_SIM_EACH

  /// By a function that g++ knows to depend on its argument alone, for which it calls sincos of the C library: an angle of several functions is asked for once.
  static void sincos(const S& x, S& sine, S& cosine) {
#if defined(__GNUC__) && !defined(__clang__)
    const _Complex double pairs[] = {pair(x.numbers[0]), pair(x.numbers[1]), pair(x.numbers[2]), pair(x.numbers[3])};
    sine = S::Numbers{__imag__ pairs[0], __imag__ pairs[1], __imag__ pairs[2], __imag__ pairs[3]};
    cosine = S::Numbers{__real__ pairs[0], __real__ pairs[1], __real__ pairs[2], __real__ pairs[3]};
#else
    double sines[gauss_sim_glue::k_lanes], cosines[gauss_sim_glue::k_lanes];
    for (std::size_t i = 0; i < gauss_sim_glue::k_lanes; ++i) One::sincos(x.numbers[i], sines[i], cosines[i]);
    sine = S::Numbers{sines[0], sines[1], sines[2], sines[3]};
    cosine = S::Numbers{cosines[0], cosines[1], cosines[2], cosines[3]};
#endif
  }

  static Bool less(const S& a, const S& b) { return a.numbers < b.numbers; }
  static Bool at_most(const S& a, const S& b) { return a.numbers <= b.numbers; }
  static S select(const Bool& condition, const S& a, const S& b) { return condition.numbers ? a.numbers : b.numbers; }
  template <class... Rest>
  static Bool any(const Bool& first, const Rest&... rest) {
    return (first | ... | rest);
  }
  template <class... Rest>
  static Bool not_finite(const S& first, const Rest&... rest) {
    GAUSS_IN_ORDER
    S sum = first - first;
    ((sum = sum + (rest - rest)), ...);
    return sum.numbers != sum.numbers;
  }
  static Status status(const Bool& singular_mass_matrix, const Bool& dependent_constraints, const Bool& not_finite,
                       const Bool& violated_constraints = Bool(false)) {
    return {singular_mass_matrix | dependent_constraints | not_finite | violated_constraints};
  }
  static Status worse(const Status& a, const Status& b) { return a | b; }

#if defined(__GNUC__) && !defined(__clang__)
  static _Complex double pair(double x) { return __builtin_cexpi(detail::at_run_time(x)); }
#endif

  static S epsilon() { return S(One::epsilon()); }
  static S pi() { return S(One::pi()); }
  static S constant(double hi, double mid, double lo) { return S(One::constant(hi, mid, lo)); }
};

}  // namespace gauss

namespace gauss_sim_glue {

/// A struct of emitted code holds scalars only, so it is an array of them.
template <class Struct>
inline constexpr std::size_t k_numbers_of = std::is_empty_v<Struct> ? 0 : sizeof(Struct) / sizeof(Lanes);

template <class Struct>
void put_into_all(const void* numbers, Struct& all) {
  for (std::size_t i = 0; i < k_numbers_of<Struct>; ++i)
    reinterpret_cast<Lanes*>(&all)[i] = Lanes(static_cast<const double*>(numbers)[i]);
}

/// One lane after the other, number by number.
template <class Struct>
void take_apart(const Struct& all, double* numbers) {
  constexpr std::size_t n = k_numbers_of<Struct>;
  for (std::size_t lane = 0; lane < k_lanes; ++lane)
    for (std::size_t i = 0; i < n; ++i) numbers[lane * n + i] = reinterpret_cast<const Lanes*>(&all)[i].numbers[lane];
}

/// `Sampled` has the projection of the model, and the functions that are asked for.
template <class Sampled>
class Samples {
  using State = typename Sampled::State;
  using Results = typename Sampled::Results;

 public:
  static constexpr std::size_t most = k_lanes;

  Samples(const void* prepared, const void* inputs) {
    put_into_all(prepared, prepared_);
    put_into_all(inputs, inputs_);
  }

  /// At times within the step that was taken last, of a simulation that projects. False: at one of them, something is not ok, and nothing is filled. The simulation is at the last of them then.
  /// All that is called is written out here, without a branch: what a function has found of an angle is known to those after it.
  template <class Simulation>
  [[gnu::flatten, gnu::noinline]] bool look(Simulation& simulation, const double (&times)[k_lanes], double* states,
                                            double* results) const {
    const Lanes t = Lanes::Numbers{times[0], times[1], times[2], times[3]};
    State found, there;
    gauss::integrate::states_of_series(simulation.series(), t - Lanes(simulation.begin_of_step()), found);
    LanesMask bad = Sampled::project(t, found, prepared_, there).bad;
    for (std::size_t i = 0; i < k_numbers_of<State>; ++i) {
      const Lanes::Numbers off = found.values[i].numbers - there.values[i].numbers;
      const Lanes::Numbers most = Lanes(simulation.most_moved(i)).numbers;
      bad = bad | LanesMask(~((off <= most) & (-most <= off)));
    }
    Results all;
    bad = bad | Sampled::functions(t, there, inputs_, prepared_, all).bad;
    if (bad.any()) return false;
    take_apart(there, states);
    take_apart(all, results);
    simulation.take(times[k_lanes - 1], [&](std::size_t i) { return there.values[i].numbers[k_lanes - 1]; });
    return true;
  }

 private:
  typename Sampled::Prepared prepared_{};
  typename Sampled::Inputs inputs_{};
};

}  // namespace gauss_sim_glue
