"""tools/check_layering.py fails where it must: each rule against a small tree that breaks it."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools" / "check_layering.py"
sys.path.insert(0, str(TOOL.parent))
import check_layering  # noqa: E402


class Checkout(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="gauss layering ")
        self.addCleanup(directory.cleanup)
        self.root = Path(directory.name)
        self.write("generator/support/source.hpp", "#include <string>\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def findings(self):
        return [(v.file, v.line, v.rule) for v in check_layering.check(self.root)]

    def assert_only(self, *expected):
        self.assertEqual(sorted(set(self.findings())), sorted(expected))


class Arrows(Checkout):
    def test_an_allowed_include_passes(self):
        self.write("generator/spec/reader.cpp", '#include "support/source.hpp"\n#include <yaml-cpp/yaml.h>\n')
        self.assert_only()

    def test_a_forbidden_include_is_named_with_file_line_and_rule(self):
        self.write("generator/support/source.cpp", '// text\n\n#include "ir/dag.hpp"\n')
        self.assert_only(("generator/support/source.cpp", 3, "arrow"))

    def test_arrows_are_transitive(self):
        self.write("generator/strategy/solve.cpp", '#include "support/source.hpp"\n#include "model/model.hpp"\n')
        self.assert_only()

    def test_the_emitted_route_never_sees_the_papers_route(self):
        self.write("generator/strategy/solve.cpp", '#include "gauss/metric.hpp"\n#include "lower/raise.hpp"\n')
        self.assert_only(("generator/strategy/solve.cpp", 1, "arrow"), ("generator/strategy/solve.cpp", 2, "arrow"))

    def test_only_the_command_line_and_the_pipeline_see_all(self):
        self.write("generator/pipeline.hpp", "")
        self.write("generator/pipeline.cpp", '#include "pipeline.hpp"\n#include "nonholonomic/eliminate.hpp"\n')
        self.write("generator/cli/main.cpp", '#include "pipeline.hpp"\n#include "emit/header.hpp"\n')
        self.write("generator/emit/header.cpp", '#include "pipeline.hpp"\n')
        self.assert_only(("generator/emit/header.cpp", 1, "arrow"))

    def test_a_file_that_cmake_fills_in_counts_as_its_template(self):
        self.write("generator/version.hpp.in", "")
        self.write("generator/unit.cpp", '#include "version.hpp"\n#include "missing.hpp"\n')
        self.write("generator/cli/options.cpp", '#include "version.hpp"\n')
        self.write("generator/emit/header.cpp", '#include "version.hpp"\n')
        self.assert_only(("generator/unit.cpp", 2, "plain"), ("generator/emit/header.cpp", 1, "arrow"))

    def test_an_unknown_folder_is_a_finding(self):
        self.write("generator/utils/all.hpp", "")
        self.assert_only(("generator/utils/all.hpp", 1, "folder"))

    def test_relative_and_computed_includes_are_refused(self):
        self.write("generator/ir/dag.cpp", '#include "dag.hpp"\n#include "../support/source.hpp"\n#include HEADER\n')
        file = "generator/ir/dag.cpp"
        self.assert_only((file, 1, "plain"), (file, 2, "plain"), (file, 3, "plain"))

    def test_comments_and_text_are_not_includes(self):
        self.write("generator/support/a.cpp",
                   '// #include "ir/a.hpp"\n/*\n#include "ir/a.hpp"\n*/\n'
                   'auto s = R"cpp(\n#include "ir/a.hpp"\n)cpp";\nint million = 1\'000\'000;\n#include <vector>\n')
        self.assert_only()

    def test_an_include_after_a_comment_is_seen(self):
        self.write("generator/support/a.cpp", '/* "x */ // R"(\n  #  include "ir/a.hpp"\n')
        self.assert_only(("generator/support/a.cpp", 2, "arrow"))


class Libraries(Checkout):
    def test_yaml_is_seen_by_spec_only(self):
        self.write("generator/model/model.cpp", "#include <yaml-cpp/yaml.h>\n")
        self.assert_only(("generator/model/model.cpp", 1, "yaml-cpp"))

    def test_ginac_is_free_where_it_belongs(self):
        for folder in ("lower", "symbolic", "gauss", "nonholonomic"):
            self.write(f"generator/{folder}/a.hpp", "#include <ginac/ginac.h>\n")
        self.assert_only()

    def test_two_files_elsewhere_may_see_ginac_and_a_third_makes_all_fail(self):
        self.write("generator/cli/a.cpp", "#include <ginac/ginac.h>\n#include <ginac/print.h>\n")
        self.write("generator/pipeline.cpp", "#include <ginac/ginac.h>\n")
        self.assert_only()
        self.write("generator/emit/c.cpp", "\n#include <ginac/ginac.h>\n")
        self.assert_only(("generator/cli/a.cpp", 1, "ginac"), ("generator/pipeline.cpp", 1, "ginac"),
                         ("generator/emit/c.cpp", 2, "ginac"))

    def test_the_runtime_never_sees_the_generator_or_ginac(self):
        self.write("src/math.hpp", '#include <ginac/ginac.h>\n#include "ir/dag.hpp"\n#include "../generator/a.hpp"\n')
        self.assert_only(("src/math.hpp", 1, "runtime"), ("src/math.hpp", 2, "runtime"), ("src/math.hpp", 3, "runtime"))

    def test_the_runtime_may_have_a_folder_gauss_of_its_own(self):
        self.write("generator/gauss/metric.hpp", "")
        self.write("src/gauss/math.hpp", "#include <cmath>\n")
        self.write("src/a.cpp", '#include "gauss/math.hpp"\n#include "gauss/metric.hpp"\n')
        self.assert_only(("src/a.cpp", 2, "runtime"))

    def test_emitted_code_includes_the_standard_library_only(self):
        self.write("generated/a/a.hpp", '#include <cmath>\n#include <fmt/format.h>\n#include "gauss/math.hpp"\n')
        self.assert_only(("generated/a/a.hpp", 2, "emitted"), ("generated/a/a.hpp", 3, "emitted"))


class Programs(Checkout):
    def setUp(self):
        super().setUp()
        self.write("src/gauss/math.hpp", "")
        self.write("apps/sim/interpreter/place.hpp", "")

    def test_a_program_may_see_both_sides_and_itself(self):
        self.write("apps/sim/interpreter/a.cpp",
                   '#include "sim/interpreter/place.hpp"\n#include "support/source.hpp"\n#include "gauss/math.hpp"\n#include <map>\n')
        self.assert_only()

    def test_what_only_the_generator_sees_is_refused_in_it_and_so_are_other_programs(self):
        self.write("apps/view/draw/draw.hpp", "")
        self.write("apps/sim/interpreter/a.cpp",
                   '#include <ginac/ginac.h>\n#include <yaml-cpp/yaml.h>\n#include "view/draw/draw.hpp"\n#include "../../view/draw.hpp"\n')
        file = "apps/sim/interpreter/a.cpp"
        self.assert_only((file, 1, "apps"), (file, 2, "apps"), (file, 3, "apps"), (file, 4, "plain"))

    def test_nothing_sees_a_program(self):
        self.write("src/gauss/b.hpp", '#include "sim/interpreter/place.hpp"\n')
        self.write("generator/emit/b.hpp", '\n#include "sim/interpreter/place.hpp"\n')
        self.assert_only(("src/gauss/b.hpp", 1, "apps"), ("generator/emit/b.hpp", 2, "apps"), ("generator/emit/b.hpp", 2, "arrow"))


class Types(Checkout):
    def test_two_types_of_one_name_are_a_finding(self):
        text = "namespace gauss {\n\nclass Later;\n\nnamespace {\nstruct Own {\n};\n}  // namespace\n\nstruct Reference {\n};\n\n}  // namespace gauss\n"
        self.write("apps/sim/a/a.hpp", text)
        self.write("apps/sim/b/b.hpp", text.replace("gauss {", "other {").replace("namespace gauss", "namespace other"))
        self.assert_only()
        self.write("apps/sim/b/c.hpp", "// One line more.\n" + text)
        self.assert_only(("apps/sim/b/c.hpp", 11, "types"))


class CMake(Checkout):
    def test_a_forbidden_dependency_is_a_finding(self):
        self.write("generator/ir/CMakeLists.txt",
                   "gauss_generator_library(ir\n  SOURCES dag.cpp # DEPENDS cli\n  DEPENDS support\n    model)\n")
        self.assert_only(("generator/ir/CMakeLists.txt", 4, "arrow"))

    def test_an_include_that_no_dependency_leads_to_is_a_finding(self):
        self.write("generator/lower/CMakeLists.txt", "gauss_generator_library(lower SOURCES lower.cpp DEPENDS ir)\n")
        self.write("generator/lower/lower.cpp", '#include "ir/dag.hpp"\n#include "model/ast.hpp"\n')
        self.assert_only(("generator/lower/lower.cpp", 2, "cmake"))

    def test_the_library_of_the_files_in_generator_itself_is_held_too(self):
        self.write("generator/CMakeLists.txt", "gauss_generator_library(pipeline SOURCES paper.cpp DEPENDS emit)\n")
        self.write("generator/paper.cpp", '#include "lower/lowering.hpp"\n#include "emit/header.hpp"\n')
        self.assert_only(("generator/paper.cpp", 1, "cmake"))
        self.write("generator/CMakeLists.txt", "gauss_generator_library(pipeline SOURCES paper.cpp DEPENDS lower cli emit)\n")
        self.assert_only(("generator/CMakeLists.txt", 1, "arrow"))

    def test_a_library_is_called_like_its_folder(self):
        self.write("generator/ir/CMakeLists.txt", "gauss_generator_library(dag SOURCES dag.cpp)\n")
        self.assert_only(("generator/ir/CMakeLists.txt", 1, "cmake"))

    def test_linking_past_the_function_is_seen(self):
        self.write("generator/ir/CMakeLists.txt", "target_link_libraries(gaussgen_ir PRIVATE gaussgen::model)\n")
        self.write("generator/model/CMakeLists.txt", "target_link_libraries(gaussgen_model PRIVATE yaml-cpp)\n")
        self.assert_only(("generator/ir/CMakeLists.txt", 1, "arrow"), ("generator/model/CMakeLists.txt", 1, "yaml-cpp"))


class CommandLine(Checkout):
    def run_tool(self, root):
        return subprocess.run([sys.executable, str(TOOL), str(root)], capture_output=True, text=True, check=False)

    def test_it_exits_with_1_and_prints_the_place(self):
        self.write("generator/support/source.cpp", '#include "ir/dag.hpp"\n')
        result = self.run_tool(self.root)
        self.assertEqual(result.returncode, 1)
        self.assertIn("generator/support/source.cpp:1: arrow: support may not include ir", result.stdout)

    def test_it_exits_with_0_on_a_clean_tree_and_2_without_one(self):
        self.assertEqual(self.run_tool(self.root).returncode, 0)
        self.assertEqual(self.run_tool(self.root / "nowhere").returncode, 2)


class Table(unittest.TestCase):
    def test_the_arrows_have_no_cycle(self):
        for folder, targets in check_layering.ARROWS.items():
            for target in targets:
                self.assertNotIn(folder, check_layering.allowed(target))

    def test_the_documentation_states_the_same_arrows(self):
        rows = re.findall(r"^\| `(\w+)/?` \|[^|]*\|([^|]*)\|$", (ROOT / "docs/architecture.md").read_text("utf-8"), re.M)
        stated = {folder: sorted(re.findall(r"\w+", arrows)) for folder, arrows in rows}
        self.assertEqual(stated, {folder: sorted(arrows) for folder, arrows in check_layering.ARROWS.items()})


if __name__ == "__main__":
    unittest.main()
