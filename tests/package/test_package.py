"""cmake --install, then find_package(gauss) in the project, with the model and the program, that the README shows."""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
from pathlib import Path

from installed import CMAKE, install, run

SOURCE = Path(os.environ["GAUSS_SOURCE_DIR"])
CONSUMER = SOURCE / "tests/package/consumer"
README = (SOURCE / "README.md").read_text(encoding="utf-8")
PENDULUM = textwrap.dedent(re.search(r"^    gauss: 1\n(?:    .*\n)+", README, re.M)[0])
PROJECT = re.search(r"^```cmake\n(.*?)^```", README, re.M | re.S)[1]
MAIN = re.search(r"^```cpp\n(.*?)^```", README, re.M | re.S)[1]
ANY_GENERATOR = "Ninja" if shutil.which("ninja") else "Unix Makefiles"

DROP = """gauss: 1
name: drop
parameters: {m: {value: 2, unit: kg}}
coordinates: {z: {unit: m, initial: 1, initial_rate: -4}}
particles: {ball: {mass: m, position: [0, 0, z]}}
effects:
  gravity: {default: on, parameters: {g: {value: 9.81, unit: m/s^2}}, forces: {weight: {uniform: [0, 0, -g]}}}
  air: {parameters: {c: {value: 0.5, unit: kg/s}}, forces: {air: {drag: ball, linear: c}}}
"""
FAR = "gauss: 1\nscene: far away\nmodel: drop.yaml\neffects: [gravity]\nparameters: {m: 3}\nduration: 2\n"
DROPPED = """#include <cstdio>
#include <vector>

#include "drop_variants.hpp"
#include "far_away.hpp"

int main() {
  for (const auto& model : gauss::drop_variants::variants) {
    gauss::simulate::ChosenModel ball(model);
    const bool has_drag = ball.set("c", 0.25);
    std::vector<double> state(ball.size()), rates(ball.size());
    if (ball.initial_state(state.data()) != gauss::Status::ok) return 1;
    if (ball.rhs(0, state.data(), rates.data()) != gauss::Status::ok) return 1;
    std::printf("%s %d %.8g\\n", model.name, has_drag, rates[1]);
  }
  std::printf("%g\\n", gauss::far_away::Parameters<double>().m);
}
"""
DROPS = """gauss: 1
scene: drops
model: drop.yaml
effects: [gravity]
parameters: {c: 0.25}
instances:
  near: {effects: [+air]}
  far: {}
  away: {parameters: {m: 7}, initial: {z: 30}}
"""
ALL_DROPS = """#include <cstdio>
#include <vector>

#include "drops_near.hpp"
#include "drops_variants.hpp"

int main() {
  using gauss::drops_variants::variants;
  for (const auto& one : gauss::drops_variants::instances) {
    gauss::simulate::ChosenModel ball(one);
    std::vector<double> state(ball.size()), rates(ball.size());
    if (ball.initial_state(state.data()) != gauss::Status::ok) return 1;
    if (ball.rhs(0, state.data(), rates.data()) != gauss::Status::ok) return 1;
    std::printf("%s %d %.8g\\n", one.name, static_cast<int>(one.model - variants), rates[1]);
  }
  namespace alone = gauss::drops_near;
  alone::State<double> state;
  alone::Derivative<double> rates;
  const auto prepared = alone::prepare(alone::Parameters<double>());
  if (alone::initial_state(prepared, state) != gauss::Status::ok) return 1;
  if (alone::rhs(0., state, alone::Inputs<double>(), prepared, rates) != gauss::Status::ok) return 1;
  std::printf("alone - %.8g\\n", rates.z_ddot());
}
"""

