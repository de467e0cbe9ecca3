#!/usr/bin/env bash
# The headers in generated/ and docs/errors.md are what this generator writes today. Headers show a reviewer what a change does to emitted code;
# they prove nothing about its correctness.
#
#   generated_is_current.sh <gauss-gen> <source folder>
set -euo pipefail

generator=$(readlink -f -- "$1")
cd -- "$2"

stale=0
expected=()
while read -r name; do
  [[ -n $name && $name != '#'* ]] || continue
  file=generated/$name/$name.hpp
  expected+=("$file")
  # Relative paths, from the root: the header states its command.
  if ! difference=$("$generator" "models/$name.yaml" -o - </dev/null |
    diff --label "$file" --label 'generated now' -u "$file" -); then
    head -40 <<<"$difference"
    stale=1
  fi
done <generated/models.txt

for file in generated/*/*; do
  [[ " ${expected[*]} " == *" $file "* ]] || { echo "$file: not in generated/models.txt"; stale=1; }
done
if ! difference=$("$generator" explain --format markdown |
  diff --label docs/errors.md --label 'generated now' -u docs/errors.md -); then
  head -40 <<<"$difference"
  stale=1
fi
size=$(du -sb generated | cut -f1)
((size < 500000)) || { echo "generated/ has $size bytes; 500000 is the limit"; stale=1; }

((stale == 0)) || { echo 'generated/ or docs/errors.md is stale: if the change is wanted, ./run regen and commit'; exit 1; }
echo "${#expected[@]} headers are current"
