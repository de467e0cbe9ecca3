#include "analysis/independent.hpp"

#include "catch_shim.hpp"

using namespace gaussgen::analysis;

namespace {

using Indices = std::vector<std::size_t>;

}  // namespace

TEST_CASE("of equal variables the last ones become dependent, others as they are preferred") {
  Matrix rows(1, 3);
  rows << 1, 1, 1;
  CHECK(choose_independent(rows, {1, 1, 1}).dependent == Indices{2});
  CHECK(choose_independent(rows, {1, 1e-3, 1e-3}).dependent == Indices{0});
}

TEST_CASE("no variable is dependent by what is nearly nothing") {
  Matrix rows(1, 2);
  rows << 1, 1e-6L;
  CHECK(choose_independent(rows, {1, 1}).dependent == Indices{0});
}

TEST_CASE("an equation that follows from others determines nothing") {
  Matrix rows(3, 4);
  rows << 1, 2, 0, 1, 0, 1, 1, 0, 2, 5, 1, 2;  // the third is twice the first and the second
  const Independent found = choose_independent(rows, {1, 1, 1, 1});
  CHECK(found.dependent.size() == 2);
  CHECK(found.rows.size() == 2);
  CHECK(found.independent.size() == 2);
}