M, LENGTH, G, THETA = 1, 0.8, 9.81, 0.5  # as in the README
PRINTED = 1e-4  # relative: six digits


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="gauss package ")
        cls.addClassCleanup(folder.cleanup)
        cls.prefix = Path(folder.name) / "prefix"
        install(cls.prefix)

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gauss consumer ")
        self.addCleanup(folder.cleanup)
        self.source, self.build = Path(folder.name) / "source", Path(folder.name) / "build"
        shutil.copytree(CONSUMER, self.source)
        (self.source / "CMakeLists.txt").write_text(PROJECT + "include(turntable.cmake)\n", encoding="utf-8")
        (self.source / "main.cpp").write_text(MAIN, encoding="utf-8")
        (self.source / "pendulum.yaml").write_text(PENDULUM, encoding="utf-8")
        shutil.copy(SOURCE / "examples/turntable.cpp", self.source)
        shutil.copy(SOURCE / "models/sphere_turntable.yaml", self.source)

    def test_manual_completions_and_schema_are_installed(self):
        printed = {"man/man1/gauss-gen.1": ["--man"], "bash-completion/completions/gauss-gen": ["completion", "bash"],
                   "zsh/site-functions/_gauss-gen": ["completion", "zsh"],
                   "fish/vendor_completions.d/gauss-gen.fish": ["completion", "fish"], "gauss/gauss.schema.json": ["schema"]}
        for file, command in printed.items():
            text = (self.prefix / "share" / file).read_text(encoding="utf-8")
            self.assertEqual(text, run(self.prefix / "bin/gauss-gen", *command), file)

    def test_the_simulator_is_installed_with_its_pages(self):
        if not (self.prefix / "bin/gauss-sim").exists():
            self.skipTest("gauss-sim is not built")
        printed = {"man/man1/gauss-sim.1": ["--man"], "bash-completion/completions/gauss-sim": ["completion", "bash"],
                   "zsh/site-functions/_gauss-sim": ["completion", "zsh"], "fish/vendor_completions.d/gauss-sim.fish": ["completion", "fish"]}
        for file, command in printed.items():
            text = (self.prefix / "share" / file).read_text(encoding="utf-8")
            self.assertEqual(text, run(self.prefix / "bin/gauss-sim", *command), file)

    def test_links_of_installed_documents_lead_somewhere(self):
        pages = sorted((self.prefix / "share/doc/gauss").rglob("*.md"))
        self.assertGreater(len(pages), 10)
        for page in pages:
            text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for target in re.findall(r"\]\(([^)\s#]+)", re.sub(r"`[^`\n]*`", "", text)):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page}: {target}")

    def configure(self, generator):
        said = run(CMAKE, "-S", self.source, "-B", self.build, "-G", generator, f"-DCMAKE_PREFIX_PATH={self.prefix}",
                   f"-DCMAKE_CXX_COMPILER={os.environ['GAUSS_CXX']}")
        self.assertNotIn("No project() command is present", said)
        self.assertNotIn("No cmake_minimum_required command is present", said)
        return said

    def make(self, target="app"):
        return run(CMAKE, "--build", self.build, "--target", target)

    def edit(self, before, after, file="pendulum.yaml"):
        path = self.source / file
        text = path.read_text(encoding="utf-8")
        self.assertIn(before, text)
        path.write_text(text.replace(before, after), encoding="utf-8")

    def assert_pendulum(self, length):
        printed = run(self.build / "app")
        acceleration, force = (float(number) for number in re.findall(r"= (\S+)", printed))
        self.assertTrue(math.isclose(acceleration, -G / length * math.sin(THETA), rel_tol=PRINTED), printed)
        # At rest, the rod carries the part of the weight that points along it.
        self.assertTrue(math.isclose(force, -M * G * math.cos(THETA), rel_tol=PRINTED), printed)

    def assert_follows_the_model(self, generator):
        self.configure(generator)
        self.assertIn("Generating pendulum.hpp", self.make())
        self.assert_pendulum(LENGTH)
        self.assertNotIn("Generating", self.make())
        self.edit(f"value: {LENGTH}", f"value: {2 * LENGTH}")
        self.assertIn("Generating pendulum.hpp", self.make())
        self.assert_pendulum(2 * LENGTH)
        self.assert_unchanged_header_is_left_alone()
        self.assert_deleted_header_comes_back()

    def assert_unchanged_header_is_left_alone(self):
        (self.source / "pendulum.yaml").touch()
        said = self.make()
        self.assertIn("Generating pendulum.hpp", said)
        self.assertNotIn("Building", said)
        self.assertNotIn("Generating", self.make())

    def assert_deleted_header_comes_back(self):
        (self.build / "gauss/app/pendulum.hpp").unlink()
        self.assertIn("Generating pendulum.hpp", self.make())
        self.assert_pendulum(2 * LENGTH)
        self.assertNotIn("Generating", self.make())

    def test_the_program_of_the_readme_runs_and_follows_its_model_with_ninja(self):
        if not shutil.which("ninja"):
            self.skipTest("there is no ninja on this machine")
        self.assert_follows_the_model("Ninja")

    def test_the_program_of_the_readme_runs_and_follows_its_model_with_make(self):
        if not shutil.which("make"):
            self.skipTest("there is no make on this machine")
        self.assert_follows_the_model("Unix Makefiles")

    def test_a_model_may_get_another_name(self):
        self.configure(ANY_GENERATOR)
        self.make()
        self.edit("name: pendulum", "name: swing")
        self.edit("pendulum", "swing", file="main.cpp")
        self.assertIn("Generating swing.hpp", self.make())
        self.edit(f"value: {LENGTH}", f"value: {2 * LENGTH}")
        self.make()
        self.assert_pendulum(2 * LENGTH)

    def test_a_program_chooses_among_sets_of_effects_while_it_runs(self):
        (self.source / "drop.yaml").write_text(DROP, encoding="utf-8")
        (self.source / "far.yaml").write_text(FAR, encoding="utf-8")
        (self.source / "drop.cpp").write_text(DROPPED, encoding="utf-8")
        with (self.source / "CMakeLists.txt").open("a", encoding="utf-8") as file:
            file.write("add_executable(drop drop.cpp)\n"
                       "gauss_add_model(TARGET drop MODEL drop.yaml VARIANTS near=gravity,air far=gravity away=gravity)\n"
                       "gauss_add_model(TARGET drop SCENE far.yaml)\n"
                       "add_executable(alone alone.cpp)\ngauss_add_model(TARGET alone MODEL drop.yaml EFFECTS air)\n")
        (self.source / "alone.cpp").write_text('#include "drop.hpp"\nint main() { return gauss::drop::n_parameters; }\n')
        for generator in [ANY_GENERATOR] + (["Unix Makefiles"] if shutil.which("make") else []):
            shutil.rmtree(self.build, ignore_errors=True)
            self.configure(generator)
            self.make("drop")
            rows = [line.split() for line in run(self.build / "drop").splitlines()]
            # c v/m - g, and free fall; those that have no drag know no coefficient of it.
            self.assertEqual([row[:2] for row in rows[:3]], [["near", "1"], ["far", "0"], ["away", "0"]])
            self.assertAlmostEqual(float(rows[0][2]), 0.25 * 4 / 2 - 9.81, delta=1e-5)
            self.assertEqual({row[2] for row in rows[1:3]}, {"-9.81"})
            self.assertEqual(rows[3], ["3"])  # the mass, by the scene
            self.assertNotIn("Generating", self.make("drop"))
            self.edit("effects: [gravity]", "effects: [gravity, air]", file="far.yaml")
            self.assertIn("Generating", self.make("drop"))
            self.edit("effects: [gravity, air]", "effects: [gravity]", file="far.yaml")
            self.make("alone")
            self.assertEqual(subprocess.run([self.build / "alone"], check=False).returncode, 2)  # m and c, no g

    def test_a_program_goes_from_regime_to_regime_by_their_guards(self):
        for file in ("ball_on_shaker.yaml", "ball_on_shaker.cpp"):
            shutil.copy(SOURCE / "examples" / file, self.source)
        (self.source / "resting.cpp").write_text(
            '#include "ball_on_shaker.hpp"\nint main() { gauss::ball_on_shaker::Guards<double> guards{};\n'
            "  return gauss::ball_on_shaker::n_constraints + static_cast<int>(guards.table_opens); }\n")
        call = "gauss_add_model(TARGET resting MODEL ball_on_shaker.yaml REGIME table=closed OUTPUTS rhs guards)\n"
        with (self.source / "CMakeLists.txt").open("a", encoding="utf-8") as file:
            file.write("add_executable(shaker ball_on_shaker.cpp)\n"
                       "gauss_add_model(TARGET shaker MODEL ball_on_shaker.yaml REGIME ground VARIANTS flying= resting=table=closed\n"
                       f"                OUTPUTS rhs initial_state guards impact_system)\nadd_executable(resting resting.cpp)\n{call}")
        for generator in [ANY_GENERATOR] + (["Unix Makefiles"] if shutil.which("make") else []):
            shutil.rmtree(self.build, ignore_errors=True)
            self.configure(generator)
            self.make("shaker")
            # Compared with closed forms by tests/examples.
            run(sys.executable, "-B", SOURCE / "tests/examples/test_ball_on_shaker.py", self.build / "shaker")
            self.assertNotIn("Generating", self.make("shaker"))
            self.make("resting")
            self.assertEqual(subprocess.run([self.build / "resting"], check=False).returncode, 1)  # the table holds it
            self.assertNotIn("Generating", self.make("resting"))
        shutil.rmtree(self.build)
        self.edit(call, call.replace("table=closed", "closed"), file="CMakeLists.txt")
        self.assertIn("REGIME is modes of contacts, friction and links, as in floor=closed, or 'ground', and not 'closed'", self.configuring_fails())

    def test_bodies_of_one_scene_share_functions(self):
        (self.source / "drop.yaml").write_text(DROP, encoding="utf-8")
        (self.source / "drops.yaml").write_text(DROPS, encoding="utf-8")
        (self.source / "drops.cpp").write_text(ALL_DROPS, encoding="utf-8")
        with (self.source / "CMakeLists.txt").open("a", encoding="utf-8") as file:
            file.write("add_executable(drops drops.cpp)\ngauss_add_model(TARGET drops SCENE drops.yaml)\n"
                       "gauss_add_model(TARGET drops SCENE drops.yaml INSTANCE near)\n")
        for generator in [ANY_GENERATOR] + (["Unix Makefiles"] if shutil.which("make") else []):
            shutil.rmtree(self.build, ignore_errors=True)
            self.configure(generator)
            self.make("drops")
            rows = [line.split() for line in run(self.build / "drops").splitlines()]
            self.assertEqual([row[0] for row in rows], ["near", "far", "away", "alone"])
            self.assertEqual([row[1] for row in rows], ["0", "1", "1", "-"])
            # c v/m - g, and free fall.
            for row, expected in zip(rows, (0.25 * 4 / 2 - 9.81, -9.81, -9.81, 0.25 * 4 / 2 - 9.81)):
                self.assertAlmostEqual(float(row[2]), expected, delta=1e-5)
            self.assertNotIn("Generating", self.make("drops"))
            self.edit("far: {}", "far: {effects: [+air]}", file="drops.yaml")
            self.assertIn("Generating", self.make("drops"))
            self.assertEqual([line.split()[1] for line in run(self.build / "drops").splitlines()], ["0", "0", "1", "-"])
            self.edit("far: {effects: [+air]}", "far: {}", file="drops.yaml")

    def test_a_header_of_a_former_name_is_not_left_for_includes_to_find(self):
        self.configure(ANY_GENERATOR)
        self.make()
        self.edit("name: pendulum", "name: swing")
        self.assertIn("pendulum.hpp", self.fails(self.make))

    def assert_follows_the_files_of_submodels(self, generator):
        (self.source / "parts").mkdir()
        part = self.source / "parts/rod.yaml"
        part.write_text(f"gauss: 1\nname: rod\nparameters:\n  length: {{value: {LENGTH}, unit: m}}\n", encoding="utf-8")
        self.edit(f"value: {LENGTH}", "value: rod_length")
        with open(self.source / "pendulum.yaml", "a", encoding="utf-8") as model:
            model.write("submodels: {rod: {file: parts/rod.yaml}}\n")
        self.configure(generator)
        self.make()
        self.assert_pendulum(LENGTH)
        self.assertNotIn("Generating", self.make())
        part.write_text(part.read_text().replace(str(LENGTH), str(2 * LENGTH)), encoding="utf-8")
        self.assertIn("Generating pendulum.hpp", self.make())
        self.assert_pendulum(2 * LENGTH)
        self.assertNotIn("Generating", self.make())

    def test_the_files_of_submodels_are_followed_with_ninja(self):
        if not shutil.which("ninja"):
            self.skipTest("there is no ninja on this machine")
        self.assert_follows_the_files_of_submodels("Ninja")

    def test_the_files_of_submodels_are_followed_with_make(self):
        if not shutil.which("make"):
            self.skipTest("there is no make on this machine")
        self.assert_follows_the_files_of_submodels("Unix Makefiles")

    def test_a_model_may_be_one_flow_mapping(self):
        # The braces in words hide the name from all but the generator.
        flow = ('{gauss: 1, about: "a {", name: pendulum, parameters: {m: {value: 1, about: "}"}, l: 0.8, g: 9.81}, '
                "coordinates: {s: {held_at: l}, theta: {initial: 0.5}},\n"
                "particles: {bob: {mass: m, position: [s*sin(theta), 0, -s*cos(theta)]}}, forces: {gravity: {uniform: [0, 0, -g]}}}\n")
        (self.source / "flow.yaml").write_text(flow, encoding="utf-8")
        self.edit("MODEL pendulum.yaml", "MODEL flow.yaml", file="CMakeLists.txt")
        self.configure(ANY_GENERATOR)
        self.assertIn("Generating pendulum.hpp", self.make())
        self.assertNotIn("Generating", self.make())
        self.assert_pendulum(LENGTH)

    def fails(self, act, *arguments):
        """What CMake says, on one line, since it breaks lines where it likes."""
        try:
            act(*arguments)
        except AssertionError as error:
            return " ".join(str(error).split())
        return self.fail("it went well")

    def configuring_fails(self):
        return self.fails(self.configure, ANY_GENERATOR)

    def test_a_model_file_that_is_not_there_is_named_with_its_target(self):
        self.edit("MODEL pendulum.yaml", "MODEL nowhere.yaml", file="CMakeLists.txt")
        self.assertIn(f"gauss_add_model(app): there is no model file '{self.source}/nowhere.yaml'", self.configuring_fails())

    def test_a_model_file_that_cmake_cannot_name_is_refused(self):
        (self.source / "pendulum.yaml").rename(self.source / "pendu;lum.yaml")
        self.edit("MODEL pendulum.yaml", 'MODEL "pendu;lum.yaml"', file="CMakeLists.txt")
        self.assertIn(f"CMake takes paths apart at ';': rename '{self.source}/pendu;lum.yaml'", self.configuring_fails())

    def test_two_models_of_one_name_in_a_target_are_refused(self):
        shutil.copy(self.source / "pendulum.yaml", self.source / "other.yaml")
        call = "gauss_add_model(TARGET app MODEL pendulum.yaml)"
        self.edit(call, f"{call}\ngauss_add_model(TARGET app MODEL other.yaml)", file="CMakeLists.txt")
        said = self.configuring_fails()
        self.assertIn("are both called 'pendulum', so both would be pendulum.hpp; give one another `name:`", said)
        self.assertNotIn("add_custom_command", said)

    def test_a_model_that_is_added_twice_is_refused(self):
        call = "gauss_add_model(TARGET app MODEL pendulum.yaml)"
        self.edit(call, f"{call}\n{call}", file="CMakeLists.txt")
        self.assertIn(f"'{self.source}/pendulum.yaml' is added twice", self.configuring_fails())

    def test_a_target_of_another_directory_is_refused_with_a_way_that_works(self):
        (self.source / "sub").mkdir()
        inner = self.source / "sub/CMakeLists.txt"
        inner.write_text("gauss_add_model(TARGET app MODEL ../pendulum.yaml)\n", encoding="utf-8")
        self.edit("gauss_add_model(TARGET app MODEL pendulum.yaml)", "add_subdirectory(sub)", file="CMakeLists.txt")
        said = self.configuring_fails()
        self.assertIn(f"gauss_add_model(app): the target is one of another directory, '{self.source}'", said)
        way = re.search(r"this one: (add_library.*?\)), (gauss_add_model\(.*?) \.\.\.\), (target_link_libraries\(.*?\))", said)
        library, add, link = way.groups()
        inner.write_text(f"{library}\n{add} MODEL ../pendulum.yaml)\n{link}\n", encoding="utf-8")
        self.configure(ANY_GENERATOR)
        self.make()
        self.assert_pendulum(LENGTH)

    def test_a_target_that_is_imported_is_refused(self):
        self.edit("TARGET app", "TARGET gauss::gauss-gen", file="CMakeLists.txt")
        self.assertIn("gauss_add_model(gauss::gauss-gen): the target is imported, and not built here", self.configuring_fails())

    def test_keywords_without_a_value_are_refused(self):
        for more in ("OUTPUTS", "NAMESPACE ${unset}", "ROUTE"):
            (self.source / "CMakeLists.txt").write_text(PROJECT.replace(".yaml)", f".yaml {more})"), encoding="utf-8")
            self.assertIn(f"gauss_add_model: no value after {more.split()[0]}; a variable may be empty", self.configuring_fails())

    def test_a_moved_prefix_works_and_a_new_generator_there_makes_headers_anew(self):
        moved = self.source.parent / "moved"
        shutil.copytree(self.prefix, moved / "to here", symlinks=True)
        self.prefix = moved / "to here"
        for generator in filter(shutil.which, ("ninja", "make")):
            with self.subTest(generator):
                shutil.rmtree(self.build, ignore_errors=True)
                self.configure({"ninja": "Ninja", "make": "Unix Makefiles"}[generator])
                self.make()
                self.assert_pendulum(LENGTH)
                self.assertNotIn("Generating", self.make())
                time.sleep(0.1)  # times of files have ticks
                (self.prefix / "bin/gauss-gen").touch()
                said = self.make()
                self.assertIn("Generating pendulum.hpp", said)
                self.assertNotIn("Building", said)  # it says the same
                self.assertNotIn("Generating", self.make())
                self.assertIn(str(moved), (self.build / "CMakeCache.txt").read_text(encoding="utf-8"))

    @unittest.skipUnless(shutil.which("ninja"), "needs ninja")
    def test_gauss_may_be_a_directory_of_the_project_whose_generator_is_built_first(self):
        self.edit("find_package(gauss 0.1 REQUIRED)", f'add_subdirectory("{SOURCE}" gauss EXCLUDE_FROM_ALL)', file="CMakeLists.txt")
        self.prefix = "nowhere"
        self.configure("Ninja")
        # To build it takes minutes; these are the commands, in their order.
        steps = run("ninja", "-C", self.build, "-t", "commands", "app")
        places = [re.search(step, steps) for step in (" -o \\S*gauss-gen ", "gauss-gen\\S* [^\n]*pendulum.yaml", " -o app ")]
        self.assertTrue(all(places), steps)
        self.assertEqual(sorted(place.start() for place in places), [place.start() for place in places])

    def test_outputs_are_words_however_they_are_written(self):
        for words in ("rhs reactions initial_state", '"rhs;reactions;initial_state"', '"rhs reactions, initial_state"'):
            with self.subTest(words):
                (self.source / "CMakeLists.txt").write_text(PROJECT.replace(".yaml)", f".yaml OUTPUTS {words})"), encoding="utf-8")
                self.configure(ANY_GENERATOR)
                self.make()
                self.assertNotIn("mass_matrix(", (self.build / "gauss/app/pendulum.hpp").read_text(encoding="utf-8"))
                self.assert_pendulum(LENGTH)

    def test_sensitivities_are_chosen_as_outputs_are(self):
        (self.source / "CMakeLists.txt").write_text(
            PROJECT.replace(".yaml)", ".yaml OUTPUTS rhs initial_state reactions SENSITIVITIES m l)"), encoding="utf-8")
        checks = """
          gauss::pendulum::Sensitivities<double> sensitivities;
          if (gauss::pendulum::sensitivities(0.0, state, inputs, prepared, sensitivities) != gauss::Status::ok) return 2;
          // theta_ddot = -g/l sin(theta): by l it is -theta_ddot/l, by m nothing.
          if (std::fabs(sensitivities.l.rhs[1] + derivative.theta_ddot() / 0.8) > 1e-12) return 3;
          if (std::fabs(sensitivities.m.rhs[1]) > 1e-12) return 4;
        """
        main = "#include <cmath>\n" + MAIN.replace("  std::printf(", checks + "  std::printf(", 1)
        (self.source / "main.cpp").write_text(main, encoding="utf-8")
        self.configure(ANY_GENERATOR)
        self.make()
        self.assert_pendulum(LENGTH)

    def test_functions_compiled_in_a_file_of_their_own_are_those_of_the_program(self):
        for generator, program in (("Ninja", "ninja"), ("Unix Makefiles", "make")):
            if not shutil.which(program):
                continue
            for more in ("SPLIT", "SPLIT double float"):
                with self.subTest(generator=generator, more=more):
                    shutil.rmtree(self.build, ignore_errors=True)
                    (self.source / "CMakeLists.txt").write_text(PROJECT.replace(".yaml)", f".yaml {more})"), encoding="utf-8")
                    self.configure(generator)
                    self.make()
                    self.assert_pendulum(LENGTH)
                    text = (self.build / "gauss/app/pendulum.cpp").read_text(encoding="utf-8")
                    self.assertEqual("rhs(const float&" in text, "float" in more)
                    self.assertNotIn("Generating", self.make())
                    self.edit("value: 0.8", "value: 0.9")
                    self.make()
                    self.assert_pendulum(0.9)
                    self.edit("value: 0.9", "value: 0.8")

    def test_a_library_that_compiles_nothing_cannot_be_split(self):
        (self.source / "CMakeLists.txt").write_text(
            PROJECT + "add_library(models INTERFACE)\ngauss_add_model(TARGET models MODEL pendulum.yaml SPLIT)\n", encoding="utf-8")
        self.assertIn("gauss_add_model(models): with SPLIT there is a file to compile", " ".join(self.configuring_fails().split()))

    def compiled_by(self, more):
        """The commands that compile the program where its model is added with more words."""
        (self.source / "CMakeLists.txt").write_text(PROJECT.replace(".yaml)", f".yaml {more})"), encoding="utf-8")
        shutil.rmtree(self.build, ignore_errors=True)
        self.configure("Ninja")
        return run("ninja", "-C", self.build, "-t", "commands", "app")

    @unittest.skipUnless(shutil.which("ninja"), "needs ninja")
    def test_products_and_sums_are_rounded_one_by_one_unless_the_target_says_otherwise(self):
        for more, option in (("", "off"), ("CONTRACT on", "on"), ("CONTRACT fast", "fast")):
            with self.subTest(more):
                said = self.compiled_by(more)
                self.assertEqual(re.findall(r"-ffp-contract=(\w+)", said), [option], said)
                self.assertNotIn("GAUSS_ALLOW_FAST_MATH", said)

    def test_an_unknown_or_second_way_to_contract_is_refused(self):
        text = PROJECT.replace(".yaml)", ".yaml CONTRACT sometimes)")
        (self.source / "CMakeLists.txt").write_text(text, encoding="utf-8")
        self.assertIn("gauss_add_model(app): CONTRACT is 'off', 'on' or 'fast', and not 'sometimes'", self.configuring_fails())
        text = PROJECT + "gauss_add_model(TARGET app MODEL sphere_turntable.yaml CONTRACT fast)\n"
        (self.source / "CMakeLists.txt").write_text(text, encoding="utf-8")
        self.assertIn("CONTRACT is 'fast' here and 'off' for another model; a target is compiled in one way", self.configuring_fails())

    def test_fast_math_is_refused_unless_the_model_is_added_with_it(self):
        for more, is_allowed in (("", False), ("ALLOW_FAST_MATH", True)):
            with self.subTest(more):
                text = PROJECT.replace(".yaml)", f".yaml {more})") + "target_compile_options(app PRIVATE -ffast-math)\n"
                (self.source / "CMakeLists.txt").write_text(text, encoding="utf-8")
                shutil.rmtree(self.build, ignore_errors=True)
                self.configure(ANY_GENERATOR)
                if is_allowed:
                    self.make()
                    self.assert_pendulum(LENGTH)
                else:
                    self.assertIn("exact floating-point semantics", self.fails(self.make))

    def test_two_sizes_of_a_model_go_into_one_program(self):
        shutil.copy(SOURCE / "models/families/planar_chain_absolute.yaml", self.source / "chain.yaml")
        (self.source / "CMakeLists.txt").write_text(
            PROJECT + "gauss_add_model(TARGET app MODEL chain.yaml COUNTS n=2 OUTPUTS rhs)\n"
                      "gauss_add_model(TARGET app MODEL chain.yaml COUNTS n=3 OUTPUTS rhs)\n", encoding="utf-8")
        includes = "".join(f'#include "planar_chain_absolute_{n}.hpp"\n' for n in (2, 3))
        (self.source / "main.cpp").write_text(
            includes + MAIN + "static_assert(sizeof(gauss::planar_chain_absolute_2::State<double>) == 4 * sizeof(double));\n"
                              "static_assert(sizeof(gauss::planar_chain_absolute_3::State<double>) == 6 * sizeof(double));\n",
            encoding="utf-8")
        self.configure(ANY_GENERATOR)
        self.make()
        self.assert_pendulum(LENGTH)
        self.assertNotIn("Generating", self.make())

    def test_nothing_is_generated_twice_in_a_folder_that_depfiles_cannot_name(self):
        # With a '#', what CMake writes for make cannot be read by make.
        for generator, program, sign in (("Ninja", "ninja", "$"), ("Unix Makefiles", "make", "$"), ("Ninja", "ninja", "#"),
                                         ("Ninja", "ninja", "&")):
            if not shutil.which(program):
                continue
            with self.subTest(generator=generator, sign=sign):
                self.source = self.source.rename(self.source.parent / f"{program} {sign}o")
                self.build = self.source.parent / f"build {program}" if sign == "#" else self.source / f"build {program}"
                shutil.rmtree(self.build, ignore_errors=True)
                self.assertIn(f"in a folder with a '{sign}' in its name", " ".join(self.configure(generator).split()))
                self.assertIn("Generating pendulum.hpp", self.make())
                self.assertNotIn("Generating pendulum", self.make())

    def test_a_simulation_builds_with_the_installed_headers(self):
        self.configure(ANY_GENERATOR)
        self.make("turntable")
        self.assertIn("F_x [N]", run(self.build / "turntable"))


if __name__ == "__main__":
    unittest.main()
