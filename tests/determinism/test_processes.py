"""Same model and options, same bytes: in fresh processes, whatever surrounds them."""

import functools
import os
import random
import resource
import subprocess
import tempfile
import unittest

import same_bytes

PROCESSES = 50 if os.environ.get("GAUSS_THOROUGH") == "1" else 10
# The other commands print the same objects; they are run under each locale.
WRITTEN = ("emitted", "folded", "paper", "markdown", "latex")
# The other commands and the large models take most of the time: each tenth process does that, too.
EVERY = 10
SWIFT = ("emitted",)
ZONES = ["UTC", "Asia/Kathmandu", "America/St_Johns", "nonsense"]
STACKS = [1 << 20, 8 << 20, 1 << 30]


@functools.cache
def expected():
    """What this process prints, with which all others are compared."""
    return same_bytes.hashes()


def surroundings(chance):
    """A process with other addresses: those of the stack follow the environment and its limit, those of the heap the system."""
    stack = chance.choice(STACKS)

    def limit_stack():
        _, hard = resource.getrlimit(resource.RLIMIT_STACK)
        resource.setrlimit(resource.RLIMIT_STACK, (stack if hard == resource.RLIM_INFINITY else min(stack, hard), hard))

    environment = {"PATH": os.environ["PATH"], "TZ": chance.choice(ZONES), "FILLER": "x" * chance.randrange(64 << 10),
                   "HOME": f"/home/{chance.randrange(1000)}", "MALLOC_PERTURB_": str(chance.randrange(256))}
    return {"env": environment, "preexec_fn": limit_stack}


class Processes(unittest.TestCase):
    def test_addresses_are_random_here(self):
        # Otherwise many processes would prove nothing.
        with open("/proc/sys/kernel/randomize_va_space", encoding="ascii") as file:
            self.assertNotEqual(file.read().strip(), "0")

    def test_many_processes_print_the_same_bytes(self):
        chance = random.Random(1986)
        self.assertGreaterEqual(len(expected()), len(same_bytes.COMMANDS) * 11)
        with tempfile.TemporaryDirectory(prefix="gauss determinism ") as folder:
            for process in range(PROCESSES - 1):
                # Relative to another folder, too.
                around = {"cwd": [folder, "/"][process % 2], **surroundings(chance)}
                if process % EVERY == 0:
                    found = same_bytes.hashes(WRITTEN, **around)
                else:
                    found = same_bytes.hashes(SWIFT, without=same_bytes.LARGE, **around)
                self.assertGreaterEqual(len(found), len(SWIFT) * 11)
                wanted = {name: value for name, value in expected().items() if name in found}
                self.assertEqual(same_bytes.differences(wanted, found), [], f"process {process}")


class Locales(unittest.TestCase):
    """Commas in numbers (German), and a dotless i in upper case (Turkish)."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gauss locales ")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def environment(self, locale):
        environment = {"PATH": os.environ["PATH"], "LOCPATH": self.folder, "LC_ALL": f"{locale}.UTF-8", "LANG": f"{locale}.UTF-8"}
        try:
            subprocess.run(["localedef", "-i", locale, "-f", "UTF-8", f"{self.folder}/{locale}.UTF-8"], check=True,
                           capture_output=True)
        except (OSError, subprocess.CalledProcessError) as error:
            self.skipTest(f"no locale {locale}.UTF-8 can be made here; on Debian the package `locales` helps: {error}")
        return environment

    def assert_in_force(self, environment):
        # A locale that the C library cannot load is silently C, and the test would prove nothing.
        result = subprocess.run(["locale", "decimal_point"], env=environment, check=True, capture_output=True, text=True)
        self.assertEqual(result.stdout.strip(), ",")

    def test_german_changes_nothing(self):
        environment = self.environment("de_DE")
        self.assert_in_force(environment)
        self.assertEqual(same_bytes.differences(expected(), same_bytes.hashes(env=environment)), [])

    def test_turkish_changes_nothing(self):
        environment = self.environment("tr_TR")
        self.assert_in_force(environment)
        self.assertEqual(same_bytes.differences(expected(), same_bytes.hashes(env=environment)), [])


if __name__ == "__main__":
    unittest.main()
