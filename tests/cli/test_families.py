"""models/families/: each file is a model at small sizes, and what it computes follows from somewhere else."""

import math
import unittest

from gauss_gen import MODELS, Evaluate

FAMILIES = MODELS / "families"
SMALL = {"planar_chain_relative": "n=3", "planar_chain_absolute": "n=3", "planar_chain_maximal": "n=3", "planar_pendulum": "n=3", "spatial_chain": "n=2", "floating_chain": "n=1",
         "tree": "n=3", "n_four_bar": "n=1", "balls_in_cylinder": "n=2", "balls_in_cylinder_euler": "n=2", "road_train": "n=1",
         "quadruped": "legs=1", "humanoid": ""}
G = 9.81


class Families(Evaluate):
    def found(self, family, count, *arguments):
        counts = ["--count", count] if count else []
        document = self.document(FAMILIES / f"{family}.yaml", *counts, *arguments)
        self.assertEqual(document["status"], "ok", family)
        numbers = {}
        for group in ("state", "accelerations", "multipliers"):
            numbers.update({name: float(value["value"]) for name, value in document.get(group, {}).items()})
        return numbers

    def near(self, one, other, what=""):
        self.assertTrue(math.isclose(one, other, rel_tol=1e-12, abs_tol=1e-12), (one, other, what))

    def test_every_file_is_tested(self):
        self.assertEqual(sorted(SMALL), sorted(path.stem for path in FAMILIES.glob("*.yaml")))

    def test_they_have_no_mistakes_and_a_start_to_be_trusted(self):
        for family, count in SMALL.items():
            counts = ["--count", count] if count else []
            self.ok(FAMILIES / f"{family}.yaml", *counts, "--check")
            self.found(family, count)

    def test_the_planar_chains_are_one(self):
        relative = self.found("planar_chain_relative", "n=5")
        absolute = self.found("planar_chain_absolute", "n=5")
        total = 0
        for i in range(1, 6):
            total += relative[f"q_{i}_ddot"]
            self.near(total, absolute[f"q_{i}_ddot"], i)

    def test_pins_hold_rods_as_hinges_do(self):
        absolute = self.found("planar_chain_absolute", "n=4")
        start, x, z, x_dot, z_dot = [], 0, 0, 0, 0
        for i in range(1, 5):
            theta, omega, half = 0.1 * i, 0.2 * i, 0.35
            down = -half * math.sin(theta), -half * math.cos(theta)
            down_dot = omega * down[1], -omega * down[0]
            middle = {"theta": (theta, omega), "x": (x + down[0], x_dot + down_dot[0]), "z": (z + down[1], z_dot + down_dot[1])}
            for name, (value, rate) in middle.items():
                start += [f"--set={name}_{i}={value!r}", f"--set=dot({name}_{i})={rate!r}"]
            x, z = x + 2 * down[0], z + 2 * down[1]
            x_dot, z_dot = x_dot + 2 * down_dot[0], z_dot + 2 * down_dot[1]
        pinned = self.found("planar_chain_maximal", "n=4", *start)
        for i in range(1, 5):
            self.near(pinned[f"theta_{i}_ddot"], absolute[f"q_{i}_ddot"], i)

    def test_the_pendulum_satisfies_lagranges_equations(self):
        """Of point masses, in absolute angles: the sum over j of min(i, j)'s mass below, l_i l_j cos(t_i - t_j) t_j'' + l_i l_j sin(t_i - t_j) t_j'^2,
        and the weight of what hangs at i."""
        n = 4
        m, l = ([start + i / 100 for i in range(1, n + 1)] for start in (1, 0.5))
        found = self.found("planar_pendulum", f"n={n}")
        theta, omega, alpha = ([sum(found[f"q_{k}{suffix}"] for k in range(1, i + 1)) for i in range(1, n + 1)] for suffix in ("", "_dot", "_ddot"))
        for i in range(n):
            moment = sum(m[i:]) * G * l[i] * math.sin(theta[i])
            for j in range(n):
                below = sum(m[max(i, j):]) * l[i] * l[j]
                moment += below * (math.cos(theta[i] - theta[j]) * alpha[j] + math.sin(theta[i] - theta[j]) * omega[j]**2)
            self.near(moment, 0, i)

    def test_a_chain_in_a_plane_of_space_is_the_planar_one(self):
        start = [word for i in (1, 2, 3) for name, value in (("a", 0), ("b", 0.1)) for word in
                 (f"--set={name}_{i}={value}", f"--set=dot({name}_{i})={2 * value}")]
        spatial = self.found("spatial_chain", "n=3", *start)
        planar = self.found("planar_chain_relative", "n=3")
        for i in (1, 2, 3):
            self.near(spatial[f"b_{i}_ddot"], planar[f"q_{i}_ddot"], i)
            self.near(spatial[f"a_{i}_ddot"], 0, i)

    def test_one_rod_of_the_tree_is_a_pendulum(self):
        one = self.found("tree", "n=1")
        self.near(one["q_1_ddot"], -1.5 * G / 0.7 * math.sin(one["q_1"]))

    def test_a_pendulum_on_a_stiff_spring_is_that_in_polar_coordinates(self):
        s, theta, v, w = 1.001, 0.7, 0.02, -0.4
        document = self.document(MODELS / "spring_pendulum.yaml", f"--set=s={s}", f"--set=theta={theta}", f"--set=dot(s)={v}", f"--set=dot(theta)={w}")
        found = {name: float(value["value"]) for name, value in document["accelerations"].items()}
        self.near(found["s_ddot"], s * w**2 + G * math.cos(theta) - 1e7 * (s - 1) - 1e4 * v)
        self.near(found["theta_ddot"], -(G * math.sin(theta) + 2 * v * w) / s)

    def test_two_four_bars_are_the_problem_of_the_library(self):
        document = self.document(MODELS / "iftomm_a02.yaml")
        found = self.found("n_four_bar", "n=2")
        for name, value in document["accelerations"].items():
            self.near(float(value["value"]), found[name], name)

    def assert_balls(self, found, spin_about_the_radius):
        m, r, J = 0.5, 0.1, 0.4 * 0.5 * 0.1**2
        for i in (1, 2):
            friction = (G - r * found[f"chi_{i}_dot"] * spin_about_the_radius(i)) / (1 / m + r * r / J)
            self.near(found[f"zeta_{i}_ddot"], friction / m - G, i)
            self.near(found[f"chi_{i}_ddot"], 0, i)

    def test_balls_climb_as_the_paper_has_it(self):
        self.assert_balls(self.found("balls_in_cylinder", "n=2"), lambda i: 2)
        euler = self.found("balls_in_cylinder_euler", "n=2")
        self.assert_balls(euler, lambda i: (
            euler[f"theta_{i}_dot"] * math.cos(euler[f"psi_{i}"] - euler[f"chi_{i}"]) +
            euler[f"phi_{i}_dot"] * math.sin(euler[f"theta_{i}"]) * math.sin(euler[f"psi_{i}"] - euler[f"chi_{i}"])))

    def test_what_nothing_holds_falls_with_all_its_limbs(self):
        for family, count in (("quadruped", "legs=2"), ("humanoid", "")):
            falling, floating = self.found(family, count), self.found(family, count, "--set", "g=0")
            for name in falling:
                if name.endswith("_ddot") or name.endswith("_dot"):
                    self.assertTrue(math.isclose(falling[name] + G * (name == "z_ddot"), floating[name], rel_tol=1e-9,
                                                 abs_tol=1e-9), name)

    def test_wheels_of_the_road_train_roll_where_it_goes(self):
        found = self.found("road_train", "n=1")
        a, h, d, r, b = 2.6, 0.5, 2.2, 0.32, 0.75
        speed = found["left_turn_0_dot"] * r / (1 - b * math.tan(found["steer"]) / a)
        turn = speed * math.tan(found["steer"]) / a
        self.near(found["x_dot"], speed * math.cos(found["yaw"]))
        self.near(found["yaw_dot"], turn)
        bend = found["hitch_1"]
        sideways = -speed * math.sin(bend) - h * turn * math.cos(bend)
        along = speed * math.cos(bend) - h * turn * math.sin(bend)
        self.near(found["hitch_1_dot"], sideways / d - turn)
        self.near(found["left_turn_1_dot"], (along - b * sideways / d) / r)


if __name__ == "__main__":
    unittest.main()
