// `count:` and `counts:`: a repeated entry is the same as its copies written by hand.
#include "building.hpp"
#include "catch_shim.hpp"
#include "dump_text.hpp"

using test::Built;
using test::k_header;
using test::written_out;

TEST_CASE("a repeated entry is each of its copies") {
  const std::string repeated = k_header +
                               "coordinates: {x_$i: {count: 3, unit: m, initial: 0.5*$i, about: of point $i}}\n"
                               "particles: {p_$i: {count: 3, mass: 2, position: [x_$i, 0, $(4 - i)]}}\n";
  const std::string by_hand = k_header +
                              "coordinates:\n  x_1: {unit: m, initial: 0.5*1, about: of point 1}\n"
                              "  x_2: {unit: m, initial: 0.5*2, about: of point 2}\n"
                              "  x_3: {unit: m, initial: 0.5*3, about: of point 3}\n"
                              "particles:\n  p_1: {mass: 2, position: [x_1, 0, 3]}\n"
                              "  p_2: {mass: 2, position: [x_2, 0, 2]}\n  p_3: {mass: 2, position: [x_3, 0, 1]}\n";
  CHECK(written_out(repeated) == written_out(by_hand));
}

TEST_CASE("an entry has up to three indices, the last of which runs first") {
  const std::string grid = k_header +
                           "coordinates: {x_$i_$j: {count: [2, 3]}}\nparticles: {p_$i_$j: {count: [2, 3], mass: 1, "
                           "position: [x_$i_$j, 0, 0]}}\n";
  const Built built(grid);
  REQUIRE(built.model);
  std::string names;
  for (const auto& coordinate : built.model->coordinates) names += coordinate.name.text + " ";
  CHECK(names == "x_1_1 x_1_2 x_1_3 x_2_1 x_2_2 x_2_3 ");
}

TEST_CASE("indices are worked out in whole numbers, and stay one factor when negative") {
  const auto value = [](const std::string& expression) {
    const Built built(k_header + "counts: {n: 2, twice: 2*n}\nparameters: {a: '" + expression + "'}\n" + test::k_x +
                      test::k_particle);
    return built.model ? test::show(built.model->parameters[0].value) : built.codes();
  };
  CHECK(value("$n") == "2");
  CHECK(value("$twice") == "4");
  CHECK(value("$(n - twice*3 + 1)") == "(- 9)");
  CHECK(value("7-$(1 - n)") == "(+ 7 (- (- 1)))");
  CHECK(value("$(0 - n)^2") == "(^ (- 2) 2)");
  CHECK(value("$(twice/n)$(7 % 4)") == "23");
  CHECK(value("$(+n)$(3 - +1)") == "22");
  CHECK(value("$(n/3)") == "E090");
  CHECK(value("$(n/0)") == "E090");
  CHECK(value("$(1000000*1000000)") == "E090");
  CHECK(value("$m") == "E090");
  CHECK(value("$(n") == "E090");
  CHECK(value("$((((((((((((((((((1))))))))))))))))))") == "E090");
}

TEST_CASE("copies may not make a model of more values than a file may have") {
  const auto codes = [](const std::string& count) {
    const std::string copies = ": {count: " + count + ", value: 1, about: a}\n";
    return Built(test::with("parameters:\n  a_$i" + copies + "  b_$i" + copies + "  c_$i" + copies + "  d_$i" + copies))
        .codes();
  };
  CHECK(codes("2000").empty());
  CHECK(codes("10000") == "E003");
}

TEST_CASE("a dollar in a text is a dollar where it is no index") {
  const Built built(k_header +
                    "about: costs $USD and $5\nparameters: {a_$i: {count: 1, value: 1, about: $i of $USD}}\n" +
                    test::k_x + test::k_particle);
  REQUIRE(built.model);
  CHECK(built.model->about == "costs $USD and $5");
  CHECK(built.model->parameters[0].about == "1 of $USD");
}

TEST_CASE("a count of 0 leaves nothing, and one beyond the limits is refused") {
  const auto codes = [](const std::string& count) {
    return Built(test::with("parameters: {a_$i: {count: " + count + ", value: 1}}\n")).codes();
  };
  CHECK(codes("0").empty());
  CHECK(codes("2").empty());
  for (const char* wrong : {"-1", "0.5", "many", "1e3", "10001", "[200, 200]", "[]", "[1, 1, 1, 1]", "{a: 1}"}) {
    INFO(wrong);
    CHECK_FALSE(codes(wrong).empty());
  }
}

TEST_CASE("copies without an index in their names are refused") {
  CHECK(Built(test::with("parameters: {a: {count: 2, value: 1}}\n")).codes() == "E006");
  CHECK(Built(test::with("parameters: {a_2: 1, a_$i: {count: 2, value: 1}}\n")).codes() == "E006");
}

TEST_CASE("a dollar in the words of an entry is a dollar, unless it is an index") {
  const Built built(test::with("parameters: {a_$i: {count: 1, value: 1, about: $5 each for $i}}\n"));
  REQUIRE(built.model);
  CHECK(built.model->parameters[0].about == "$5 each for 1");
}
