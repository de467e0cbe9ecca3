"""Same bytes with other serial numbers of GiNaC's symbols. $GAUSS_PRINT_HASH is the program print_hash."""

import os
import subprocess
import unittest

from same_bytes import LARGE, MODELS

SEEDS = range(20 if os.environ.get("GAUSS_THOROUGH") == "1" else 5)


class Serials(unittest.TestCase):
    def test_other_serial_numbers_print_the_same_bytes(self):
        found = {}
        for seed in SEEDS:
            result = subprocess.run([os.environ["GAUSS_PRINT_HASH"], str(seed), *(str(path) for path in MODELS if path.stem not in LARGE)], capture_output=True, text=True,
                                    check=True, timeout=300)
            found.setdefault(result.stdout, []).append(seed)
        self.assertEqual(len(found), 1, f"seeds by what they print: {found}")


if __name__ == "__main__":
    unittest.main()
