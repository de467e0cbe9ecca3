#!/usr/bin/env bash
# compilers.sh SOURCE_DIR BUILD_DIR GAUSS_GEN: same bytes from a generator that clang++ has built.
#
# Builds gauss-gen with clang++, and without optimisation, in BUILD_DIR. Compares what it prints for every model with what
# GAUSS_GEN prints.
set -euo pipefail

source_dir=$1
build_dir=$2
program=$3
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)

command -v clang++ >/dev/null || { echo "compilers: there is no clang++ here" >&2; exit 77; }
launcher=$(command -v ccache || true)
cmake -S "$source_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" \
  -DGAUSS_BUILD_TESTS=OFF -DGAUSS_BUILD_EXAMPLES=OFF >"$build_dir.log" 2>&1 || { cat "$build_dir.log" >&2; exit 1; }
cmake --build "$build_dir" --parallel 2 --target gauss-gen >>"$build_dir.log" 2>&1 || { cat "$build_dir.log" >&2; exit 1; }

hashes() {
  GAUSS_GEN=$1 GAUSS_SOURCE_DIR=$source_dir PYTHONPATH=$here python3 -B -c '
import same_bytes
for name, value in same_bytes.hashes().items(): print(value, name)'
}
diff <(hashes "$program") <(hashes "$build_dir/bin/gauss-gen")
echo "compilers: the same bytes from both"
