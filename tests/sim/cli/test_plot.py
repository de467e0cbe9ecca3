"""gauss-sim plot: what is in the picture is what is in the table."""

import math
import re
import unittest
import xml.etree.ElementTree as xml

from gauss_sim import SPRING, Program

SVG = "{http://www.w3.org/2000/svg}"


class Plots(Program):
    def table_of(self, header, rows, name="table.csv"):
        return self.write(name, "".join(",".join(map(str, row)) + "\n" for row in [header, *rows]))

    def picture(self, *arguments, name="table.svg"):
        self.ok("plot", *arguments)
        return xml.parse(self.folder / name).getroot()

    def words(self, picture, look):
        return [text.text for text in picture.iter(SVG + "text") if text.get("class") == look]

    def lines(self, picture):
        """Points of each line by its title, the sample of the legend apart."""
        found = {}
        for group in picture.iter(SVG + "g"):
            lines = [[tuple(map(float, point.split(","))) for point in line.get("points").split()] for line in group.iter(SVG + "polyline")]
            found[group.find(SVG + "title").text] = lines[:-1]
        return found

    def frames(self, picture):
        return [{key: float(frame.get(key)) for key in ("x", "y", "width", "height")}
                for frame in picture.iter(SVG + "rect") if frame.get("class") == "frame"]

    def test_a_panel_for_each_unit_with_its_title_and_legend(self):
        self.write("spring.yaml", SPRING)
        self.ok("run", "spring.yaml", "-q", "--outputs", "x,x_dot,energy")
        picture = self.picture("spring.csv", name="spring.svg")
        self.assertEqual(self.words(picture, "title"), ["spring", "x [m]", "x_dot [m/s]", "[J]", "t [s]"])
        legend = self.words(picture, "legend")
        self.assertEqual(legend[:2], ["x", "x_dot"])
        self.assertIn("energy.total", legend)
        self.assertEqual(len(self.frames(picture)), 3)

    def test_points_are_where_the_ticks_say(self):
        self.table_of(["t [s]", "x [m]"], [[0, -1], [5, 1], [10, 0.5]])
        picture = self.picture("table.csv")
        frame = self.frames(picture)[0]
        points = self.lines(picture)["x [m]"][0]
        self.assertEqual(self.words(picture, "tick"), ["−1.0", "−0.5", "0.0", "0.5", "1.0"] + [str(k) for k in range(11)])
        for (x, y), (t, value) in zip(points, ((0, -1), (5, 1), (10, 0.5))):
            self.assertAlmostEqual(x, frame["x"] + frame["width"] * t / 10, delta=0.01)
            self.assertAlmostEqual(y, frame["y"] + frame["height"] * (1 - value) / 2, delta=0.01)

    def test_a_circle_is_round(self):
        turn = [[k / 48, round(2 * math.cos(math.tau * k / 48), 9), round(2 * math.sin(math.tau * k / 48), 9)] for k in range(49)]
        self.table_of(["t [s]", "x [m]", "y [m]"], turn)
        points = self.lines(self.picture("table.csv", "--columns", "y", "--against", "x"))["y [m]"][0]
        width, height = (max(point[i] for point in points) - min(point[i] for point in points) for i in (0, 1))
        self.assertAlmostEqual(width, height, delta=0.5)
        with self.subTest("a strip would show nothing"):
            self.table_of(["t [s]", "x [m]", "y [m]"], [[t, x, y / 1000] for t, x, y in turn])
            self.assertEqual(self.frames(self.picture("table.csv", "--columns", "y", "--against", "x"))[0]["height"], 200)

    def test_all_wrong_columns_are_named_at_once(self):
        self.table_of(["t [s]", "psi [rad]"], [[0, 1], [1, 2]])
        said = self.refused(2, "plot", "table.csv", "--columns", "pis,psi,zeta")
        self.assertIn("--columns: the table has no column 'pis' (did you mean 'psi'?), and none 'zeta'; there are t, psi", said)

    def test_columns_are_chosen_by_name_and_by_group(self):
        self.table_of(["t [s]", "chi [rad]", "energy.kinetic [J]", "energy.total [J]"], [[0, 1, 2, 3], [1, 2, 3, 4]])
        self.assertEqual(list(self.lines(self.picture("table.csv", "--columns", "energy"))), ["energy.kinetic [J]", "energy.total [J]"])
        picture = self.picture("table.csv", "--columns", "energy.total", "--against", "chi", "-o", "other.svg", name="other.svg")
        self.assertEqual(self.words(picture, "title"), ["table", "energy.total [J]", "chi [rad]"])
        self.assertIn("did you mean 'chi'?", self.refused(2, "plot", "table.csv", "--columns", "ch"))
        self.assertIn("--against: the table has no column 'zeta'", self.refused(2, "plot", "table.csv", "--against", "zeta"))
        with self.subTest("a list ends at a blank"):
            self.assertIn("chi", self.ok("plot", "--columns", "chi", "table.csv", "-o", "-"))
        self.assertIn("is the table itself", self.refused(2, "plot", "table.csv", "-o", "table.csv"))

    def test_the_largest_numbers_have_axes(self):
        self.write("t.csv", "t,x\n0,1e308\n1,-1e308\n")
        self.ok("plot", "t.csv")
        self.assertNotRegex((self.folder / "t.svg").read_text(encoding="utf-8"), "inf|nan")

    def test_words_are_no_lines_and_in_nobodys_way(self):
        self.write("t.csv", "trajectory,m [kg],status,x [m]\n0,1,finished,2\n1,2,finished,3\n")
        self.ok("plot", "t.csv", "--columns", "x", "--against", "m", "-o", "x.svg")
        self.assertIn("'finished' in column 'status'", self.refused(3, "plot", "t.csv", "-o", "y.svg"))

    def test_an_ensemble_is_dots_over_what_varies_or_lines_over_time(self):
        header = "trajectory,status,parameters.m [kg],t [s],x [m]\n"
        self.write("end.csv", header + "0,finished,1,5,2\n1,step too small,2,3,\n2,finished,3,5,4\n")
        picture = self.picture("end.csv", name="end.svg")
        self.assertEqual(self.words(picture, "title"), ["end", "x [m]", "parameters.m [kg]"])
        dots = [path.get("d") for path in picture.iter(SVG + "path") if path.get("class") == "dot c0"]
        frame = self.frames(picture)[0]
        places = [tuple(map(float, place.split())) for place in re.findall(r"M([^h]*)h0", dots[0])]
        inset = frame["width"] * 0.03 / 1.06  # so that no dot lies on the frame
        for place, expected in zip(places, [(frame["x"] + inset, frame["y"] + frame["height"]), (frame["x"] + frame["width"] - inset, frame["y"])]):
            self.assertAlmostEqual(place[0], expected[0], delta=0.01)
            self.assertAlmostEqual(place[1], expected[1], delta=0.01)
        self.assertEqual(len(places), 2)
        self.write("way.csv", header + "0,finished,1,0,0\n0,finished,1,1,2\n1,finished,2,0,0\n1,finished,2,1,4\n")
        picture = self.picture("way.csv", name="way.svg")
        self.assertEqual(self.words(picture, "title"), ["way", "x [m]", "t [s]"])
        self.assertEqual(len(self.lines(picture)["x [m]"]), 2)
        # In a table of one motion, what is missing is a mistake.
        self.write("t.csv", "t,x\n0,1\n1,\n")
        self.assertIn("'' in column 'x'", self.refused(3, "plot", "t.csv"))

    def test_long_tables_keep_their_extremes(self):
        rows = [[k / 100_000, math.sin(k / 1000)] for k in range(100_000)]
        rows[54_321][1], rows[12_345][1] = 7.0, -5.0
        self.table_of(["t [s]", "x"], rows)
        picture = self.picture("table.csv")
        frame, points = self.frames(picture)[0], self.lines(picture)["x"][0]
        self.assertLess(len(points), 4 * frame["width"] + 4)
        ticks = [float(word.replace("−", "-")) for word in self.words(picture, "tick")]
        low, high = min(ticks[:ticks.index(max(ticks)) + 1]), max(ticks)
        up = lambda value: frame["y"] + frame["height"] * (high - value) / (high - low)
        self.assertAlmostEqual(min(y for _, y in points), up(7), delta=0.01)
        self.assertAlmostEqual(max(y for _, y in points), up(-5), delta=0.01)

    def test_small_and_large_numbers_have_short_ticks(self):
        self.table_of(["t [s]", "x [m]", "y [N]", "z [J]"], [[0, 0, 1e6, 4.5], [1, 3e-7, 3e6, 4.5 + 2e-9]])
        picture = self.picture("table.csv")
        titles = self.words(picture, "title")
        self.assertEqual(titles[1:3], ["x [10⁻⁹ m]", "y [10⁶ N]"])
        self.assertRegex(titles[3], r"^z \[10⁻⁹ J, from 4\.5\]$")
        self.assertLessEqual(max(map(len, self.words(picture, "tick"))), 5)

    def test_what_is_no_number_parts_a_line_and_what_is_constant_is_a_line(self):
        self.table_of(["t [s]", "x", "y"], [[0, 1, 2], [1, "nan", 2], [2, 1, 2], [3, "inf", 2], [4, 2, 2]])
        picture = self.picture("table.csv")
        lines = self.lines(picture)
        self.assertEqual(lines["x"], [])
        dots = [path.get("d") for group in picture.iter(SVG + "g") if group.find(SVG + "title").text == "x" for path in group.iter(SVG + "path")]
        self.assertEqual(len(dots), 3)
        self.assertEqual(len(set(dots)), 3)
        self.assertEqual(len({y for _, y in lines["y"][0]}), 1)

    def test_names_are_text(self):
        self.write("table.csv", 't [s],"a<b&""c"", d [m]"\n0,1\n1,2\n')
        self.assertEqual(list(self.lines(self.picture("table.csv"))), ['a<b&"c", d [m]'])

    def test_more_lines_than_colours_are_dashed(self):
        self.table_of(["t [s]"] + [f"x{k}" for k in range(14)], [[0] * 15, list(range(15))])
        looks = {line.get("class") for line in self.picture("table.csv").iter(SVG + "polyline")}
        self.assertEqual(len(looks), 14)

    def test_it_suits_light_and_dark(self):
        self.table_of(["t [s]", "x"], [[0, 1], [1, 2]])
        self.ok("plot", "table.csv")
        text = (self.folder / "table.svg").read_text(encoding="utf-8")
        self.assertIn("@media(prefers-color-scheme:dark)", text)
        self.assertEqual(text, self.ok("plot", "table.csv", "-o", "-"))
        self.assertFalse(re.search(r"nan|inf", text))

    def test_what_is_no_table_is_refused_with_its_line(self):
        for text, line, said in (("t,x\n0,1\n1,a\n", 3, "'a' in column 'x' is no number"), ("t,x\n0,1\n1\n", 3, "1 fields where the header has 2"),
                                 ("t,x\n", 1, "no rows"), ("", 1, "the table is empty"), ('t,"x\n0,1\n', 1, "not closed"), ("t,,x\n0,1,2\n", 1, "no name"),
                                 ("t,x\n0,1 \n", 2, "is no number"), ("t,x\n0,\n", 2, "'' in column 'x'")):
            self.write("bad.csv", text)
            self.assertIn(f"bad.csv:{line}: ", said_now := self.refused(3, "plot", "bad.csv"), text)
            self.assertIn(said, said_now, text)
        self.refused(3, "plot", "none.csv")
        self.table_of(["t"], [[0], [1]])
        self.assertIn("one column", self.refused(2, "plot", "table.csv"))


if __name__ == "__main__":
    unittest.main()
