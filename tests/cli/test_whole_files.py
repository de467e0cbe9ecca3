"""A header is the old one or the new one, never half of one, whoever is killed and however many write at once."""

import os
import random
import subprocess
import threading
import time
import unittest
from pathlib import Path

from gauss_gen import PROGRAM, SKEW, SPHERE, Program, without_poles

KILLS = 50
WRITERS = 8


class WholeFiles(Program):
    def setUp(self):
        super().setUp()
        self.texts = [self.ok(SPHERE, "-o", "-"), self.ok(SPHERE, "-o", "-", "--fold")]
        self.header = self.folder / "sphere_in_cylinder.hpp"

    def start(self, fold):
        return subprocess.Popen([PROGRAM, SPHERE, *(["--fold"] if fold else [])], cwd=self.folder, stderr=subprocess.PIPE)

    def test_a_killed_run_leaves_the_old_header_or_the_new_one(self):
        begin = time.monotonic()
        self.ok(SPHERE)
        duration = time.monotonic() - begin
        chance = random.Random(1986)
        changed = 0
        for i in range(KILLS):
            old = self.header.read_text()
            process = self.start(fold=i % 2 == 0)
            time.sleep(chance.uniform(0, 1.2 * duration))
            process.kill()
            process.communicate()
            self.assertIn(self.header.read_text(), self.texts)
            changed += self.header.read_text() != old
        self.assertLess(changed, KILLS)
        left = self.files()
        self.assertEqual([name for name in left if name.endswith(".hpp")], [self.header.name])
        self.ok(SPHERE)
        self.ok(SPHERE, "--fold")
        self.assertEqual(self.files(), left)  # whoever ends leaves nothing beside the header

    def test_many_writers_at_once_never_show_half_a_header(self):
        self.ok(SPHERE)
        done = threading.Event()
        seen = set()

        def watch():
            while not done.is_set():
                seen.add(self.header.read_text())

        watcher = threading.Thread(target=watch)
        watcher.start()
        for _ in range(5):
            processes = [self.start(fold=i % 2 == 0) for i in range(WRITERS)]
            self.assertEqual([(without_poles(process.communicate()[1].decode()), process.returncode) for process in processes],
                             [("", 0)] * WRITERS)
        done.set()
        watcher.join()
        self.assertLessEqual(seen, set(self.texts))
        self.assertEqual(self.files(), [self.header.name])

    def test_an_unchanged_header_keeps_its_time(self):
        self.ok(SPHERE, "--depfile", "m.d")
        for path in (self.header, self.folder / "m.d"):
            os.utime(path, (1, 1))
        self.ok(SPHERE, "--depfile", "m.d")
        self.assertEqual([path.stat().st_mtime for path in (self.header, self.folder / "m.d")], [1, 1])
        self.ok(SPHERE, "--fold")
        self.assertNotEqual(self.header.stat().st_mtime, 1)

    def test_a_header_that_was_changed_by_hand_is_written_again(self):
        self.header.write_text(self.texts[0].replace("rolling", "rollong"))
        self.ok(SPHERE)
        self.assertEqual(self.header.read_text(), self.texts[0])

    def test_a_link_stays_a_link(self):
        (self.folder / "elsewhere.hpp").write_text("old")
        self.header.symlink_to("elsewhere.hpp")
        self.ok(SPHERE)
        self.assertTrue(self.header.is_symlink())
        self.assertEqual((self.folder / "elsewhere.hpp").read_text(), self.texts[0])

    def test_a_reader_that_has_the_old_header_open_keeps_it(self):
        self.header.write_text("old")
        with self.header.open() as reader:
            self.ok(SPHERE)
            self.assertEqual(reader.read(), "old")

    def test_what_was_read_is_not_overwritten(self):
        for name, *arguments in (("m.yaml", "derivation", "m.yaml", "-o", "m.yaml"), ("m.yaml", "m.yaml", "--depfile", "./m.yaml"),
                                 ("skew_chart.hpp", "skew_chart.hpp"), ("link.yaml", "m.yaml", "-o", "d", "--depfile", "link.yaml"),
                                 ("part.yaml", "whole.yaml", "--depfile", "part.yaml"),
                                 ("d/skew_chart.hpp", "m.yaml", "-o", "d", "--depfile", "d/skew_chart.hpp")):
            (self.folder / "d").mkdir(exist_ok=True)
            text = Path(SKEW).read_text(encoding="utf-8")
            for model in ("m.yaml", "part.yaml", "skew_chart.hpp"):
                (self.folder / model).write_text(text, encoding="utf-8")
            (self.folder / "whole.yaml").write_text("gauss: 1\nname: whole\nsubmodels: {a: {file: part.yaml, without: [gravity]}}\n", encoding="utf-8")
            if not (self.folder / "link.yaml").exists():
                (self.folder / "link.yaml").hardlink_to(self.folder / "m.yaml")
            before = self.files()
            said = self.refused(3, *arguments)
            self.assertIn(name, said)
            self.assertRegex(said, "would be lost|both the header and the depfile")
            self.assertEqual(self.files(), before)
            self.assertEqual((self.folder / "m.yaml").read_text(encoding="utf-8"), text)

    def test_nothing_but_the_two_files_appears(self):
        self.ok(SKEW, "-o", "out", "--depfile", "out/skew.d")
        self.assertEqual(self.files(), ["out", "out/skew.d", "out/skew_chart.hpp"])


if __name__ == "__main__":
    unittest.main()
