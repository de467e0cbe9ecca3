#include <array>

#include "building.hpp"
#include "catch_shim.hpp"
#include "support/assert.hpp"

using namespace gaussgen;
using test::Built;
using test::with;

namespace {

const std::string k_orientation = "orientations: {o: {quaternion: [a, b, c, d], angular_velocity: [wx, wy, wz]}}\n";

/// A body on x with the inertia and the orientation that a test gives.
Built body(const std::string& rest) {
  return Built(test::k_header + test::k_x + k_orientation + "bodies: {ball: {mass: 1, position: [x, 0, 0], " + rest +
               "}}\n");
}

std::string names(const std::string& parameter) { return Built(with("parameters: {" + parameter + ": 1}\n")).codes(); }

}  // namespace

TEST_CASE("a model is read as it is written") {
  const Built ball(R"(
gauss: 1
name: ball
about: A ball inside a cylinder
parameters:
  m: {value: 0.5, unit: kg, about: mass}
  J: {value: 2/5*m*r^2, unit: kg*m^2}
  r: {value: 0.1, unit: m}
  R: {value: 0.6, unit: m}
  d: {value: 1, unit: N*m}
coordinates:
  rho: {unit: m, held_at: R - r, about: distance}
  chi: {unit: rad, initial: 1/2, initial_rate: 4}
  psi: {unit: rad, initial_rate_guess: 3}
bodies:
  ball: {mass: m, inertia: J, position: [rho*cos(chi), rho*sin(chi), 0], orientation: {euler: zxz, angles: [psi, 0, 0]}}
constraints:
  rolling: {velocity: (R - r)*dot(chi) + r*dot(psi), point: [R*cos(chi), R*sin(chi), 0], about: no slip}
forces:
  gravity: {uniform: [0, 0, -9.81]}
  motor: {generalized: {chi: -d, rho: 1}}
  spring: {potential: d*chi^2/2}
)");
  INFO(support::render(ball.diagnostics, ball.source));
  REQUIRE(ball.model);
  const model::Model& m = *ball.model;
  CHECK(m.about == "A ball inside a cylinder");
  CHECK(m.parameters[0].unit == "kg");
  CHECK(m.parameters[3].name.text == "R");
  CHECK(test::show(m.parameters[2].value) == "(* 2 (/ 5) m (^ r 2))");
  CHECK(test::show(*m.coordinates[0].held_at) == "(+ R (- r))");
  CHECK(test::show(*m.coordinates[1].initial) == "(* 1 (/ 2))");
  CHECK(test::show(*m.coordinates[1].initial_rate) == "4");
  CHECK(test::show(*m.coordinates[2].rate_guess) == "3");
  const model::Frame& frame = m.frames[m.bodies[0].frame];
  CHECK(test::show(frame.position[1]) == "(* rho (sin chi))");
  const auto& turns = std::get<model::Turns>(frame.attitude);
  CHECK(std::get<char>(turns[0].axis) == 'z');
  CHECK(std::get<char>(turns[1].axis) == 'x');
  CHECK(test::show(std::get<model::VelocityLaw>(m.constraints[0].law).phi) ==
        "(+ (* (+ R (- r)) (dot chi)) (* r (dot psi)))");
  CHECK(m.constraints[0].about == "no slip");
  CHECK(test::show((*m.constraints[0].point)[2]) == "0");
  CHECK(test::show(std::get<model::UniformField>(m.forces[0].law).field[2]) == "(- 981/100)");
  CHECK(std::get<model::GeneralizedForce>(m.forces[1].law).components[1].first.text == "rho");
  CHECK(test::show(std::get<model::Potential>(m.forces[2].law).energy) == "(* d (^ chi 2) (/ 2))");
}

TEST_CASE("initial angular velocities are a list, or a map that leaves some open") {
  const auto orientation = [](const std::string& initial) {
    return Built(test::k_header +
                 "orientations: {o: {quaternion: [a, b, c, d], angular_velocity: [u, v, w], frame: space, "
                 "initial_angular_velocity: " +
                 initial + "}}\nbodies: {b: {mass: 1, inertia: 1, position: [0, 0, 0], orientation: o}}\n");
  };
  const Built list = orientation("[1, 2, 3]");
  const Built map = orientation("{v: 2}");
  REQUIRE(list.model);
  REQUIRE(map.model);
  CHECK(list.model->orientations[0].axes == model::Axes::space);
  CHECK(test::show(*list.model->orientations[0].initial_angular_velocity[2]) == "3");
  CHECK_FALSE(map.model->orientations[0].initial_angular_velocity[0]);
  CHECK(test::show(*map.model->orientations[0].initial_angular_velocity[1]) == "2");
  CHECK(orientation("{x: 2}").codes() == "E010");
}

