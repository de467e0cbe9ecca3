// Tables: what is read, and the pieces that are made of it.

#include <cmath>

#include "building.hpp"
#include "catch_shim.hpp"
#include "model/points.hpp"

using namespace gaussgen;
using support::Rational;

namespace {

std::string codes(const std::string& table) {
  return test::Built(test::with("tables: {k: " + table + "}\nforces: {f: {generalized: {x: k(x)}}}\n")).codes();
}

model::Table table(const std::string& text) {
  const test::Built built(test::with("tables: {k: " + text + "}\nforces: {f: {generalized: {x: k(x)}}}\n"));
  INFO(support::render(built.diagnostics, built.source));
  REQUIRE(built.model);
  return built.model->tables.at(0);
}

double at(const model::Table& table, double x) { return support::value_at(*table.function, 0, x); }

}  // namespace

TEST_CASE("a table is linear and held outside, a spline goes straight on, unless it says otherwise") {
  const model::Table line = table("{of: [0, 1, 3], values: [1, 2, 0]}");
  CHECK(at(line, 0.5) == 1.5);
  CHECK(at(line, 2) == 1);
  CHECK(at(line, -5) == 1);
  CHECK(at(line, 50) == 0);
  const model::Table extended = table("{of: [0, 1, 3], values: [1, 2, 0], outside: extend}");
  CHECK(at(extended, -5) == -4);
  CHECK(at(extended, 5) == -2);
  // Natural spline through (0, 0), (1, 1), (2, 0): M = (0, -3, 0), slopes 3/2 and -3/2 at the ends.
  const model::Table curve = table("{of: [0, 1, 2], values: [0, 1, 0], kind: spline}");
  CHECK(at(curve, 0.5) == 0.6875);
  CHECK(at(curve, -1) == -1.5);
  CHECK(at(curve, 4) == -3);
  const model::Table held = table("{of: [0, 1, 2], values: [0, 1, 0], kind: spline, outside: hold}");
  CHECK(at(held, 0.5) == 0.6875);
  CHECK(at(held, -1) == 0);
  CHECK(std::isnan(at(curve, std::nan(""))));
}

TEST_CASE("a spline has two continuous derivatives, exactly, and no curvature outside") {
  const model::Table curve = table("{of: [-1, 0.5, 1, 7/3, 4], values: [2, 0, 1/7, -3, 0.25], kind: spline}");
  const auto& pieces = curve.function->pieces;
  REQUIRE(pieces.size() == 6);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    for (int order = 0; order <= 2; ++order) {
      support::Table left{"left", "", {pieces[k - 1]}, 0};
      CHECK(support::value_at(left, order, pieces[k].begin) ==
            support::value_at(*curve.function, order, pieces[k].begin));
    }
  }
  for (const auto* piece : {&pieces.front(), &pieces.back()}) {
    CHECK(piece->coefficients[2] == 0);
    CHECK(piece->coefficients[3] == 0);
  }
}

TEST_CASE("points are numbers and pi") {
  CHECK(codes("{of: [0, pi/2, pi], values: [0, 1/3, 2^-2]}").empty());
  CHECK(at(table("{of: [0, pi], values: [0, 1]}"), std::acos(-1.0) / 2) == Approx(0.5).epsilon(1e-15));
  CHECK(codes("{of: [0, sqrt(2)], values: [0, 1]}") == "E067");
  CHECK(codes("{of: [0, a], values: [0, 1]}") == "E031");
  CHECK(codes("{of: [0, x], values: [0, 1]}") == "E040");
}

TEST_CASE("points have to make a function") {
  CHECK(codes("{of: [0], values: [0]}") == "E067");
  CHECK(codes("{of: [0, 1], values: [0, 1], kind: spline}") == "E067");
  CHECK(codes("{of: [0, 1], values: [0, 1, 2]}") == "E067");
  CHECK(codes("{of: [0, 0], values: [0, 1]}") == "E067");
  CHECK(codes("{of: [0, 2, 1], values: [0, 1, 2]}") == "E067");
  CHECK(codes("{of: [0, 1e-300], values: [0, 1e300]}") == "E067");
  CHECK(codes("{of: [0, 1e999], values: [0, 1]}") == "E054");
  CHECK(codes("{of: [0, 1], values: [0, 1], kind: cubic}") == "E015");
  CHECK(codes("{of: [0, 1], values: [0, 1], outside: clamp}") == "E015");
  CHECK(codes("{values: [0, 1]}") == "E011");
  CHECK(codes("{of: [0, 1], value: [0, 1]}") == "E010");
}

TEST_CASE("a table has up to 256 points") {
  const auto text = [](int points) {
    std::string of, values;
    for (int i = 0; i < points; ++i) {
      of += (i == 0 ? "" : ", ") + std::to_string(i) + ".25";
      values += (i == 0 ? "" : ", ") + std::to_string((i * 37) % 101) + ".125";
    }
    return "{of: [" + of + "], values: [" + values + "], kind: spline}";
  };
  CHECK(codes(text(256)).empty());
  CHECK(codes(text(257)) == "E067");
}

TEST_CASE("a table shares its name with nothing and is called with one argument") {
  const auto codes_of = [](const std::string& more) { return test::Built(test::with(more)).codes(); };
  const std::string points = "{of: [0, 1], values: [0, 1]}";
  CHECK(codes_of("tables: {k: " + points + "}\nparameters: {k: 1}\nforces: {f: {generalized: {x: k(x)}}}\n") == "E022");
  CHECK(codes_of("tables: {max: " + points + "}\n") == "E021");
  CHECK(codes_of("tables: {x_dot: " + points + "}\nforces: {f: {generalized: {x: x_dot(x)}}}\n") == "E023");
  CHECK(codes_of("tables: {k: " + points + "}\nforces: {f: {generalized: {x: k}}}\n") == "E036");
  CHECK(codes_of("tables: {k: " + points + "}\nforces: {f: {generalized: {x: \"k(x, 1)\"}}}\n") == "E036");
  CHECK(codes_of("tables: {k: " + points + "}\n").empty());
  CHECK(codes_of("tables: {k: " + points +
                 ", h: {of: [0, k(1)], values: [0, 1]}}\nforces: {f: {generalized: {x: k(x)}}}\n")
            .find("E036") != std::string::npos);
}

TEST_CASE("a faulty table is reported once, whatever calls it") {
  CHECK(codes("{of: [1, 0], values: [0, 1]}") == "E067");
}
