"""Pieces of the page: tables, pictures, charts. All text is escaped here."""

import base64
import html
import os


def text(value):
    return html.escape(str(value), quote=True)


def number(value, digits=1, sign=False):
    """A figure with a true minus; a dash where there is none."""
    if value is None:
        return "–"
    # Half a step is rounded away from zero, as people do; nothing has no sign.
    value += (1e-9 if value > 0 else -1e-9)
    if abs(value) < 0.5 * 10 ** -digits:
        return f"{0:.{digits}f}"
    shown = f"{value:{'+' if sign else ''}.{digits}f}"
    return shown.replace("-", "−")


def table(head, rows, label, kind=""):
    """`rows` hold cells: text or (text, class); a row may be ("sum", cells)."""
    def cell(content, tag):
        inner, name = content if isinstance(content, tuple) else (content, "")
        return f"<{tag}{f' class={chr(34)}{name}{chr(34)}' if name else ''}>{inner}</{tag}>"

    body = []
    for row in rows:
        name, cells = row if isinstance(row, tuple) and isinstance(row[1], list) else ("", row)
        first = f"<th scope=\"row\">{cells[0]}</th>"
        body.append(f"<tr{f' class={chr(34)}{name}{chr(34)}' if name else ''}>{first}"
                    + "".join(cell(c, "td") for c in cells[1:]) + "</tr>")
    heads = "".join(cell(h, "th").replace("<th", "<th scope=\"col\"", 1) for h in head)
    return (f"<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"{text(label)}\">"
            f"<table class=\"{kind}\"><thead><tr>{heads}</tr></thead>"
            f"<tbody>{''.join(body)}</tbody></table></div>")


class Pictures:
    """Pictures of a folder, put into the page."""

    def __init__(self, folder):
        self.folder = folder

    def exists(self, name):
        return os.path.exists(os.path.join(self.folder, name + ".jpg"))

    def figure(self, name, caption):
        path = os.path.join(self.folder, name + ".jpg")
        if not self.exists(name):
            return ""
        with open(path, "rb") as file:
            data = base64.b64encode(file.read()).decode()
        return (f"<figure><img src=\"data:image/jpeg;base64,{data}\" width=\"420\" height=\"760\" "
                f"loading=\"lazy\" alt=\"{text(caption)}\"><figcaption>{text(caption)}"
                "</figcaption></figure>")

    def drawing(self, name, caption):
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            return ""
        with open(path, "rb") as file:
            data = base64.b64encode(file.read()).decode()
        return (f"<figure><img src=\"data:image/svg+xml;base64,{data}\" loading=\"lazy\" "
                f"alt=\"{text(caption)}\"><figcaption>{text(caption)}</figcaption></figure>")

    def row(self, wanted, kind=""):
        shown = "".join(self.figure(name, caption) for name, caption in wanted)
        return f"<div class=\"row {kind}\">{shown}</div>" if shown else ""


def nice_ticks(low, high):
    span = (high - low) or 1.0
    step = 10 ** len(str(int(span))) / 10
    while span / step < 3:
        step /= 2
    first = int(low / step) * step
    ticks = [first + k * step for k in range(40)]
    return [t for t in ticks if low - 1e-9 <= t <= high + 1e-9]


def scatter(series, truth, x_title, y_title, label):
    """Dots over one axis: `series` is a list of (class, name, points)."""
    points = [p for _, _, some in series for p in some]
    if not points:
        return ""
    xs, ys = [p[0] for p in points] + [truth], [p[1] for p in points]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    width, height, left, bottom = 420, 250, 46, 38

    def at(x, y):
        return (left + (x - low_x) / ((high_x - low_x) or 1) * (width - left - 12),
                height - bottom - (y - low_y) / ((high_y - low_y) or 1) * (height - bottom - 34))

    parts = [f"<path class=\"axis\" d=\"M{left},20V{height - bottom}H{width - 8}\"/>"]
    x_truth = at(truth, low_y)[0]
    parts.append(f"<path class=\"truth\" d=\"M{x_truth:.1f},20V{height - bottom}\"/>"
                 f"<text x=\"{x_truth:.1f}\" y=\"14\" text-anchor=\"middle\">true size</text>")
    for tick in nice_ticks(low_x, high_x):
        x = at(tick, low_y)[0]
        parts.append(f"<text x=\"{x:.1f}\" y=\"{height - bottom + 15}\" "
                     f"text-anchor=\"middle\">{tick:g}</text>")
    for y in (low_y, high_y):
        parts.append(f"<text x=\"{left - 6}\" y=\"{at(low_x, y)[1] + 4:.1f}\" "
                     f"text-anchor=\"end\">{y:.2g}</text>")
    for name, _, some in series:
        for x, y in some:
            cx, cy = at(x, y)
            parts.append(f"<circle class=\"{name}\" cx=\"{cx:.1f}\" cy=\"{cy:.1f}\" r=\"3.5\"/>")
    parts.append(f"<text x=\"{(left + width) / 2}\" y=\"{height - 5}\" "
                 f"text-anchor=\"middle\">{text(x_title)}</text>")
    return (f"<figure class=\"chart\"><svg viewBox=\"0 0 {width} {height}\" role=\"img\" "
            f"aria-label=\"{text(label)}\">{''.join(parts)}</svg>"
            f"<figcaption>{text(y_title)}</figcaption></figure>")