TEST_CASE("a coordinate may be a bare key") {
  CHECK(Built(test::k_header + "coordinates:\n  x:\n" + test::k_particle).codes().empty());
}

TEST_CASE("a free coordinate starts at zero, its rate is open") {
  const Built built(with(""));
  REQUIRE(built.model);
  CHECK(test::show(built.model->coordinates[0].start()) == "0");
  CHECK_FALSE(built.model->coordinates[0].initial_rate);
  CHECK_FALSE(built.model->coordinates[0].held_at);
}

TEST_CASE("the hash is FNV-1a of the bytes and the file is a base name") {
  const Built built(with(""), "some/folder/pendulum.yaml");
  REQUIRE(built.model);
  CHECK(built.model->file == "pendulum.yaml");
  CHECK(built.model->content_hash == "3ab3c7620061e730");
  CHECK(built.model->content_hash != Built(with("\n"), "pendulum.yaml").model->content_hash);
  CHECK(Built(with(""), "<stdin>").model->file == "<stdin>");
}

TEST_CASE("an orientation defaults to the body frame and no rotation") {
  const Built built = body("inertia: 1, orientation: o");
  REQUIRE(built.model);
  const model::Orientation& orientation = built.model->orientations[0];
  CHECK(orientation.axes == model::Axes::body);
  CHECK(test::show(orientation.initial[0]) == "1");
  CHECK(test::show(orientation.initial[3]) == "0");
  CHECK_FALSE(orientation.initial_angular_velocity[0]);
  CHECK(built.model->resolve("d").kind == model::SymbolKind::quaternion_component);
  CHECK(built.model->resolve("d").index == 3);
  CHECK(built.model->resolve("wz").index == 2);
}

TEST_CASE("inertia is one number, three, or a symmetric matrix") {
  CHECK(body("inertia: 2, orientation: o").model->bodies[0].inertia->shape == model::Inertia::Shape::isotropic);
  CHECK(body("inertia: [1, 2, 3], orientation: o").model->bodies[0].inertia->shape == model::Inertia::Shape::diagonal);
  const Built full = body("inertia: [[111, 4, 5], [4, 112, 6], [5, 6, 113]], orientation: o");
  REQUIRE(full.model);
  const std::array<const char*, 6> in_order{"111", "112", "113", "4", "5", "6"};
  for (std::size_t i = 0; i < 6; ++i) CHECK(test::show(full.model->bodies[0].inertia->entries[i]) == in_order[i]);
}

TEST_CASE("mirrored entries of an inertia matrix may differ in blanks but not in meaning") {
  CHECK(body("inertia: [[20, 2*3, 0], [2 * 3, 20, 0], [0, 0, 20]], orientation: o").codes().empty());
  CHECK(body("inertia: [[20, 2*3, 0], [6, 20, 0], [0, 0, 20]], orientation: o").codes() == "E057");
}

TEST_CASE("Euler sequences have three letters without equal neighbours") {
  for (const char* good : {"zxz", "xyz", "zyx", "xyx"}) {
    CHECK(Built(test::k_header + test::k_x +
                "bodies: {b: {mass: 1, inertia: 1, position: [0, 0, 0], orientation: {euler: " + good +
                ", angles: [x, 0, 0]}}}\n")
              .codes()
              .empty());
  }
  for (const char* bad : {"xxy", "zzz", "xy", "xyzx", "abc", "ZXZ"}) {
    CHECK(Built(test::k_header + test::k_x +
                "bodies: {b: {mass: 1, inertia: 1, position: [0, 0, 0], orientation: {euler: " + bad +
                ", angles: [x, 0, 0]}}}\n")
              .codes() == "E015");
  }
}

TEST_CASE("bodies and particles come in the order of the file") {
  const Built built(test::k_header + test::k_x +
                    "particles: {p: {mass: 1, position: [x, 0, 0]}}\nbodies: {b: {mass: 1, position: [x, 0, 0]}}\n");
  REQUIRE(built.model);
  CHECK(built.model->bodies[0].name.text == "p");
  CHECK(built.model->bodies[1].name.text == "b");
}

