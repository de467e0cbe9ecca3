"""`gauss-gen init`: a model to begin with, whose physics is that of a pendulum."""

import json
import math
import re
import subprocess
import unittest

from gauss_gen import PROGRAM, Program


class Init(Program):
    def test_the_model_is_right_without_warnings(self):
        self.assertIn("wrote pendulum.yaml", self.ok("init"))
        self.assertEqual(self.files(), ["pendulum.yaml"])
        self.assertEqual(self.ok("pendulum.yaml", "--check"), "pendulum.yaml: ok\n")
        self.ok("pendulum.yaml")
        self.ok("derivation", "pendulum.yaml")

    def test_it_moves_like_a_pendulum(self):
        self.ok("init")
        document = json.loads(self.ok("evaluate", "pendulum.yaml", "--format=json", "--set", "dot(theta)=2"))
        m, l, g, theta, rate = 1, 0.8, 9.81, 0.5, 2
        self.assertEqual(document["status"], "ok")
        self.assertAlmostEqual(float(document["accelerations"]["theta_ddot"]["value"]), -g / l * math.sin(theta), 12)
        # The rod pulls inwards: weight along it, and what bends the path.
        self.assertAlmostEqual(float(document["reactions"]["s"]["value"]), -m * (g * math.cos(theta) + l * rate**2), 12)

    def test_its_name_is_that_of_the_file(self):
        self.ok("init", "double_pendulum")
        text = (self.folder / "double_pendulum.yaml").read_text(encoding="utf-8")
        self.assertIn("\nname: double_pendulum\n", text)
        self.assertNotIn("@", text)
        self.assertTrue(text.startswith("# yaml-language-server: $schema="))
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        for command in re.findall(r"(?m)^#   gauss-gen (.*?)  ", text):
            self.ok(*command.split())
        self.ok("init", "other.yaml")
        self.assertIn("other.yaml", self.files())

    def test_nothing_is_overwritten(self):
        for kind in ("file", "folder", "link"):
            path = self.folder / f"{kind}.yaml"
            if kind == "folder":
                path.mkdir()
            elif kind == "link":
                path.symlink_to("nowhere")
            else:
                path.write_text("mine")
            self.assertEqual(self.refused(3, "init", kind), f"gauss-gen: {kind}.yaml: is there already and stays as it is\n")
        self.assertEqual((self.folder / "file.yaml").read_text(), "mine")

    def test_what_is_no_name_is_refused_with_2(self):
        for name in ("a b", "a/b", "../a", "x: 1", ".yaml", "2nd", "a__b", "a_", "é", "name", "GAUSS_x", "a" * 65, "#", "-"):
            self.assertRegex(self.refused(2, "init", name), r"^gauss-gen: init: .*\n$", name)
        self.refused(2, "init", "a", "b")

    def test_a_full_disk_leaves_nothing(self):
        result = subprocess.run(["bash", "-c", 'ulimit -f 0; trap "" XFSZ; exec "$0" init', PROGRAM], cwd=self.folder,
                                capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, self.files()), (3, []), result.stderr)


if __name__ == "__main__":
    unittest.main()
