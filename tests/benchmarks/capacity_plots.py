"""Plots of the capacity page: both axes logarithmic, as SVG in the look of the other pages."""
import html
import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 420, 260, 52, 84, 22, 40


def short(value):
    """A figure of two digits with its thousands as a letter."""
    for step, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= step * 0.999:
            return f"{value / step:.3g} {letter}"
    return f"{value:.3g}"


def ticks(low, high):
    """Powers of ten within; where there are few also steps between."""
    for steps in ((1,), (1, 3), (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 6, 7, 8)):
        found = [step * 10.0 ** power for power in range(math.floor(math.log10(low)) - 1,
                                                         math.ceil(math.log10(high)) + 1)
                 for step in steps]
        found = [tick for tick in found if low <= tick <= high]
        if len(found) >= 3:
            break
    return found


class Axis:
    def __init__(self, values, first, last):
        self.low, self.high = min(values) / 1.2, max(values) * 1.2
        self.first, self.last = first, last

    def at(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.first + share * (self.last - self.first)


def text(kind, x, y, words):
    return f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}">{html.escape(words)}</text>'


def path(kind, points, loose=False):
    """A line through the points, or dots."""
    if loose:
        data = "".join(f"M{x:.1f},{y:.1f}h0" for x, y in points)
    else:
        data = "M" + "L".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<path class="{kind}" d="{data}"/>'


def plot(title, across, up, series):
    """A figure. `series`: name -> (points shown as dots, points of a line)."""
    every = [p for dots, line in series.values() for p in (*dots, *line)]
    x = Axis([p[0] for p in every], LEFT, WIDTH - RIGHT)
    y = Axis([p[1] for p in every], HEIGHT - BOTTOM, TOP)
    parts = []
    for tick in ticks(y.low, y.high):
        parts.append(path("grid", [(LEFT, y.at(tick)), (WIDTH - RIGHT, y.at(tick))]))
        parts.append(text("y", LEFT - 6, y.at(tick) + 4, short(tick)))
    bottom = HEIGHT - BOTTOM
    parts.append(path("ends", [(LEFT, bottom), (WIDTH - RIGHT, bottom)]))
    for tick in ticks(x.low, x.high):
        parts.append(path("ends", [(x.at(tick), bottom), (x.at(tick), bottom + 4)]))
        parts.append(text("x", x.at(tick), bottom + 17, short(tick)))
    ends, words = [], []
    for number, (name, (dots, line)) in enumerate(series.items()):
        parts.append(path(f"line s{number}", [(x.at(a), y.at(b)) for a, b in line]))
        parts.append(path(f"dots s{number}", [(x.at(a), y.at(b)) for a, b in dots], loose=True))
        ends.append([y.at(line[-1][1]), number, name])
        words.append(name + ": " + ", ".join(f"{short(a)}: {short(b)}" for a, b in dots or line))
    ends.sort()
    for above, below in zip(ends, ends[1:]):
        below[0] = max(below[0], above[0] + 14)
    for place, number, name in ends:
        parts.append(text(f"label s{number}", WIDTH - RIGHT + 6, place + 4, name))
    parts.append(text("x", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 6, across))
    parts.append(text("name", 0, TOP - 8, up))
    return (f'<svg class="chart" viewBox="0 0 {WIDTH} {HEIGHT}" role="img"><title>'
            f'{html.escape(title)}</title><desc>{html.escape(". ".join(words))}</desc>'
            f'{"".join(parts)}</svg>')
