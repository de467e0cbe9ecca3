"""--parts and --split: large functions in parts, and a source file that compiles them."""

import re
import unittest

from gauss_gen import MODELS, SKEW, Program

CHAIN = MODELS / "families/planar_chain_relative.yaml"
PART = re.compile(r"^GAUSS_PART (?:void|StatusOf<S>) (\w+)_part_(\d+)\((.*?)^\}", re.M | re.S)


class Parts(Program):
    def header(self, *arguments):
        return self.ok(CHAIN, "--count", "n=20", "--fold", "--outputs", "rhs", "-o", "-", *arguments)

    def test_small_functions_are_in_one_piece(self):
        self.assertEqual(PART.findall(self.header()), [])

    def test_parts_are_called_one_after_the_other_and_the_last_has_the_status(self):
        text = self.header("--parts", "200")
        names = [f"{name}_part_{number}" for name, number, _ in PART.findall(text)]
        self.assertGreaterEqual(len(names), 4)
        body = text[text.index("GAUSS_FUNCTION StatusOf<S> rhs("):]
        body = body[body.index("{\n"):body.index("\n}")]
        self.assertEqual(re.findall(r"(rhs_part_\d+)\(t, state, inputs, prepared, derivative, live\);", body), names)
        self.assertIn(f"return {names[-1]}(", body)

    def test_what_is_handed_on_is_set_before_it_is_read_and_read_by_a_later_part(self):
        text = self.header("--parts", "150")
        members = set(re.findall(r"^  (?:S|typename Math<S>::Bool) (\w+);$", re.search(r"struct LiveInRhs \{(.*?)^\};", text, re.M | re.S)[1], re.M))
        written, read = set(), set()
        for _, _, body in PART.findall(text):
            reads = set(re.findall(r"= live\.(\w+);", body))
            self.assertLessEqual(reads, written)
            self.assertFalse(read - written)
            read |= reads
            written |= set(re.findall(r"^  live\.(\w+) = ", body, re.M))
        self.assertEqual(written, members)
        self.assertEqual(read, members)

    def test_the_table_of_operations_is_that_of_the_whole(self):
        row = re.compile(r"^//   rhs .*$", re.M)
        self.assertEqual(row.search(self.header())[0], row.search(self.header("--parts", "100"))[0])

    def test_a_count_that_is_none_is_refused(self):
        self.assertIn("--parts", self.refused(2, SKEW, "--parts", "0"))
        self.assertIn("--parts", self.refused(2, SKEW, "--parts", "many"))


class Split(Program):
    def test_a_source_file_lies_beside_the_header_and_is_listed(self):
        self.ok(SKEW, "--split", "double", "-o", "there")
        self.assertEqual(sorted(path.name for path in (self.folder / "there").iterdir()), ["skew_chart.cpp", "skew_chart.hpp"])
        self.assertEqual(self.ok(SKEW, "--split", "double", "-o", "there", "--list-outputs"),
                         "there/skew_chart.hpp\nthere/skew_chart.cpp\n")

    def test_it_instantiates_every_function_for_every_type_and_the_header_leaves_them_to_it(self):
        self.ok(SKEW, "--split", "double,long-double")
        source = (self.folder / "skew_chart.cpp").read_text()
        header = (self.folder / "skew_chart.hpp").read_text()
        functions = re.findall(r"^GAUSS_SEPARATE (?:StatusOf|Prepared)<S> (\w+)\(", header, re.M)
        self.assertGreater(len(functions), 8)
        for scalar in ("double", "long double"):
            for text, prefix in ((source, ""), (header, "extern ")):
                found = re.findall(rf"^{prefix}template (?:StatusOf|Prepared)<{scalar}> (\w+)\(", text, re.M)
                self.assertEqual(found, functions)

    def test_without_it_nothing_changes(self):
        self.assertNotIn("extern template", self.ok(SKEW, "-o", "-"))

    def test_two_files_do_not_go_to_standard_output_and_types_are_known(self):
        self.assertIn("--split: it writes two files", self.refused(2, SKEW, "--split", "double", "-o", "-"))
        self.assertIn("--split", self.refused(2, SKEW, "--split", "half"))


if __name__ == "__main__":
    unittest.main()
