#include "catch_shim.hpp"
#include "gauss/oracle/bare_models.hpp"
#include "gauss/oracle/evaluation.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_metric_tolerance = 1e-15;

Mat block(const Mat& full, std::size_t first, std::size_t last) {
  Mat result;
  for (std::size_t i = first; i < last; ++i) {
    result.emplace_back(full[i].begin() + static_cast<long>(first), full[i].begin() + static_cast<long>(last));
  }
  return result;
}

double largest_deviation(const Mat& a, const Mat& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, deviation(a[i][j], b[i][j]));
  }
  return largest;
}

}  // namespace

TEST_CASE("the metric is the second derivative of Gauss's function by the accelerations", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(1);
    const auto paper = nonholonomic::build_paper_system(c.model);
    PaperNumbers number(c.model, *paper, c.values);
    INFO(model.name);
    CHECK(largest_deviation(number(paper->system.metric.G), probe(c.bare).G) < k_metric_tolerance);
  }
}

TEST_CASE("g^αβ inverts the free block, G^AB the whole, and э^ij is the inverse of the Schur complement", "[gauss]") {
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(2);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const gauss::Metric& metric = paper->system.metric;
    PaperNumbers number(c.model, *paper, c.values);
    const Mat G = probe(c.bare).G;
    const std::size_t n = c.bare.free_count;
    INFO(model.name);
    CHECK(largest_deviation(number(metric.g_up), inverse(block(G, 0, n))) < k_metric_tolerance);
    CHECK(largest_deviation(number(metric.G_up), inverse(G)) < k_metric_tolerance);
    CHECK(largest_deviation(number(metric.E_xx_up), block(inverse(G), n, G.size())) < k_metric_tolerance);
    CHECK(largest_deviation(number(metric.E_xx), inverse(block(inverse(G), n, G.size()))) < k_metric_tolerance);
  }
}

TEST_CASE("in a skew chart the block G_ij is not э_ij, and the free block of the inverse is not g^αβ", "[gauss]") {
  for (const char* name : {"skew_chart", "skew_nonholonomic"}) {
    const Case c = case_of(name, 3);
    const auto paper = nonholonomic::build_paper_system(c.model);
    const gauss::Metric& metric = paper->system.metric;
    PaperNumbers number(c.model, *paper, c.values);
    INFO(name);
    CHECK(largest_deviation(number(metric.G_xx), number(metric.E_xx)) > 0.1);
    CHECK(largest_deviation(block(number(metric.G_up), 0, c.bare.free_count), number(metric.g_up)) > 0.1);
  }
}

TEST_CASE("the ball's coordinates are not coupled, so э_ij is G_ij there", "[gauss]") {
  const Case c = case_of("sphere_in_cylinder", 4);
  const auto paper = nonholonomic::build_paper_system(c.model);
  for (const auto& row : paper->system.metric.G_qx) {
    for (const GiNaC::ex& entry : row) CHECK(entry.is_zero());
  }
}
