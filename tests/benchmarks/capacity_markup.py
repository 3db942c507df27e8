"""Pieces of the capacity page: figures with their units, tables, sections. Text is escaped here."""
import html
import math


def about(value):
    """Two digits that count."""
    step = 10 ** max(0, math.floor(math.log10(value)) - 1)
    return figure(step * round(value / step), 2)


def figure(value, digits=3):
    """So many digits that count, thousands apart."""
    if value >= 10 ** digits:
        return f"{value:,.0f}"
    return f"{value:.{digits}g}" if value >= 0.001 else f"{value:.1e}"


def size(value):
    for step, unit in ((1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if value >= step:
            return f"{figure(value / step)}\u00a0{unit}"
    return f"{value:.0f}\u00a0B"


def duration(seconds):
    for step, unit in ((2 * 365.25 * 86400, "years"), (2 * 86400, "days"), (2 * 3600, "hours"),
                       (120, "min")):
        if seconds >= step:
            one = {"years": 365.25 * 86400, "days": 86400, "hours": 3600, "min": 60}[unit]
            return f"{figure(seconds / one)}\u00a0{unit}"
    if seconds >= 0.1:
        return f"{figure(seconds)}\u00a0s"
    return f"{figure(1000 * seconds)}\u00a0ms"


def table(caption, heads, rows):
    """Rows of plain text, the first cell its head; a phone shows each row as a block."""
    out = [f'<table class="plain dense sparse"><caption class="unseen">{html.escape(caption)}'
           "</caption><thead><tr>"]
    out += [f'<th scope="col"{"" if i == 0 else " class=n"}>{html.escape(head)}</th>'
            for i, head in enumerate(heads)]
    out.append("</tr></thead><tbody>")
    for first, *cells in rows:
        out.append(f'<tr><th scope="row">{html.escape(first)}</th>')
        out += [f'<td class="n" data-name="{html.escape(head)}">{html.escape(cell)}</td>'
                for head, cell in zip(heads[1:], cells)]
        out.append("</tr>")
    return "".join(out) + "</tbody></table>"


def section(name, title, *parts):
    return (f'<section id="{name}" aria-labelledby="{name}-title"><h2 id="{name}-title">'
            f'{html.escape(title)}</h2>{"".join(parts)}</section>')


def lead(words):
    return f'<p class="lead">{html.escape(words)}</p>'


def keys(facts):
    return ('<dl class="keys">' + "".join(
        f'<div><dt>{html.escape(name)}</dt><dd>{html.escape(value)}<span class="note">'
        f'{html.escape(note)}</span></dd></div>' for name, value, note in facts) + "</dl>")
