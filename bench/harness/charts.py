"""Lines over logarithmic axes, as SVG: colours that can be told apart by everybody, a mark of its own for each line and its name beside
its end, and text that follows the theme of the reader."""

import math
from html import escape

WIDTH, HEIGHT = 720, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 170, 40, 50
# Okabe and Ito.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c8c8c"]
STYLE = """  <style>
    text { font: 13px sans-serif; fill: #24292f; }
    .title { font-weight: bold; }
    .grid { stroke: #8c959f; stroke-opacity: 0.35; }
    @media (prefers-color-scheme: dark) { text { fill: #e6edf3; } }
  </style>
"""


def decades(low, high):
    return range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)


class Axes:
    def __init__(self, points):
        xs, ys = [x for x, _ in points], [y for _, y in points]
        self.x = (math.log(min(xs)), math.log(max(xs)) if max(xs) > min(xs) else math.log(min(xs)) + 1)
        powers = decades(min(ys), max(ys))
        self.powers = list(powers)
        self.y = (self.powers[0] * math.log(10), self.powers[-1] * math.log(10))

    def place(self, x, y):
        across = (math.log(x) - self.x[0]) / (self.x[1] - self.x[0])
        up = (math.log(y) - self.y[0]) / (self.y[1] - self.y[0])
        return LEFT + across * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM)


def mark(number, x, y, colour):
    shapes = [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4"', f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8"',
              f'<path d="M{x:.1f} {y - 5:.1f} l5 9 h-10 z"', f'<path d="M{x:.1f} {y - 5:.1f} l5 5 l-5 5 l-5 -5 z"',
              f'<path d="M{x:.1f} {y + 5:.1f} l5 -9 h-10 z"', f'<rect x="{x - 6:.1f}" y="{y - 2.5:.1f}" width="12" height="5"']
    return f'  {shapes[number % len(shapes)]} fill="{colour}"/>\n'


def apart(labels):
    """Names at the ends of lines, moved until none covers another."""
    labels = sorted(labels, key=lambda label: label[0])
    for i in range(1, len(labels)):
        labels[i][0] = max(labels[i][0], labels[i - 1][0] + 15)
    return labels


def lines_chart(title, across, up, lines):
    """`lines`: name and points of each."""
    axes = Axes([point for _, points in lines for point in points])
    text = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(title)}">\n', STYLE,
            f'  <text class="title" x="{LEFT}" y="20">{escape(title)}</text>\n',
            f'  <text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 10}" text-anchor="middle">{escape(across)}</text>\n',
            f'  <text x="{LEFT - 8}" y="20" text-anchor="end">{escape(up)}</text>\n']
    for power in axes.powers:
        _, y = axes.place(math.exp(axes.x[0]), 10.0**power)
        name = f"{10.0**power:g}" if -3 <= power <= 5 else f"1e{power}"
        text.append(f'  <path class="grid" d="M{LEFT} {y:.1f} H{WIDTH - RIGHT}"/>\n')
        text.append(f'  <text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{name}</text>\n')
    for x in sorted({x for _, points in lines for x, _ in points}):
        place, _ = axes.place(x, 10.0**axes.powers[0])
        text.append(f'  <path class="grid" d="M{place:.1f} {TOP} V{HEIGHT - BOTTOM}"/>\n')
        text.append(f'  <text x="{place:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{x:g}</text>\n')
    labels = []
    for number, (name, points) in enumerate(lines):
        colour = COLOURS[number % len(COLOURS)]
        places = [axes.place(*point) for point in sorted(points)]
        text.append(f'  <path fill="none" stroke="{colour}" stroke-width="2" d="M{" L".join(f"{x:.1f} {y:.1f}" for x, y in places)}"/>\n')
        text += [mark(number, x, y, colour) for x, y in places]
        labels.append([places[-1][1] + 4, number, name, colour])
    # In a column, in the order in which the lines end.
    for y, number, name, colour in apart(labels):
        text.append(mark(number, WIDTH - RIGHT + 18, y - 4, colour))
        text.append(f'  <text x="{WIDTH - RIGHT + 28}" y="{y:.1f}">{escape(name)}</text>\n')
    return "".join(text) + "</svg>\n"
