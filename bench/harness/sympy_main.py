"""sympy_main.py KIND SIZE PARAMETERS FILE: derives, shares, prints a header. PARAMETERS: "numbers", put in before anything is shared, or
"symbols", read from an array in each call, as in the code that PyDy generates.

Prints the seconds that this took without the start of Python and SymPy.
"""

import sys
import time
from pathlib import Path

import sympy as sm

import sympy_systems


def text_of(system, parameters):
    n = len(system.u)
    x = {symbol: sm.Symbol(f"x[{i}]") for i, symbol in enumerate([*system.q, *system.u])}
    values = [float(value) for value in system.numbers.values()]
    given = {symbol: sm.Symbol(f"p[{i}]") if parameters == "symbols" else sm.Float(value)
             for i, (symbol, value) in enumerate(zip(system.numbers, values))}
    entries = [(i, j) for i in range(n) for j in range(i + 1 if system.is_symmetric else n)]
    outputs = [system.M[i, j] for i, j in entries] + list(system.f) + list(system.kinematics or [])
    shared, rest = sm.cse([output.xreplace(given).xreplace(x) for output in outputs], symbols=sm.numbered_symbols("z"))
    lines = [f"  const S {symbol} = {sm.ccode(value)};" for symbol, value in shared]
    targets = [f"M[{i * n + j}]" for i, j in entries] + [f"f[{i}]" for i in range(n)]
    targets += [f"rates[{i}]" for i in range(len(outputs) - len(targets))]
    lines += [f"  {target} = {sm.ccode(value)};" for target, value in zip(targets, rest)]
    body = "\n".join(lines)
    return f"""// By SymPy {sm.__version__}: Kane's method, cse, C printer.
#include <cmath>
// Two such headers are in one program.
namespace by_sympy_{parameters} {{
using std::atan, std::cos, std::fabs, std::pow, std::sin, std::sqrt, std::tan;
inline constexpr int n_q = {len(system.q)};
inline constexpr int n_u = {n};
inline constexpr bool is_symmetric = {"true" if system.is_symmetric else "false"};
inline constexpr bool has_kinematics = {"false" if system.kinematics is None else "true"};
inline constexpr int n_p = {len(values)};
inline double parameters[n_p] = {{{", ".join(map(repr, values))}}};
template <class S>
inline void mass_and_force(const S* x, const S* p, S* M, S* f, S* rates) {{
  (void)p, (void)rates;
{body}
}}
}}  // namespace by_sympy_{parameters}
namespace by_sympy = by_sympy_{parameters};
"""


def main():
    kind, size, parameters, path = sys.argv[1], int(sys.argv[2]), sys.argv[3], Path(sys.argv[4])
    sys.setrecursionlimit(100000)
    begin = time.process_time()
    path.write_text(text_of(getattr(sympy_systems, kind)(size), parameters), encoding="utf-8")
    print(time.process_time() - begin)


if __name__ == "__main__":
    main()
