#!/usr/bin/env python3
"""Holds the includes and the CMake arrows of a checkout against the architecture (docs/architecture.md).

usage: check_layering.py [ROOT]

Prints one line per violation, `file:line: rule: what`, and exits with 1 if there is any.
"""

import re
import sys
from collections import namedtuple
from pathlib import Path

# Who may include whom, folder by folder of generator/. Arrows are transitive: a folder may also include
# what its entries may include. `pipeline` stands for the files in generator/ itself.
ARROWS = {
    "support": [],
    "spec": ["support"],
    "model": ["spec", "support"],
    "symbolic": ["model"],
    "ir": ["support"],
    "kinematics": ["ir", "model"],
    "gauss": ["symbolic", "model"],
    "nonholonomic": ["gauss"],
    "lower": ["nonholonomic", "symbolic", "ir"],
    "strategy": ["kinematics", "ir"],
    "passes": ["ir"],
    "evaluate": ["ir"],
    "analysis": ["strategy", "evaluate"],
    "emit": ["ir", "passes"],
    "pipeline": ["analysis", "lower", "emit"],
    "cli": ["pipeline"],
}

GINAC_FOLDERS = {"lower", "symbolic", "gauss", "nonholonomic"}
GINAC_FILES_ELSEWHERE = 2
YAML_FOLDER = "spec"

# Emitted code needs the C++ standard library and nothing else.
STANDARD_HEADERS = set("""
algorithm any array atomic bitset cassert cctype cerrno cfenv cfloat charconv chrono cinttypes climits clocale cmath
codecvt complex condition_variable csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar
cwctype deque exception execution filesystem forward_list fstream functional future initializer_list iomanip ios
iosfwd iostream istream iterator limits list locale map memory memory_resource mutex new numeric optional ostream
queue random ratio regex scoped_allocator set shared_mutex sstream stack stdexcept streambuf string string_view
system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant vector
version
""".split())

SOURCE_SUFFIXES = {".hpp", ".h", ".cpp", ".cc", ".cu", ".cuh", ".inc", ".in", ".ipp", ".tpp"}

Include = namedtuple("Include", "line angled path")
Violation = namedtuple("Violation", "file line rule what")

