// Whatever the text: the whole of `gauss-gen`, from the text to the header and the check of the initial state, ends with a
// header or with findings inside the text. Limits of time and memory are those of libFuzzer's options, see run_fuzzers.py.

#include <clocale>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <locale>

#include "mutation.hpp"
#include "pipeline.hpp"
#include "read_model.hpp"

namespace {

using namespace gaussgen;

/// A derivation may take its time; what must not is reading. So equations are made of small models only.
constexpr std::size_t k_largest_derived_text = 4096;
constexpr std::size_t k_most_speeds = 8;
constexpr std::size_t k_most_constraints = 8;

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "fuzz_model: " << what << "\n";
  std::abort();
}

void check(const support::Diagnostics& diagnostics, const support::Source& source, bool was_built) {
  require(was_built == !diagnostics.has_errors(), "no model without a finding, no error beside a model");
  for (const support::Diagnostic& finding : diagnostics.all()) {
    require(finding.span.begin <= source.text().size(), "a finding outside the text");
    require(finding.span.begin <= finding.span.end, "a finding that ends before it begins");
    require(!finding.message.empty() && !finding.hint.empty(), "a finding without words or a hint");
  }
  const std::string shown = support::render(diagnostics, source);
  require(shown.empty() == diagnostics.all().empty(), "findings are shown");
  require(shown.find('\0') == std::string::npos, "a message passes on control characters");
}

bool is_small(const model::Model& model, const support::Source& source) {
  const std::size_t speeds = model.coordinates.size() + 3 * model.orientations.size();
  return source.text().size() <= k_largest_derived_text && speeds <= k_most_speeds &&
         model.constraints.size() <= k_most_constraints;
}

void derive(support::Source& source) {
  PipelineOptions options;
  options.fold = source.text().size() % 2 == 1;
  options.assemble = source.text().size() % 3 == 1;
  support::Diagnostics diagnostics;
  const auto result = compile(source, options, diagnostics, {});
  check(diagnostics, source, result.has_value());
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::setlocale(LC_ALL, "C");
  std::locale::global(std::locale::classic());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  support::Source source("m.yaml", std::string(reinterpret_cast<const char*>(data), size));
  support::Diagnostics diagnostics;
  const auto model = read_model(source, diagnostics);
  check(diagnostics, source, model.has_value());
  if (model && is_small(*model, source)) derive(source);
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  fuzz::Mutation mutation({reinterpret_cast<const char*>(data), size}, seed);
  if (mutation.is_of_bytes()) return LLVMFuzzerMutate(data, size, most);
  return mutation.within_itself().copied_to(data, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size, const std::uint8_t* other,
                                                 std::size_t other_size, std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  fuzz::Mutation mutation({reinterpret_cast<const char*>(data), size}, seed);
  return mutation.with({reinterpret_cast<const char*>(other), other_size}).copied_to(out, most);
}