TEST_CASE("names follow one pattern") {
  CHECK(names("m1_a").empty());
  CHECK(names("class").empty());
  CHECK(names("a" + std::string(63, 'b')).empty());
  CHECK(names("a" + std::string(64, 'b')) == "E020");
  CHECK(names("_a") == "E020");
  CHECK(names("a_") == "E020");
  CHECK(names("a__b") == "E020");
  CHECK(names("1a") == "E020");
  CHECK(names("a-b") == "E020");
  for (const char* reserved : {"t", "pi", "I", "dot", "sin", "atan2"}) CHECK(names(reserved) == "E021");
}

TEST_CASE("all symbols share one namespace, with the names of rates") {
  CHECK(names("x") == "E022");
  CHECK(names("x_dot") == "E023");
  CHECK(body("inertia: 1, orientation: o, about: fine").codes().empty());
  CHECK(Built(test::k_header + "inputs: {a: 1}\n" + test::k_x + k_orientation +
              "bodies: {b: {mass: 1, inertia: 1, position: [x, 0, 0], orientation: o}}\n")
            .codes() == "E022");
}

TEST_CASE("a body, a force and a parameter may share a name") {
  CHECK(Built(with("parameters: {p: 1}\nforces: {p: {uniform: [0, 0, -p]}}\n")).codes().empty());
}

TEST_CASE("all findings of a file come at once") {
  CHECK(Built(test::k_header + "coordinates: {x: {units: m}}\nparticles: {p: {mass: , position: [x, y, 0]}}\nforces: "
                               "{f: {uniform: [1, 2]}}\n")
            .codes() == "E010 E039 E013 E031");
}

TEST_CASE("a slip in the name of a key is one finding") {
  CHECK(Built(test::k_header + test::k_x + "particles: {p: {masss: 1, position: [x, 0, 0]}}\n").codes() == "E010");
}

TEST_CASE("a faulty body does not make its coordinates idle") {
  CHECK(Built(test::k_header + test::k_x + "particles: {p: {mass: 1, position: [y, 0, 0]}}\n").codes() == "E031");
  CHECK(Built(test::k_header + test::k_x + "particles: {p: {mass: 1}}\n").codes() == "E011");
}

TEST_CASE("dependent speeds are free, different and one for each constraint") {
  const std::string constraints =
      "coordinates: {x: {}, y: {}, h: {held_at: 0}}\nparticles: {p: {mass: 1, position: [x, y, h]}}\nconstraints: {c: "
      "{velocity: dot(x)}}\n";
  const auto dependent = [&](const std::string& list) {
    return Built(test::k_header + constraints + "elimination: {dependent: " + list + "}\n").codes();
  };
  CHECK(dependent("[x]").empty());
  CHECK(dependent("[h]") == "E059");
  CHECK(dependent("[x, y]") == "E059");
  CHECK(dependent("[x, x]") == "E059 E059");
  CHECK(dependent("[z]") == "E024");
}

TEST_CASE("outputs are names of a list") {
  CHECK(Built(with("outputs: [energy, reactions]\n")).model->outputs.size() == 2);
  CHECK(Built(with("outputs: [energie]\n")).codes() == "E015");
  CHECK(Built(with("outputs: energy\n")).codes() == "E012");
}

TEST_CASE("a warning does not stop the model") {
  const Built built(test::k_header + "coordinates: {x: {}, h: {held_at: 1}}\n" + test::k_particle);
  CHECK(built.codes() == "W050");
  CHECK(built.model);
}

TEST_CASE("a held coordinate may move nothing but the end of a spring") {
  const std::string held = test::k_header + "coordinates: {x: {}, h: {held_at: 1}}\n" + test::k_particle;
  CHECK(Built(held + "forces: {s: {potential: (x - h)^2/2}}\n").codes().empty());
  CHECK(Built(held + "frames: {base: {position: [h, 0, 0]}}\nforces: {s: {spring: [base, p], stiffness: 2}}\n").codes().empty());
  CHECK(Built(held + "forces: {s: {generalized: {x: -x}}}\n").codes() == "W050");
}

TEST_CASE("an undeclared symbol is an internal error for later stages") {
  CHECK_THROWS_AS(Built(with("")).model->resolve("nope"), support::InternalError);
}
