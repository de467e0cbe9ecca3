// print_hash SEED MODEL...: compiles models in a process in which GiNaC has already given out some symbols.
//
// GiNaC orders and signs what it holds by the serial numbers of symbols and by hash values that follow from them, so other
// serial numbers are another order in every sum. Prints one hash for all that comes out.

#include <ginac/ginac.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "lower/paper_route.hpp"
#include "model/build.hpp"
#include "paper.hpp"
#include "pipeline.hpp"
#include "support/files.hpp"

using namespace gaussgen;

namespace {

/// FNV-1a.
class Hash {
 public:
  void add(const std::string& text) {
    for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

/// Symbols that stay, and others whose memory is free again.
std::vector<GiNaC::ex> unused_symbols(std::mt19937& random) {
  std::vector<GiNaC::ex> kept;
  const auto count = static_cast<unsigned>(random() % 1000);
  for (unsigned i = 0; i < count; ++i) {
    const GiNaC::symbol symbol("unused" + std::to_string(random()));
    if (random() % 2 == 0) kept.push_back(GiNaC::sin(symbol) + GiNaC::pow(symbol, 3));
  }
  return kept;
}

support::Source source_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {path, std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()),
          support::read_regular_file};
}

bool has_paper_route(support::Source& source) {
  support::Diagnostics diagnostics;
  return lower::paper_route_obstacle(model::build_model(source, diagnostics).value()).empty();
}

void add_headers(support::Source& source, Hash& hash) {
  for (const Route route : {Route::emitted, Route::paper}) {
    if (route == Route::paper && !has_paper_route(source)) continue;
    for (const bool fold : {false, true}) {
      PipelineOptions options;
      options.route = route;
      options.fold = fold;
      support::Diagnostics diagnostics;
      const auto result = compile(source, options, diagnostics, {});
      if (!result) {
        std::cerr << support::render(diagnostics, source);
        std::exit(1);
      }
      hash.add(result->header);
    }
  }
}

void add_derivations(support::Source& source, Hash& hash) {
  support::Diagnostics diagnostics;
  const auto model = model::build_model(source, diagnostics);
  for (const bool latex : {false, true}) hash.add(derivation_text(*model, latex, diagnostics));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  std::mt19937 random(static_cast<std::mt19937::result_type>(std::strtoul(argv[1], nullptr, 10)));
  std::vector<GiNaC::ex> unused;
  Hash hash;
  for (int i = 2; i < argc; ++i) {
    for (GiNaC::ex& symbol : unused_symbols(random)) unused.push_back(std::move(symbol));
    support::Source source = source_of(argv[i]);
    add_headers(source, hash);
    if (has_paper_route(source)) add_derivations(source, hash);
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash.value()));
}
