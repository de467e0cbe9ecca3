// Finds values that are not finite, also where the compiler was told that there are none. Prints what was missed; exits with 1 then.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "double_pendulum.hpp"

namespace model = gauss::double_pendulum;

namespace {

int missed = 0;

/// Compilers that take numbers for finite need not make others of literals or by arithmetic.
template <class S, class Word>
S of_bits(Word bits) {
  S result = 0;
  std::memcpy(&result, &bits, sizeof bits);
  return result;
}

template <class S>
void expect(const char* what, bool found, bool wanted) {
  if (found == wanted) return;
  std::printf("%zu bytes: %s\n", sizeof(S), what);
  ++missed;
}

template <class S>
void check_numbers(S infinity, S nan, S largest, S least) {
  using Math = gauss::Math<S>;
  expect<S>("infinite", Math::not_finite(infinity), true);
  expect<S>("minus infinite", Math::not_finite(S(1), -infinity), true);
  expect<S>("not a number", Math::not_finite(S(1), S(2), nan), true);
  expect<S>("finite", Math::not_finite(largest, -largest, least, S(0)), false);
}

template <class S>
void check_model(S bad) {
  const auto prepared = prepare(model::Parameters<S>{});
  for (auto i = 0; i < 4; ++i) {
    model::State<S> state{};
    model::Derivative<S> derivative{};
    expect<S>("a state that is finite", rhs(S(0), state, {}, prepared, derivative) == gauss::Status::ok, true);
    state.values[i] = bad;
    expect<S>("a state", rhs(S(0), state, {}, prepared, derivative) == gauss::Status::ok, false);
  }
}

}  // namespace

int main() {
  const auto infinity = of_bits<double>(std::uint64_t{0x7FF0000000000000}),
             nan = of_bits<double>(std::uint64_t{0x7FF8000000000000});
  const auto infinity_f = of_bits<float>(std::uint32_t{0x7F800000}), nan_f = of_bits<float>(std::uint32_t{0x7FC00000});
  check_numbers(infinity, nan, of_bits<double>(std::uint64_t{0x7FEFFFFFFFFFFFFF}), of_bits<double>(std::uint64_t{1}));
  check_numbers(infinity_f, nan_f, of_bits<float>(std::uint32_t{0x7F7FFFFF}), of_bits<float>(std::uint32_t{1}));
  for (const double bad : {infinity, nan}) check_model(bad);
  for (const float bad : {infinity_f, nan_f}) check_model(bad);
  return missed == 0 ? 0 : 1;
}
