#pragma once
// Runs instructions in one scalar type.

#include <cstddef>

#include "gauss/math.hpp"
#include "sim/interpreter/general_solution.hpp"
#include "sim/interpreter/program.hpp"

#if defined(__GNUC__)
#define GAUSS_SIM_APART __attribute__((noinline))
#else
#define GAUSS_SIM_APART
#endif

namespace gausssim {

/// What a constant of the program is in S.
template <class S>
S value_of(const Constant& constant) {
  S value{};
  switch (constant.kind) {
    case Constant::Kind::number: value = static_cast<S>(constant.a); break;
    case Constant::Kind::pieces: value = gauss::Math<S>::constant(constant.a, constant.b, constant.c); break;
    case Constant::Kind::quotient: value = static_cast<S>(constant.a) / static_cast<S>(constant.b); break;
    case Constant::Kind::pi: value = gauss::Math<S>::pi(); break;
    case Constant::Kind::epsilon: value = gauss::Math<S>::epsilon(); break;
  }
  return constant.is_negative ? -value : value;
}

template <class S>
class Machine {
  using M = gauss::Math<S>;

 public:
  /// `slots` and `arguments` are those of a frame.
  Machine(const Program& program, S* slots, S** arguments) noexcept
      : code_(program.code.data()), program_(program), r_(slots), arguments_(arguments) {}

  gauss::Status run(std::size_t function) const noexcept;

 private:
  static S truth(bool condition) { return condition ? S(1) : S(0); }
  static bool holds(const S& condition) { return condition != S(0); }
  static gauss::Status status(const S& number) { return static_cast<gauss::Status>(static_cast<int>(number)); }
  static S number(gauss::Status status) { return static_cast<S>(static_cast<int>(status)); }

  GAUSS_SIM_APART void call(const Instruction& i) const noexcept {
    const Call& call = program_.calls[i.a];
    S** next = arguments_ + program_.functions[call.function].first_argument;
    for (const Passed& passed : call.arguments)
      *next++ = (passed.is_argument ? arguments_[passed.place] : r_ + passed.place) + passed.offset;
    r_[i.to] = number(run(call.function));
  }

  GAUSS_SIM_APART void find_status(const Instruction& i) const noexcept {
    const std::uint32_t* const conditions = program_.operands.data() + i.a;
    const auto is = [&](int k) { return holds(r_[conditions[k]]); };
    r_[i.to] = number(M::status(is(0), is(1), is(2), is(3)));
  }

  /// The one of the prelude, which takes components each by itself.
  GAUSS_SIM_APART void step(const Instruction& i) const noexcept {
    const std::uint32_t* const operands = program_.operands.data() + i.a;
    const std::uint32_t count = operands[0];
    const S* const before = r_ + operands[1];
    S* const after = r_ + operands[2];
    bool moves = false;
    for (std::uint32_t k = 0; k < count; ++k) {
      const S one_before[1] = {before[k]};
      S one_after[1] = {after[k]};
      const int by_one[1] = {static_cast<int>(r_[operands[3 + k]])};
      gauss::detail::Newton<S> newton;
      (void)newton.take(gauss::Status::ok, one_before, one_after, by_one);
      after[k] = one_after[0];
      moves = moves || newton.goes_on();
    }
    r_[i.to] = truth(moves);
  }

  GAUSS_SIM_APART void solve(const Instruction& i) const noexcept {
    with_general_solution<S>(program_.solves[i.a], r_, [](auto solution) { solution.solve(); });
  }

  GAUSS_SIM_APART void solve_each(const Instruction& i) const noexcept {
    r_[i.to] =
        number(with_general_solution<S>(program_.solves[i.a], r_, [](auto solution) { return solution.solve_each(); }));
  }

