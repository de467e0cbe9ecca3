// Whatever the text: reading it as an expression and as a unit ends with a value or with findings inside the text.

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "model/constant.hpp"
#include "model/dimension.hpp"
#include "model/parser.hpp"
#include "model/unit_parser.hpp"
#include "support/table.hpp"

namespace {

using namespace gaussgen;

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "fuzz_expression: " << what << "\n";
  std::abort();
}

void check(const support::Diagnostics& diagnostics, const std::string& text, bool was_read) {
  require(was_read == !diagnostics.has_errors(), "no value without a finding, no finding beside a value");
  for (const support::Diagnostic& finding : diagnostics.all()) {
    require(finding.span.begin <= finding.span.end && finding.span.begin <= text.size(), "a finding outside the text");
    require(!finding.message.empty(), "a finding without words");
  }
  require(support::render(diagnostics, support::Source("text", text)).empty() == diagnostics.all().empty(),
          "findings are shown");
}

/// 0 at 0, 1 at 1, and straight on.
std::shared_ptr<const support::Table> step() {
  support::Table table;
  table.name = "torque";
  table.pieces.push_back({0, {0, 1}});
  return std::make_shared<const support::Table>(table);
}

void read_expression(const std::string& text) {
  static const model::KnownTables k_tables{{"torque", step()}};
  support::Diagnostics diagnostics;
  const auto ast = model::parse_expression(spec::located(text), diagnostics, k_tables);
  check(diagnostics, text, ast.has_value());
  if (ast && model::growth(*ast) <= model::k_largest_growth) model::exact_value(*ast);
}

void read_unit(const std::string& text) {
  support::Diagnostics diagnostics;
  const auto dimension = model::parse_unit(spec::located(text), diagnostics);
  check(diagnostics, text, dimension.has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_expression(text);
  read_unit(text);
  return 0;
}
