"""What counts as the same output, and how a page's blocks become files."""

import os
import tempfile
import unittest
from pathlib import Path

import page


class Page(unittest.TestCase):
    def test_numbers_agree_to_their_last_printed_digit(self):
        self.assertTrue(page.matches(["a  1.234 N"], ["a 1.235 N"]))
        self.assertFalse(page.matches(["a 1.234 N"], ["a 1.237 N"]))
        self.assertTrue(page.matches(["1.0e-05"], ["1.1e-05"]))
        self.assertFalse(page.matches(["1.0e-05"], ["1.0e-04"]))
        self.assertFalse(page.matches(["-1.0"], ["1.0"]))

    def test_texts_and_whole_numbers_agree_exactly(self):
        self.assertFalse(page.matches(["line 3"], ["line 4"]))
        self.assertFalse(page.matches(["rope"], ["ropes"]))
        self.assertFalse(page.matches(["m.yaml:3:4: x"], ["m.yaml:3:5: x"]))

    def test_dots_stand_for_any_lines_and_nothing_else_does(self):
        self.assertTrue(page.matches(["a", "...", "z"], ["a", "b", "c", "z"]))
        self.assertFalse(page.matches(["a", "...", "z"], ["a", "b", "c"]))
        self.assertFalse(page.matches(["a"], ["a", "b"]))
        self.assertFalse(page.matches([], ["a"]))

    def test_a_command_that_fails_shows_an_error(self):
        text = "```console\n$ echo a; false\n...\n$ echo a\n...\n$ echo 'error: a'; false\nerror: a\n```\n"
        with tempfile.TemporaryDirectory() as folder:
            steps = page.follow(text, Path(folder), dict(os.environ))
            self.assertEqual([page.matches(shown, printed) for _, shown, printed in steps], [False, True, True])

    def test_a_section_takes_the_place_of_the_old_one(self):
        text = "a: 1\nb:\n  c: 2\n\n  d: 3\ne: 4\n"
        self.assertEqual(page.put_section(text, "b", "b:\n  x: 1\n"), "a: 1\nb:\n  x: 1\n\ne: 4\n")
        self.assertEqual(page.put_section(text, "f", "f: 5\n"), text + "\nf: 5\n")

    def test_commands_and_their_output(self):
        self.assertEqual(page.commands("$ a \\\n  b\nc\n$ d\n"), [("a \\\n  b", ["c"]), ("d", [])])


if __name__ == "__main__":
    unittest.main()