# An include directive, or something in which the text of one is not a directive: comments, raw strings
# (skeletons of emitted code), strings, characters.
TOKEN = re.compile(
    r"""
      ^[ \t]*\#[ \t]*include[ \t]*(?P<path><[^>\n]*>|"[^"\n]*")
    | ^[ \t]*\#[ \t]*include\b[ \t]*(?P<computed>[^\s<"][^\n]*)
    | //[^\n]*
    | /\*.*?\*/
    | R"(?P<mark>[^\s()\\"]{0,16})\(.*?\)(?P=mark)"
    | "(?:\\.|[^"\\\n])*"
    | (?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)


def allowed(folder):
    """Everything that `folder` may include, itself among it."""
    seen, open_ends = {folder}, [folder]
    while open_ends:
        for target in ARROWS.get(open_ends.pop(), []):
            if target not in seen:
                seen.add(target)
                open_ends.append(target)
    return seen


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def includes(text):
    for token in TOKEN.finditer(text):
        path = token.group("path")
        if path:
            yield Include(line_of(text, token.start("path")), path[0] == "<", path[1:-1])
        elif token.group("computed"):
            yield Include(line_of(text, token.start("computed")), False, None)


def sources(folder):
    if not folder.is_dir():
        return []
    return sorted(path for path in folder.rglob("*") if path.suffix in SOURCE_SUFFIXES and path.is_file())


def read(path):
    return path.read_text(encoding="utf-8", errors="replace")


def folder_in_generator(generator, path):
    parts = path.relative_to(generator).parts
    return parts[0] if len(parts) > 1 else "pipeline"


def check_generator(root):
    generator = root / "generator"
    ginac_elsewhere = []
    for path in sources(generator):
        folder = folder_in_generator(generator, path)
        if folder not in ARROWS:
            yield Violation(path, 1, "folder", f"generator/{folder}/ is not in the architecture table")
            continue
        for include in includes(read(path)):
            if include.path is None:
                yield Violation(path, include.line, "plain", "a computed #include hides what it includes")
            elif include.angled:
                if include.path.startswith("ginac/") and folder not in GINAC_FOLDERS:
                    if path not in [file for file, _ in ginac_elsewhere]:
                        ginac_elsewhere.append((path, include.line))
                if include.path.startswith("yaml-cpp/") and folder != YAML_FOLDER:
                    yield Violation(path, include.line, "yaml-cpp", f"only generator/{YAML_FOLDER}/ sees yaml-cpp")
            else:
                yield from check_quoted(generator, path, folder, include)
    for path, line in ginac_elsewhere if len(ginac_elsewhere) > GINAC_FILES_ELSEWHERE else []:
        where = ", ".join(sorted(GINAC_FOLDERS))
        yield Violation(path, line, "ginac", f"GiNaC belongs to {where} and at most {GINAC_FILES_ELSEWHERE} files "
                                             f"elsewhere; there are {len(ginac_elsewhere)}")


def is_root_file(generator, path):
    """In generator/ itself, as it is or as the template that CMake fills in (version.hpp.in)."""
    return (generator / path).is_file() or (generator / (path + ".in")).is_file()


def check_quoted(generator, path, folder, include):
    parts = include.path.split("/")
    if ".." in parts:
        yield Violation(path, include.line, "plain", f'"{include.path}": write it from generator/, as "folder/file.hpp"')
        return
    target = parts[0] if len(parts) > 1 else "pipeline"
    if target == "pipeline" and not is_root_file(generator, include.path):
        yield Violation(path, include.line, "plain", f'"{include.path}": write it from generator/, as "folder/file.hpp"')
    elif target in ("ginac", "yaml-cpp"):
        yield Violation(path, include.line, "plain", f'"{include.path}": a library is included as <{include.path}>')
    elif target not in allowed(folder):
        yield Violation(path, include.line, "arrow", f"{folder} may not include {target}; it may include "
                                                     f"{', '.join(sorted(allowed(folder) - {folder})) or 'nothing'}")


def check_cmake(root):
    """The arrows that CMake links: DEPENDS of gauss_generator_library, and libraries by name."""
    generator = root / "generator"
    for path in sorted(generator.glob("*/CMakeLists.txt")):
        folder = path.parent.name
        text = without_comments(path)
        yield from check_library(generator, path, folder, text)
        for name in re.finditer(r"\bgaussgen(?:_|::)(\w+)", text):
            if name.group(1) in ARROWS and name.group(1) not in allowed(folder):
                yield Violation(path, line_of(text, name.start()), "arrow", f"{folder} may not link {name.group(1)}")
        for name in re.finditer(r"\byaml-cpp\b", text):
            if folder != YAML_FOLDER:
                yield Violation(path, line_of(text, name.start()), "yaml-cpp", f"only {YAML_FOLDER}/ sees yaml-cpp")
    # This one also looks for packages and lists the folders, so only its library is held against the table.
    path = generator / "CMakeLists.txt"
    if path.is_file():
        yield from check_library(generator, path, "pipeline", without_comments(path))


def without_comments(path):
    return re.sub(r"#[^\n]*", lambda comment: " " * len(comment.group()), read(path))


def check_library(generator, path, folder, text):
    for call in re.finditer(r"\bgauss_generator_library\s*\(([^)]*)\)", text):
        linked = {folder}
        words = [(word.group(), line_of(text, call.start(1) + word.start()))
                 for word in re.finditer(r"\S+", call.group(1))]
        if words and words[0][0] != folder:
            yield Violation(path, words[0][1], "cmake", f"the library of {folder}/ is called {words[0][0]}")
        section = ""
        for word, line in words[1:]:
            if word in ("SOURCES", "DEPENDS", "LIBRARIES"):
                section = word
            elif section == "DEPENDS":
                linked |= allowed(word)
                if word not in allowed(folder):
                    yield Violation(path, line, "arrow", f"{folder} may not depend on {word}")
        yield from check_depends_suffice(generator, path, folder, linked)


def check_depends_suffice(generator, cmake_file, folder, linked):
    for path in sources(cmake_file.parent):
        if folder_in_generator(generator, path) != folder:
            continue
        for include in includes(read(path)):
            if include.path is None or include.angled or "/" not in include.path:
                continue
            target = include.path.split("/")[0]
            if target in allowed(folder) and target not in linked:
                yield Violation(path, include.line, "cmake", f"{folder} includes {target}, but DEPENDS in "
                                                             f"{cmake_file.relative_to(generator.parent)} "
                                                             "does not lead there")


def check_runtime(root):
    """src/ runs emitted models: it never knows the generator or GiNaC."""
    for path in sources(root / "src"):
        for include in includes(read(path)):
            if include.path is None:
                continue
            parts = include.path.split("/")
            if parts[0] in ("ginac", "cln", "yaml-cpp"):
                yield Violation(path, include.line, "runtime", f"src/ never includes {parts[0]}")
            # gauss/ may be a folder of src/ as well: there it is the namespace of the runtime.
            elif "generator" in parts or (len(parts) > 1 and parts[0] in set(ARROWS) - {"gauss"}) or (
                    (root / "generator" / include.path).is_file() and not any(
                        (base / include.path).is_file() for base in (root / "src", root / "src/include"))):
                yield Violation(path, include.line, "runtime", f'src/ never includes "{include.path}" of the generator')


def check_emitted(root):
    """generated/ and templates/: emitted code needs the standard library only."""
    for path in sources(root / "generated") + sources(root / "templates"):
        for include in includes(read(path)):
            if include.path is None or not include.angled or include.path not in STANDARD_HEADERS:
                yield Violation(path, include.line, "emitted", "emitted code includes the C++ standard library only, "
                                                               f"not {include.path or 'a computed header'}")


def programs(root):
    """The folders of apps/: each is a program, and an include in it is written from apps/, from generator/ or from src/."""
    apps = root / "apps"
    return [path for path in sorted(apps.iterdir()) if path.is_dir()] if apps.is_dir() else []


def check_apps(root):
    """Programs need both sides, but see neither GiNaC nor yaml-cpp, nor each other; nothing sees them."""
    for program in programs(root):
        bases = (root / "generator", root / "src")
        inside = program.name + "/"
        for path in sources(program):
            for include in includes(read(path)):
                if include.path is None or ".." in include.path.split("/"):
                    yield Violation(path, include.line, "plain", 'write an include of a program as "folder/file.hpp"')
                elif include.path.split("/")[0] in ("ginac", "cln", "yaml-cpp"):
                    yield Violation(path, include.line, "apps", f"programs see no {include.path}: generator/ does")
                elif include.path.startswith(inside) and (root / "apps" / include.path).is_file():
                    continue
                elif not include.angled and not any((base / (include.path + end)).is_file()
                                                    for base in bases for end in ("", ".in")):
                    yield Violation(path, include.line, "apps", f'"{include.path}" is neither of this program nor of '
                                                                "generator/ nor of src/")
    for path in sources(root / "src") + sources(root / "generator"):
        for include in includes(read(path)):
            inside = include.path is not None and not include.angled
            if inside and (root / "apps" / include.path).is_file():
                yield Violation(path, include.line, "apps", f'nothing includes "{include.path}" of a program')


TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)(?![\w<:])(?!.*;$)")
NAMESPACE = re.compile(r"^(?:inline )?namespace(?: ([\w:]+))? \{$")


def types(text):
    """Names of the types that a file defines outside of unnamed namespaces, with their namespace and line."""
    spaces = []
    for number, line in enumerate(text.splitlines(), 1):
        opened = NAMESPACE.match(line)
        if opened:
            spaces.append(opened[1])
        elif line.startswith("}  // namespace") and spaces:
            spaces.pop()
        elif None not in spaces and TYPE.match(line):
            yield "::".join([*spaces, TYPE.match(line)[1]]), number


def check_types(root):
    """Two types of one name are one to a linker, which takes the functions of either for both."""
    first = {}
    for path in [path for folder in ("generator", "src", "apps") for path in sources(root / folder)]:
        for name, line in types(read(path)):
            other = first.setdefault(name, path)
            if other != path:
                yield Violation(path, line, "types", f"{name} is a type of {other.relative_to(root).as_posix()}, too")


def check(root):
    root = Path(root)
    for part in (check_generator, check_cmake, check_runtime, check_emitted, check_apps, check_types):
        for violation in part(root):
            yield violation._replace(file=violation.file.relative_to(root).as_posix())


def main(arguments):
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    if not (root / "generator").is_dir():
        print(f"check_layering: {root} has no generator/", file=sys.stderr)
        return 2
    violations = sorted(set(check(root)))
    for violation in violations:
        print("{}:{}: {}: {}".format(*violation))
    print(f"layering: {len(sources(root / 'generator'))} files in generator/, {len(violations)} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
