"""sympy_main.py KIND SIZE FILE: derives, shares, prints a header. Parameters are numbers before anything is shared.

Prints the seconds that this took without the start of Python and SymPy.
"""

import sys
import time
from pathlib import Path

import sympy as sm

import sympy_systems


def text_of(system):
    n = len(system.u)
    x = {symbol: sm.Symbol(f"x[{i}]") for i, symbol in enumerate([*system.q, *system.u])}
    numbers = {symbol: sm.Float(value) for symbol, value in system.numbers.items()}
    entries = [(i, j) for i in range(n) for j in range(i + 1 if system.is_symmetric else n)]
    outputs = [system.M[i, j] for i, j in entries] + list(system.f) + list(system.kinematics or [])
    shared, rest = sm.cse([output.xreplace(numbers).xreplace(x) for output in outputs], symbols=sm.numbered_symbols("z"))
    lines = [f"  const S {symbol} = {sm.ccode(value)};" for symbol, value in shared]
    targets = [f"M[{i * n + j}]" for i, j in entries] + [f"f[{i}]" for i in range(n)]
    targets += [f"rates[{i}]" for i in range(len(outputs) - len(targets))]
    lines += [f"  {target} = {sm.ccode(value)};" for target, value in zip(targets, rest)]
    body = "\n".join(lines)
    return f"""// By SymPy {sm.__version__}: Kane's method, cse, C printer.
#include <cmath>
namespace by_sympy {{
using std::atan, std::cos, std::fabs, std::pow, std::sin, std::sqrt, std::tan;
inline constexpr int n_q = {len(system.q)};
inline constexpr int n_u = {n};
inline constexpr bool is_symmetric = {"true" if system.is_symmetric else "false"};
inline constexpr bool has_kinematics = {"false" if system.kinematics is None else "true"};
template <class S>
inline void mass_and_force(const S* x, S* M, S* f, S* rates) {{
  (void)rates;
{body}
}}
}}  // namespace by_sympy
"""


def main():
    kind, size, path = sys.argv[1], int(sys.argv[2]), Path(sys.argv[3])
    sys.setrecursionlimit(100000)
    begin = time.process_time()
    path.write_text(text_of(getattr(sympy_systems, kind)(size)), encoding="utf-8")
    print(time.process_time() - begin)


if __name__ == "__main__":
    main()
