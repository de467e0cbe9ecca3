// Usage: write_sample NAME FILE. Writes the emitted header of a sample unit, for the tests that compile it.

#include <fstream>
#include <iostream>

#include "emit/header.hpp"
#include "units.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const gausstest::Sample sample = gausstest::sample(argv[1]);
  std::ofstream file(argv[2], std::ios::binary);
  file << gaussgen::emit::emit_header(sample.graph, sample.unit);
  return file.flush() ? 0 : 3;
}