  const Instruction* code_;
  const Program& program_;
  S* r_;
  S** arguments_;
};

template <class S>
gauss::Status Machine<S>::run(std::size_t function) const noexcept {
  S* const r = r_;
  S** const arguments = arguments_;
  const Instruction* i = code_ + program_.functions[function].begin;
  // All of a run, and on to the next one.
  const auto each = [&i](const auto& work) {
    for (const Instruction* const end = i + i->run; i != end; ++i) work(*i);
  };
  const auto of_one = [&](const auto& f) { each([&](const Instruction& k) { r[k.to] = f(r[k.a]); }); };
  const auto of_two = [&](const auto& f) { each([&](const Instruction& k) { r[k.to] = f(r[k.a], r[k.b]); }); };
  const auto of_three = [&](const auto& f) {
    each([&](const Instruction& k) { r[k.to] = f(r[k.to], r[k.a], r[k.b]); });
  };
  for (;;) {
    switch (i->op) {
      case Op::move: of_one([](const S& x) { return x; }); break;
      case Op::load: each([&](const Instruction& k) { r[k.to] = arguments[k.a][k.b]; }); break;
      case Op::store: each([&](const Instruction& k) { arguments[k.a][k.b] = r[k.to]; }); break;
      case Op::add: of_two([](const S& x, const S& y) { return x + y; }); break;
      case Op::subtract: of_two([](const S& x, const S& y) { return x - y; }); break;
      case Op::multiply: of_two([](const S& x, const S& y) { return x * y; }); break;
      case Op::divide: of_two([](const S& x, const S& y) { return x / y; }); break;
      case Op::negate: of_one([](const S& x) { return -x; }); break;
      case Op::negative_product: of_two([](const S& x, const S& y) { return -x * y; }); break;
      case Op::add_product: of_three([](const S& sum, const S& x, const S& y) { return sum + x * y; }); break;
      case Op::subtract_product: of_three([](const S& sum, const S& x, const S& y) { return sum - x * y; }); break;
      case Op::add_difference: of_three([](const S& sum, const S& x, const S&) { return sum + (x - x); }); break;
      case Op::less: of_two([](const S& x, const S& y) { return truth(M::less(x, y)); }); break;
      case Op::at_most: of_two([](const S& x, const S& y) { return truth(M::at_most(x, y)); }); break;
      case Op::either: of_two([](const S& x, const S& y) { return truth(M::any(holds(x), holds(y))); }); break;
      case Op::is_no_number: of_one([](const S& x) { return truth(!(x == x)); }); break;
      case Op::select: of_three([](const S& is, const S& x, const S& y) { return M::select(holds(is), x, y); }); break;
      case Op::replace: of_three([](const S& x, const S& is, const S& y) { return M::select(holds(is), y, x); }); break;
      case Op::status: find_status(*i++); break;
      case Op::worse: of_two([](const S& x, const S& y) { return number(M::worse(status(x), status(y))); }); break;
      case Op::sin: of_one([](const S& x) { return M::sin(x); }); break;
      case Op::cos: of_one([](const S& x) { return M::cos(x); }); break;
      case Op::tan: of_one([](const S& x) { return M::tan(x); }); break;
      case Op::asin: of_one([](const S& x) { return M::asin(x); }); break;
      case Op::acos: of_one([](const S& x) { return M::acos(x); }); break;
      case Op::atan: of_one([](const S& x) { return M::atan(x); }); break;
      case Op::exp: of_one([](const S& x) { return M::exp(x); }); break;
      case Op::log: of_one([](const S& x) { return M::log(x); }); break;
      case Op::sinh: of_one([](const S& x) { return M::sinh(x); }); break;
      case Op::cosh: of_one([](const S& x) { return M::cosh(x); }); break;
      case Op::tanh: of_one([](const S& x) { return M::tanh(x); }); break;
      case Op::sqrt: of_one([](const S& x) { return M::sqrt(x); }); break;
      case Op::atan2: of_two([](const S& y, const S& x) { return M::atan2(y, x); }); break;
      case Op::pow: of_two([](const S& x, const S& y) { return M::pow(x, y); }); break;
      case Op::sincos: each([&](const Instruction& k) { M::sincos(S(r[k.a]), r[k.to], r[k.b]); }); break;
      case Op::call: call(*i++); break;
      case Op::newton: step(*i++); break;
      case Op::solve: solve(*i++); break;
      case Op::solve_each: solve_each(*i++); break;
      case Op::jump_if_zero: i = holds(r[i->a]) ? i + 1 : code_ + i->b; break;
      case Op::give_status: return status(r[i->a]);
      case Op::give_nothing: return gauss::Status::ok;
    }
  }
}

}  // namespace gausssim
