// What runs without a compiler has the bits of what was compiled.

#include "sim/interpreter/same_bits.hpp"

namespace {

template <class S>
void compare_all() {
  REQUIRE(!headertest::compiled_models<S>().empty());
  for (const headertest::CompiledModel<S>& model : headertest::compiled_models<S>()) {
    INFO(model.model);
    std::size_t compared = 0;
    REQUIRE_NOTHROW(compared = headertest::Comparison<S>(model).run());
    CHECK(compared > 50);
  }
}

}  // namespace

TEST_CASE("every function of every model has the bits and the status of its compiled header") { compare_all<double>(); }

#if defined(GAUSS_SIM_FLOAT128)
TEST_CASE("in float128, too") { compare_all<__float128>(); }
#endif
TEST_CASE("in float and long double, too") {
  compare_all<float>();
  compare_all<long double>();
}
