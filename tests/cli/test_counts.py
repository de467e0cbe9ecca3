"""--count: another size of a model than that of its file."""

import unittest

from gauss_gen import MODELS, Evaluate

CHAIN = MODELS / "families/planar_chain_relative.yaml"
TWO = """gauss: 1
name: row_$n
counts: {n: 2, all: 2*n}
parameters: {m: {value: 1, unit: kg}}
coordinates:
  x_$i: {count: all, unit: m, initial_rate: 1}
particles:
  p_$i: {count: all, mass: m, position: [x_$i, 0, 0]}
"""
REFUSED = {
    "--count n: a whole number from 0 to 10000 is needed, not '-1'": ["n=-1"],
    "--count n: a whole number from 0 to 10000 is needed, not '2.5'": ["n=2.5"],
    "--count n: a whole number from 0 to 10000 is needed, not '10001'": ["n=10001"],
    "--count n: a whole number from 0 to 10000 is needed, not ''": ["n="],
    "--count n: a whole number from 0 to 10000 is needed, not '2*n'": ["n=2*n"],
    "--count: 'n' is given twice": ["n=2", "n=2"],
    "--count: expected name=value, not 'n'": ["n"],
    "--count: a name is missing before '='": ["=3"],
    "--count: one value each": ["n=1,m=2"],
    "--count: the model has no count 'nn'; did you mean 'n'?": ["nn=2"],
    "--count: the model has no count 'x_1'; its counts are n": ["x_1=2"],
}


def options(counts):
    return [word for count in counts for word in ("--count", count)]


class Counts(Evaluate):
    def test_it_is_as_if_the_file_said_so(self):
        other = self.write("other.yaml", CHAIN.read_text(encoding="utf-8").replace("{n: 10}", "{n: 3}"))
        self.assertEqual(self.ok("evaluate", CHAIN, "--count", "n=3"), self.ok("evaluate", other))
        self.assertEqual(self.ok("derivation", CHAIN, "--count=n=3"), self.ok("derivation", other))
        self.assertEqual(self.ok(CHAIN, "--count", " n = 3 ", "--dump=artefacts"), self.ok(other, "--dump=artefacts"))

    def test_the_name_of_the_model_may_say_the_count(self):
        self.assertEqual(self.ok(CHAIN, "--count", "n=3", "--list-outputs"), "planar_chain_relative_3.hpp\n")
        self.ok(CHAIN, "--count", "n=3", "--outputs=rhs")
        self.ok(CHAIN, "--count", "n=2", "--outputs=rhs")
        self.assertEqual(self.files(), ["planar_chain_relative_2.hpp", "planar_chain_relative_3.hpp"])
        self.assertIn("namespace gauss::planar_chain_relative_3 {", (self.folder / "planar_chain_relative_3.hpp").read_text())

    def test_the_header_says_how_it_came_about(self):
        self.assertIn("// Command: gauss-gen planar_chain_relative.yaml --count n=3 --outputs=rhs --fold\n",
                      self.ok(CHAIN, "--count", "n=3", "--fold", "--outputs=rhs", "-o", "-"))

    def test_counts_that_follow_from_it_follow(self):
        self.assertEqual(len(self.document("-", "--count", "n=3", stdin=TWO)["accelerations"]), 6)
        self.assertEqual(len(self.document("-", "--count", "all=3", stdin=TWO)["accelerations"]), 3)

    def test_parts_keep_their_own(self):
        self.write("part.yaml", TWO.replace("row_$n", "part"))
        whole = "gauss: 1\nname: whole\ncounts: {n: 1}\nsubmodels:\n  part_$i: {count: n, file: part.yaml}\n"
        self.assertEqual(len(self.document("-", "--count", "n=2", stdin=whole)["accelerations"]), 8)

    def test_what_cannot_be_meant_is_refused(self):
        for answer, counts in REFUSED.items():
            for command in ([], ["evaluate"], ["derivation"]):
                self.assertIn("gauss-gen: " + answer, self.refused(2, *command, CHAIN, *options(counts)), counts)
        self.assertIn("no 'n' that could be changed", self.refused(2, MODELS / "four_bar.yaml", "--count", "n=2"))


if __name__ == "__main__":
    unittest.main()
