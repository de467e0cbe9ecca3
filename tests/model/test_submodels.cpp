// `submodels:` a part from another file is the same as its sections written in place, with its name in front of theirs.
#include <map>

#include "catch_shim.hpp"
#include "dump_text.hpp"

using test::Built;
using test::k_header;

namespace {

using Files = std::map<std::string, std::string>;

std::string with_files(const Files& files, const std::string& name = "m.yaml") {
  const auto read = [&](const std::string& path, std::string& why) {
    const auto found = files.find(path);
    why = "No such file or directory";
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  const Built built(gaussgen::support::Source(name, files.at(name), read));
  return built.model ? test::written_out(built) : built.codes();
}

const std::string k_leg = k_header +
                          "parameters: {m: 2, l: 1, J: m*l^2/12}\n"
                          "inputs: {motor: 3}\n"
                          "tables: {curve: {of: [0, 1e0], values: [1, 2]}}\n"
                          "joints: {hip: {type: spherical, child: bone}}\n"
                          "bodies: {bone: {mass: m, inertia: [J, J, 0], centre: [0, 0, -l/2]}}\n"
                          "points: {foot: {on: bone, at: [0, 0, -l]}}\n"
                          "constraints: {stays: {equation: foot.z - sin(t)*curve(l)*1e0 + hip_e0*0}}\n"
                          "forces: {push: {torque: [motor*cos(pi), 0, 0], on: bone, from: space}}\n";

}  // namespace

TEST_CASE("names of a submodel get its name in front, and those that mean the same everywhere stay") {
  const std::string by_hand =
      k_header +
      "parameters: {left_m: 2, left_l: 1, left_J: left_m*left_l^2/12}\n"
      "inputs: {left_motor: 3}\n"
      "tables: {left_curve: {of: [0, 1e0], values: [1, 2]}}\n"
      "joints: {left_hip: {type: spherical, child: left_bone}}\n"
      "bodies: {left_bone: {mass: left_m, inertia: [left_J, left_J, 0], centre: [0, 0, -left_l/2]}}\n"
      "points: {left_foot: {on: left_bone, at: [0, 0, -left_l]}}\n"
      "constraints: {left_stays: {equation: left_foot.z - sin(t)*left_curve(left_l)*1e0 + left_hip_e0*0}}\n"
      "forces: {left_push: {torque: [left_motor*cos(pi), 0, 0], on: left_bone, from: space}}\n";
  CHECK(with_files({{"m.yaml", k_header + "submodels: {left: {file: leg.yaml}}\n"}, {"leg.yaml", k_leg}}) ==
        test::written_out(by_hand));
}

TEST_CASE("a submodel takes values of its parameters from the model around it, and stands on its frame") {
  const Files files{{"m.yaml", k_header + "parameters: {a: 3}\nframes: {trunk: {position: [0, 0, a]}}\n"
                                          "submodels: {left: {file: leg.yaml, on: trunk, parameters: {l: 2*a}}}\n"},
                    {"leg.yaml", k_leg}};
  const std::string text = with_files(files);
  CHECK(text.find("left_l = 2*a") != std::string::npos);
  CHECK(text.find("left_hip: trunk carries left_bone") != std::string::npos);
}

TEST_CASE(
    "what stands in space in a submodel stands on its frame: frames without a word, points, and what names space") {
  const std::string part =
      k_header +
      "frames:\n  fork:\n  arm: {parent: space, position: [0, 0, 1]}\n"
      "points: {tip: {at: [0, 1, 0]}, far: {on: space, at: [0, 2, 0]}, own: {on: arm, at: [0, 3, 0]}}\n"
      "joints: {turn: {type: revolute, child: wheel}}\nbodies: {wheel: {mass: 1, inertia: 1}}\n"
      "outputs: [rhs]\nelimination: {dependent: [turn]}\nabout: of the part\n";
  const std::string around = k_header + "frames: {trunk: {position: [0, 0, 3]}}\n";
  const std::string by_hand =
      k_header +
      "frames:\n  trunk: {position: [0, 0, 3]}\n  a_fork: {parent: trunk}\n  a_arm: {parent: trunk, position: [0, 0, "
      "1]}\n"
      "points: {a_tip: {on: trunk, at: [0, 1, 0]}, a_far: {on: trunk, at: [0, 2, 0]}, a_own: {on: a_arm, at: [0, 3, "
      "0]}}\n"
      "joints: {a_turn: {type: revolute, parent: trunk, child: a_wheel}}\nbodies: {a_wheel: {mass: 1, inertia: 1}}\n";
  CHECK(with_files({{"m.yaml", around + "submodels: {a: {file: p.yaml, on: trunk}}\n"}, {"p.yaml", part}}) ==
        test::written_out(by_hand));
}

TEST_CASE("entries are left out of every section, and each has to be in one") {
  const auto codes = [](const std::string& names) {
    return with_files({{"m.yaml", k_header + "submodels: {left: {file: leg.yaml, without: [" + names + "]}}\n"},
                       {"leg.yaml", k_leg}});
  };
  const std::string text = codes("motor, push");
  CHECK(text.find("motor") == std::string::npos);
  CHECK(text.find("left_bone") != std::string::npos);
  CHECK(codes("push, pull") == "E092");
}

TEST_CASE("paths are relative to the file that names them, and submodels have submodels") {
  const Files files{{"d/m.yaml", k_header + "submodels: {a: {file: e/b.yaml}}\n"},
                    {"d/e/b.yaml", k_header + "submodels: {b: {file: c.yaml}}\n"},
                    {"d/e/c.yaml", k_header + test::k_x + test::k_particle}};
  CHECK(with_files(files, "d/m.yaml").find("a_b_x: ") != std::string::npos);
}

TEST_CASE("a file is a submodel as often as it is named") {
  const Files files{{"m.yaml", k_header + "submodels: {s_$i: {count: 3, file: p.yaml}}\n"},
                    {"p.yaml", k_header + test::k_x + test::k_particle}};
  const std::string text = with_files(files);
  for (const char* name : {"s_1_x: ", "s_2_x: ", "s_3_p: "}) CHECK(text.find(name) != std::string::npos);
}

TEST_CASE("files that hold each other are refused") {
  CHECK(with_files({{"m.yaml", k_header + "submodels: {a: {file: m.yaml}}\n"}}) == "E091");
  CHECK(with_files({{"m.yaml", k_header + "submodels: {a: {file: b.yaml}}\n"},
                    {"b.yaml", k_header + "submodels: {a: {file: c.yaml}}\n"},
                    {"c.yaml", k_header + "submodels: {a: {file: b.yaml}}\n"}}) == "E091");
}

TEST_CASE("a mistake in the file of a submodel is shown there") {
  Files files{{"m.yaml", k_header + "submodels: {s_$i: {count: 2, file: p.yaml}}\n"},
              {"p.yaml", k_header + test::k_x + "particles: {p: {mass: mm, position: [x, 0, 0]}}\n"}};
  const auto read = [&](const std::string& path, std::string&) { return std::optional(files.at(path)); };
  const Built built(gaussgen::support::Source("m.yaml", files.at("m.yaml"), read));
  const std::string text = gaussgen::support::render(built.diagnostics, built.source);
  CHECK(text.find("p.yaml:4:23: error[E031]: unknown name 'mm'") == 0);
  CHECK(text.find("E031", text.find("E031") + 1) == std::string::npos);
  CHECK(text.find("\n 4 | particles: {p: {mass: mm, ") != std::string::npos);
}

TEST_CASE("a model that names no submodels reads no other file") {
  const auto read = [](const std::string&, std::string&) -> std::optional<std::string> {
    throw std::runtime_error("read");
  };
  const Built built(gaussgen::support::Source("m.yaml", test::with(""), read));
  CHECK(built.model);
}

TEST_CASE("a source whose submodels have been read can be read once more") {
  const Files files{{"m.yaml", k_header + "submodels: {a: {file: p.yaml}}\n"},
                    {"p.yaml", k_header + test::k_x + test::k_particle}};
  const auto read = [&](const std::string& path, std::string&) { return std::optional(files.at(path)); };
  gaussgen::support::Source source("m.yaml", files.at("m.yaml"), read);
  gaussgen::support::Diagnostics diagnostics;
  const auto first = gaussgen::model::build_model(source, diagnostics);
  const auto second = gaussgen::model::build_model(source, diagnostics);
  REQUIRE(first);
  REQUIRE(second);
  CHECK(first->content_hash == second->content_hash);
}

TEST_CASE("submodels of submodels of submodels, sixty each, are refused") {
  const auto sixty = [](const std::string& file) {
    return k_header + "submodels: {s_$i: {count: 60, file: " + file + "}}\n";
  };
  const std::string codes = with_files({{"m.yaml", sixty("a.yaml")},
                                        {"a.yaml", sixty("b.yaml")},
                                        {"b.yaml", sixty("c.yaml")},
                                        {"c.yaml", k_header + test::k_x + test::k_particle}});
  CHECK(codes == "E003");
}
