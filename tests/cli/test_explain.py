"""`gauss-gen explain`: a page for every code, and every example in it gives that code and, put right, none."""

import re
import unittest

from gauss_gen import SOURCE, Program

DECLARED = re.compile(r'ErrorCode k_\w+\{\s*"([EW]\d{3})",\s*"([^"]+)"')


def unescaped(line):
    return re.sub(rb"\\x([0-9A-F]{2})", lambda match: bytes([int(match[1], 16)]), line.encode()) + b"\n"


def versions(lines):
    """The example as it is wrong and as it is right."""
    return [b"".join(unescaped(line[2:]) for line in lines if line[0] in marks) for marks in (" -", " +")]


class Explain(Program):
    def setUp(self):
        super().setUp()
        text = (SOURCE / "generator/support/error_codes.hpp").read_text(encoding="utf-8")
        self.codes = dict(DECLARED.findall(text))

    def check_example(self, code, lines, options):
        """What is said of the wrong version; names of files apart."""
        wrong, right = versions(lines)
        if not (self.folder / "pendulum.yaml").exists():
            self.ok("init")
        self.assertNotEqual(wrong, right, code)
        (self.folder / "example.yaml").write_bytes(wrong)
        result = self.run_it(*options, "example.yaml", "-o", "-", errors="replace")
        found = re.findall(r"\[([EW]\d{3})\]: ", result.stderr)
        self.assertEqual(set(found), {code}, result.stderr)
        self.assertEqual(result.returncode, 0 if code[0] == "W" else 4 if code in ("E003", "E038") else 1, code)
        (self.folder / "example.yaml").write_bytes(right)
        self.ok(*options, "example.yaml", "-o", "-")
        return result.stderr

    def test_every_code_has_a_page_whose_example_gives_it_and_put_right_does_not(self):
        self.assertGreaterEqual(len(self.codes), 64)
        for code, meaning in self.codes.items():
            with self.subTest(code):
                page = self.ok("explain", code)
                self.assertTrue(page.startswith(f"{code}: {meaning}\n\n"))
                about, rest = page.split("\n\nAn example; what is marked - is wrong, and + puts it right:\n\n")
                self.assertGreater(len(about), 100)
                self.assertLessEqual(max(map(len, about.splitlines())), 120)
                example, message = re.split(r"\ngauss-gen .*example\.yaml says\n\n", rest)
                options = re.search(r"(?m)^gauss-gen (.*)example\.yaml says$", rest)[1].split()
                said = self.check_example(code, [line[4:] for line in example.splitlines()], options)
                self.assertEqual([line[4:] for line in message.splitlines()], said.splitlines())

    def test_no_page_is_left_without_its_code(self):
        files = {path.stem for path in (SOURCE / "generator/cli/explanations").iterdir()}
        self.assertEqual(files, set(self.codes))

    def test_the_list_has_every_code_with_its_text(self):
        lines = self.ok("explain").splitlines()
        self.assertEqual([line for line in lines if re.match(r"[EW]\d{3}  ", line)],
                         [f"{code}  {meaning}" for code, meaning in sorted(self.codes.items())])

    def test_a_code_is_found_in_small_letters(self):
        self.assertEqual(self.ok("explain", "e012"), self.ok("explain", "E012"))
        self.assertEqual(self.ok("explain", "w055"), self.ok("explain", "W055"))

    def test_digits_alone_are_a_code_where_they_are_one(self):
        for word in ("31", "031"):
            self.assertEqual(self.ok("explain", word), self.ok("explain", "E031"))
        self.assertEqual(self.ok("explain", "6"), self.ok("explain", "E006"))

    def test_an_unknown_code_is_refused_with_the_nearest(self):
        for word, near in (("E12", "did you mean 'E012'?"), ("055", "did you mean 'E055' or 'W055'?"),
                           ("62", "did you mean 'E062' or 'W062'?"), ("0031", "did you mean 'E031'?"), ("99", "gauss-gen explain lists them"), ("E0700", "did you mean 'E070'?"),
                           ("nonsense", "gauss-gen explain lists them")):
            self.assertEqual(self.refused(2, "explain", word), f"gauss-gen: explain: there is no code '{word}'; {near}\n")
        self.refused(2, "explain", "E012", "E013")
        self.refused(2, "explain", "E012", "--format", "json")

    def test_the_document_has_every_page(self):
        document = self.ok("explain", "--format", "markdown")
        self.assertEqual(document, (SOURCE / "docs/errors.md").read_text(encoding="utf-8"))
        for code in self.codes:
            self.assertIn(self.ok("explain", code, "--format=markdown"), document)


if __name__ == "__main__":
    unittest.main()
