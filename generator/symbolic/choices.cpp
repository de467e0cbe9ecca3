#include "symbolic/choices.hpp"

namespace gaussgen::symbolic {

using GiNaC::ex;
using GiNaC::symbol;

namespace {

// Explicit derivatives: by the partial ones, the branch that is not chosen would be multiplied by 0, and it may have no
// value there.
ex rate_of_abs(const ex& x, const symbol& s) { return sign_of(x) * x.diff(s); }
ex rate_of_sign(const ex&, const symbol&) { return 0; }

ex chosen(const ex& a, const ex& b, const ex& yes, const ex& no) {
  return yes.is_equal(no) ? yes : ex(case_at_most(a, b, yes, no));
}

ex rate_of_min(const ex& a, const ex& b, const symbol& s) { return chosen(a, b, a.diff(s), b.diff(s)); }
ex rate_of_max(const ex& a, const ex& b, const symbol& s) { return chosen(b, a, a.diff(s), b.diff(s)); }
ex rate_at_most(const ex& a, const ex& b, const ex& yes, const ex& no, const symbol& s) {
  return chosen(a, b, yes.diff(s), no.diff(s));
}
ex rate_less(const ex& a, const ex& b, const ex& yes, const ex& no, const symbol& s) {
  const ex rate = yes.diff(s), other = no.diff(s);
  return rate.is_equal(other) ? rate : ex(case_less(a, b, rate, other));
}
ex rate_of_table(const ex& table, const ex& order, const ex& x, const symbol& s) {
  return table_at(table, order + 1, x) * x.diff(s);
}

}  // namespace

// Registered under these names, which lower/ knows.
REGISTER_FUNCTION(abs_of, expl_derivative_func(rate_of_abs))
REGISTER_FUNCTION(sign_of, expl_derivative_func(rate_of_sign))
REGISTER_FUNCTION(min_of, expl_derivative_func(rate_of_min))
REGISTER_FUNCTION(max_of, expl_derivative_func(rate_of_max))
REGISTER_FUNCTION(case_less, expl_derivative_func(rate_less))
REGISTER_FUNCTION(case_at_most, expl_derivative_func(rate_at_most))
REGISTER_FUNCTION(table_at, expl_derivative_func(rate_of_table))

}  // namespace gaussgen::symbolic
