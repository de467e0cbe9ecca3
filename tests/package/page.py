"""A page of docs/ as a user follows it: its files written, its commands run, their output beside what the page shows.

A fenced block whose first line names a file, as in ```yaml cart.yaml, is that file. ```yaml cart.yaml:forces is a section of it: it
takes the place of the section, or comes at the end. ```cmake >>CMakeLists.txt is added to the file. In ```console, a line with
"$ " is a command, and the lines below are what it prints, errors included; a line "..." stands for any number of lines. Texts are
compared word by word, numbers to their last printed digit. A command that fails shows an error.

    python3 -B tests/package/page.py docs/tutorial.md [--all]

prints what a page should show and does not, or all; gauss-gen and the installed gauss are those of the shell.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FENCE = re.compile(r"^```(\w+) ?([^\n]*)\n(.*?)^```$", re.M | re.S)
FAILED = "it fails with exit code "
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def blocks(text):
    """(language, what stands beside it, content) of each fenced block."""
    return [match.groups() for match in FENCE.finditer(text)]


def put_section(text, name, section):
    """`text` with its section `name`, a key at the top level, replaced; or added at the end."""
    old = re.compile(rf"^{name}:.*\n(?:(?:[ #].*)?\n)*?(?=^\w|\Z)", re.M)
    if old.search(text):
        return old.sub(lambda _: section + "\n", text).rstrip("\n") + "\n"
    return text + "\n" + section


def write(folder, place, content):
    name, _, section = place.removeprefix(">>").partition(":")
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    if place.startswith(">>"):
        content = path.read_text(encoding="utf-8") + content
    elif section:
        content = put_section(path.read_text(encoding="utf-8"), section, content)
    path.write_text(content, encoding="utf-8")


def commands(content):
    """(command, lines that it is to print) of a block of ```console."""
    found = []
    for line in content.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found and found[-1][0].endswith("\\"):
            found[-1] = (found[-1][0] + "\n" + line, [])
        else:
            found[-1][1].append(line)
    return found


def last_digit(number):
    mantissa, _, exponent = number.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def same_word(shown, printed):
    if shown == printed:
        return True
    if NUMBER.sub("#", shown) != NUMBER.sub("#", printed):
        return False
    return all(a == b or ("." in a and abs(float(a) - float(b)) <= 1.01 * last_digit(a))
               for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


def same_line(shown, printed):
    a, b = shown.split(), printed.split()
    return len(a) == len(b) and all(map(same_word, a, b))


def matches(shown, printed):
    """Whether the lines `printed` are those `shown`, where "..." stands for any."""
    if not shown:
        return not printed
    if shown[0].strip() == "...":
        end = next((k for k, line in enumerate(printed) if line.startswith(FAILED)), len(printed))
        return any(matches(shown[1:], printed[k:]) for k in range(end + 1))
    return bool(printed) and same_line(shown[0], printed[0]) and matches(shown[1:], printed[1:])


def run(command, folder, environment):
    result = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, check=False, timeout=300)
    lines = [line.rstrip() for line in result.stdout.rstrip("\n").split("\n")] if result.stdout else []
    return lines, result.returncode


def strip_blank(lines):
    while lines and not lines[-1].strip():
        lines = lines[:-1]
    return lines


def follow(text, folder, environment):
    """Follows the page in `folder`: (command, lines shown, lines printed) of each command."""
    for language, place, content in blocks(text):
        if place:
            write(folder, place, content)
        elif language == "console":
            for command, shown in commands(content):
                printed, code = run(command, folder, environment)
                if code != 0 and not any("error" in line for line in shown):
                    printed.append(f"{FAILED}{code}")
                yield command, strip_blank(shown), printed


def main():
    page = Path(sys.argv[1]).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        for command, shown, printed in follow(page, Path(folder), dict(os.environ)):
            if "--all" in sys.argv or not matches(shown, printed):
                print(f"$ {command}", *printed, "", sep="\n")


if __name__ == "__main__":
    main()
