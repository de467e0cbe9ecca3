// The Runge-Kutta pair RK8(7)13M of P. J. Prince and J. R. Dormand, High order embedded Runge-Kutta formulae, Journal of Computational
// and Applied Mathematics 7 (1981) 67-75, table 2, as a stepper of Boost.Odeint.
//
// Odeint's own pair of this order is Fehlberg's, whose estimate of the error is 41/840 h (k1 + k11 - k12 - k13), taken at the
// times t, t + h, t, t + h: it is zero, whatever the step, for forces that depend on time alone.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_PRINCE_DORMAND87_HPP
#define GAUSS_INTEGRATE_PRINCE_DORMAND87_HPP

#include <boost/array.hpp>
#include <boost/fusion/include/make_vector.hpp>
#include <boost/numeric/odeint/stepper/explicit_error_generic_rk.hpp>
#include <cstddef>
#include <cstdint>

namespace gauss::integrate {

struct Fraction {
  std::int64_t numerator;
  std::int64_t denominator = 1;
};

/// The printed fractions meet the conditions of the order to 1e-17: enough for double, and for a tolerance of 1e-16 in wider types.
namespace prince_dormand87 {

inline constexpr Fraction k_a1[] = {{1, 18}};
inline constexpr Fraction k_a2[] = {{1, 48}, {1, 16}};
inline constexpr Fraction k_a3[] = {{1, 32}, {0}, {3, 32}};
inline constexpr Fraction k_a4[] = {{5, 16}, {0}, {-75, 64}, {75, 64}};
inline constexpr Fraction k_a5[] = {{3, 80}, {0}, {0}, {3, 16}, {3, 20}};
inline constexpr Fraction k_a6[] = {{29443841, 614563906}, {0}, {0}, {77736538, 692538347}, {-28693883, 1125000000},
                                    {23124283, 1800000000}};
inline constexpr Fraction k_a7[] = {
    {16016141, 946692911},   {0}, {0}, {61564180, 158732637}, {22789713, 633445777}, {545815736, 2771057229},
    {-180193667, 1043307555}};
inline constexpr Fraction k_a8[] = {{39632708, 573591083},
                                    {0},
                                    {0},
                                    {-433636366, 683701615},
                                    {-421739975, 2616292301},
                                    {100302831, 723423059},
                                    {790204164, 839813087},
                                    {800635310, 3783071287}};
inline constexpr Fraction k_a9[] = {{246121993, 1340847787},
                                    {0},
                                    {0},
                                    {-37695042795, 15268766246},
                                    {-309121744, 1061227803},
                                    {-12992083, 490766935},
                                    {6005943493, 2108947869},
                                    {393006217, 1396673457},
                                    {123872331, 1001029789}};
inline constexpr Fraction k_a10[] = {{-1028468189, 846180014},
                                     {0},
                                     {0},
                                     {8478235783, 508512852},
                                     {1311729495, 1432422823},
                                     {-10304129995, 1701304382},
                                     {-48777925059, 3047939560},
                                     {15336726248, 1032824649},
                                     {-45442868181, 3398467696},
                                     {3065993473, 597172653}};
inline constexpr Fraction k_a11[] = {{185892177, 718116043},
                                     {0},
                                     {0},
                                     {-3185094517, 667107341},
                                     {-477755414, 1098053517},
                                     {-703635378, 230739211},
                                     {5731566787, 1027545527},
                                     {5232866602, 850066563},
                                     {-4093664535, 808688257},
                                     {3962137247, 1805957418},
                                     {65686358, 487910083}};
inline constexpr Fraction k_a12[] = {{403863854, 491063109},
                                     {0},
                                     {0},
                                     {-5068492393, 434740067},
                                     {-411421997, 543043805},
                                     {652783627, 914296604},
                                     {11173962825, 925320556},
                                     {-13158990841, 6184727034},
                                     {3936647629, 1978049680},
                                     {-160528059, 685178525},
                                     {248638103, 1413531060},
                                     {0}};
inline constexpr Fraction k_c[] = {{0},
                                   {1, 18},
                                   {1, 12},
                                   {1, 8},
                                   {5, 16},
                                   {3, 8},
                                   {59, 400},
                                   {93, 200},
                                   {5490023248, 9719169821},
                                   {13, 20},
                                   {1201146811, 1299019798},
                                   {1},
                                   {1}};
/// Of order 8.
inline constexpr Fraction k_b[] = {{14005451, 335480064},
                                   {0},
                                   {0},
                                   {0},
                                   {0},
                                   {-59238493, 1068277825},
                                   {181606767, 758867731},
                                   {561292985, 797845732},
                                   {-1041891430, 1371343529},
                                   {760417239, 1151165299},
                                   {118820643, 751138087},
                                   {-528747749, 2220607170},
                                   {1, 4}};
/// Of order 7.
inline constexpr Fraction k_b7[] = {{13451932, 455176623},
                                    {0},
                                    {0},
                                    {0},
                                    {0},
                                    {-808719846, 976000145},
                                    {1757004468, 5645159321},
                                    {656045339, 265891186},
                                    {-3867574721, 1518517206},
                                    {465885868, 322736535},
                                    {53011238, 667516719},
                                    {2, 45},
                                    {0}};

template <class Value, std::size_t n>
boost::array<Value, n> row(const Fraction (&fractions)[n]) {
  boost::array<Value, n> values;
  for (std::size_t i = 0; i < n; ++i)
    values[i] = static_cast<Value>(fractions[i].numerator) / static_cast<Value>(fractions[i].denominator);
  return values;
}

template <class Value, std::size_t n>
boost::array<Value, n> difference(const Fraction (&left)[n], const Fraction (&right)[n]) {
  boost::array<Value, n> values = row<Value>(left);
  const boost::array<Value, n> others = row<Value>(right);
  for (std::size_t i = 0; i < n; ++i) values[i] -= others[i];
  return values;
}

}  // namespace prince_dormand87

/// Order 8, with an estimate of order 7; 13 calls of the system in a step, the first of which the caller may bring along.
template <class State, class Value>
class PrinceDormand87
    : public boost::numeric::odeint::explicit_error_generic_rk<13, 8, 8, 7, State, Value, State, Value> {
 public:
  using stepper_base_type = boost::numeric::odeint::explicit_error_generic_rk<13, 8, 8, 7, State, Value, State, Value>;

  PrinceDormand87()
      : stepper_base_type(boost::fusion::make_vector(prince_dormand87::row<Value>(prince_dormand87::k_a1),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a2),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a3),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a4),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a5),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a6),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a7),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a8),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a9),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a10),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a11),
                                                     prince_dormand87::row<Value>(prince_dormand87::k_a12)),
                          prince_dormand87::row<Value>(prince_dormand87::k_b),
                          prince_dormand87::difference<Value>(prince_dormand87::k_b, prince_dormand87::k_b7),
                          prince_dormand87::row<Value>(prince_dormand87::k_c)) {}
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_PRINCE_DORMAND87_HPP
