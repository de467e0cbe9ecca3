// The table of operations on top of a header is what its functions do.

#include <fstream>
#include <sstream>
#include <string>

#include "catch_shim.hpp"
#include "counted.hpp"
#include "headers_plain/chaplygin_sleigh.hpp"
#include "headers_plain/skew_nonholonomic.hpp"
#include "headers_plain/sphere_in_cylinder.hpp"
#include "headers_plain/sphere_in_cylinder_quaternion.hpp"
#include "sphere/operations.hpp"
#include "tested_model.hpp"

GAUSS_MAKE_TESTED(gauss::chaplygin_sleigh)
GAUSS_MAKE_TESTED(gauss::counted)
GAUSS_MAKE_TESTED(gauss::skew_nonholonomic)
GAUSS_MAKE_TESTED(gauss::sphere_in_cylinder)
GAUSS_MAKE_TESTED(gauss::sphere_in_cylinder_quaternion)

namespace {

using sphere::Counted;
using sphere::Operations;

/// The row of `function` in the table of a header.
Operations stated(const std::string& model, const std::string& function) {
  std::ifstream file(std::string(GAUSS_HEADERS) +
                     (model == "counted" ? "/test_headers_operations/" : "/headers_plain/") + model + ".hpp");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string slashes, name;
    Operations row;
    int square_roots = 0;
    if (words >> slashes >> name && slashes == "//" && name == function &&
        words >> row.additions >> row.multiplications >> row.divisions >> square_roots >> row.functions) {
      row.functions += square_roots;
      return row;
    }
  }
  FAIL("no row for " << function << " in " << model);
  return {};
}

template <class Call>
Operations done(const Call& call) {
  Counted::tally() = {};
  call();
  return Counted::tally();
}

void check(const std::string& model, const std::string& function, const Operations& found) {
  const Operations expected = stated(model, function);
  INFO(model << ": " << function);
  CHECK(found.additions == expected.additions);
  CHECK(found.multiplications == expected.multiplications);
  CHECK(found.divisions == expected.divisions);
  CHECK(found.functions == expected.functions);
}

template <class M>
void counts_are_stated() {
  typename M::template Parameters<Counted> parameters;
  for (auto member = M::template parameters<Counted>(); *member != nullptr; ++member) {
    parameters.**member = (parameters.**member).as_given();
  }
  const auto prepared = prepare(parameters);
  typename M::template State<Counted> state;
  for (Counted& value : state.values) value = Counted(0.7).as_given();
  const Counted t = Counted(0).as_given();
  const typename M::template Inputs<Counted> inputs{};
  typename M::template Derivative<Counted> derivative{};
  typename M::template ReactionsOrNone<Counted> found{};
  typename M::template State<Counted> projected{};
  check(M::name, "rhs", done([&] { rhs(t, state, inputs, prepared, derivative); }));
  check(M::name, "reactions", done([&] { reactions(t, state, inputs, prepared, found); }));
  check(M::name, "project", done([&] { project(t, state, prepared, projected); }));
  check(M::name, "prepare", done([&] { (void)prepare(parameters); }));
}

}  // namespace

TEST_CASE("every operation of a function is in the table of its header, and no other") {
  counts_are_stated<gauss::chaplygin_sleigh::Tested>();
  counts_are_stated<gauss::counted::Tested>();
  counts_are_stated<gauss::skew_nonholonomic::Tested>();
  counts_are_stated<gauss::sphere_in_cylinder::Tested>();
  counts_are_stated<gauss::sphere_in_cylinder_quaternion::Tested>();
}
