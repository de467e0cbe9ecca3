#pragma once
// Runs instructions in one scalar type.

#include <cstddef>

#include "gauss/math.hpp"
#include "interpreter/general_solution.hpp"
#include "interpreter/program.hpp"

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
    const auto holds = [&](int k) { return r_[conditions[k]] != S(0); };
    r_[i.to] = number(i.count == 3 ? M::status(holds(0), holds(1), holds(2))
                                   : M::status(holds(0), holds(1), holds(2), holds(3)));
  }

  /// The one of the prelude, which takes components each by itself.
  GAUSS_SIM_APART void step(const Instruction& i) const noexcept {
    const std::uint32_t* const operands = program_.operands.data() + i.a;
    const S* const before = r_ + operands[0];
    S* const after = r_ + operands[1];
    bool moves = false;
    for (int k = 0; k < i.count; ++k) {
      const S one_before[1] = {before[k]};
      S one_after[1] = {after[k]};
      const int by_one[1] = {static_cast<int>(r_[operands[2 + k]])};
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
  for (const Instruction* i = code_ + program_.functions[function].begin;; ++i) {
    switch (i->op) {
      case Op::move: r[i->to] = r[i->a]; break;
      case Op::copy:
        for (int k = 0; k < i->count; ++k) r[i->to + k] = r[i->a + k];
        break;
      case Op::load: {
        const S* const from = arguments_[i->a] + i->b;
        for (int k = 0; k < i->count; ++k) r[i->to + k] = from[k];
        break;
      }
      case Op::store: {
        S* const place = arguments_[i->a] + i->b;
        for (int k = 0; k < i->count; ++k) place[k] = r[i->to + k];
        break;
      }
      case Op::add: r[i->to] = r[i->a] + r[i->b]; break;
      case Op::subtract: r[i->to] = r[i->a] - r[i->b]; break;
      case Op::multiply: r[i->to] = r[i->a] * r[i->b]; break;
      case Op::divide: r[i->to] = r[i->a] / r[i->b]; break;
      case Op::negate: r[i->to] = -r[i->a]; break;
      case Op::negative_product: r[i->to] = -r[i->a] * r[i->b]; break;
      case Op::add_product: r[i->to] = r[i->to] + r[i->a] * r[i->b]; break;
      case Op::subtract_product: r[i->to] = r[i->to] - r[i->a] * r[i->b]; break;
      case Op::add_difference: r[i->to] = r[i->to] + (r[i->a] - r[i->a]); break;
      case Op::less: r[i->to] = truth(M::less(r[i->a], r[i->b])); break;
      case Op::at_most: r[i->to] = truth(M::at_most(r[i->a], r[i->b])); break;
      case Op::either: r[i->to] = truth(M::any(r[i->a] != S(0), r[i->b] != S(0))); break;
      case Op::is_no_number: r[i->to] = truth(!(r[i->a] == r[i->a])); break;
      case Op::select: r[i->to] = M::select(r[i->to] != S(0), r[i->a], r[i->b]); break;
      case Op::replace: r[i->to] = M::select(r[i->a] != S(0), r[i->b], r[i->to]); break;
      case Op::status: find_status(*i); break;
      case Op::worse: r[i->to] = number(M::worse(status(r[i->a]), status(r[i->b]))); break;
      case Op::sin: r[i->to] = M::sin(r[i->a]); break;
      case Op::cos: r[i->to] = M::cos(r[i->a]); break;
      case Op::tan: r[i->to] = M::tan(r[i->a]); break;
      case Op::asin: r[i->to] = M::asin(r[i->a]); break;
      case Op::acos: r[i->to] = M::acos(r[i->a]); break;
      case Op::atan: r[i->to] = M::atan(r[i->a]); break;
      case Op::atan2: r[i->to] = M::atan2(r[i->a], r[i->b]); break;
      case Op::exp: r[i->to] = M::exp(r[i->a]); break;
      case Op::log: r[i->to] = M::log(r[i->a]); break;
      case Op::sinh: r[i->to] = M::sinh(r[i->a]); break;
      case Op::cosh: r[i->to] = M::cosh(r[i->a]); break;
      case Op::tanh: r[i->to] = M::tanh(r[i->a]); break;
      case Op::sqrt: r[i->to] = M::sqrt(r[i->a]); break;
      case Op::pow: r[i->to] = M::pow(r[i->a], r[i->b]); break;
      case Op::sincos: {
        const S angle = r[i->a];
        M::sincos(angle, r[i->to], r[i->b]);
        break;
      }
      case Op::call: call(*i); break;
      case Op::newton: step(*i); break;
      case Op::solve: solve(*i); break;
      case Op::solve_each: solve_each(*i); break;
      case Op::jump_if_zero:
        if (r[i->a] == S(0)) i = code_ + i->b - 1;
        break;
      case Op::give_status: return status(r[i->a]);
      case Op::give_nothing: return gauss::Status::ok;
    }
  }
}

}  // namespace gausssim
