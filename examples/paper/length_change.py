"""Fig. 3: how one change of length moves the pattern's triangles, as a drawing."""

import json
import subprocess

SIZES = ("length=62,width=112,sleeve_length=17,sleeve_opening=40,sleeve_seam=44",
         "length=76,width=112,sleeve_length=17,sleeve_opening=40,sleeve_seam=44")


def pattern(binary, sizes):
    done = subprocess.run([binary, "templates", "tshirt", "--at", sizes, "--json"], check=True,
                          capture_output=True, text=True)
    return json.loads(done.stdout)["pattern"]


def front(pattern_):
    """Points of the front and the sleeves' front halves: the panels drawn unmirrored on top."""
    wanted = {i for i, name in enumerate(pattern_["panels"]) if "front" in name.lower()}
    return [panel in wanted for panel in pattern_["panel_of_point"]]


def paths(points, triangles):
    return "".join("M" + "L".join(f"{points[v][0]:.2f},{points[v][1]:.2f}" for v in t) + "Z"
                   for t in triangles)


def write_length_change(binary, path):
    before, after = (pattern(binary, sizes) for sizes in SIZES)
    shown = front(before)
    fine = [t for t in before["triangles"] if all(shown[v] for v in t)]
    coarse = sorted({tuple(sorted(t)) for t, keep
                     in zip(before["coarse_triangle_of_point"], shown) if keep})
    views = [(before["coarse_points_cm"], coarse, .3), (before["points_cm"], fine, .12),
             (after["points_cm"], fine, .12), (after["coarse_points_cm"], coarse, .3)]
    width = 2 * max(abs(p[0]) for p, keep in zip(before["points_cm"], shown) if keep) + 6
    height = max(p[1] for p in after["points_cm"]) + 16
    parts = []
    for k, (points, triangles, stroke) in enumerate(views):
        parts.append(f'<g transform="translate({width * (k + .5):.1f} 4)">'
                     f'<path d="{paths(points, triangles)}" stroke-width="{stroke}"/>'
                     f'<text y="{height - 6:.1f}">{"abcd"[k]}</text></g>')
    with open(path, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {4 * width:.1f} '
                   f'{height:.1f}"><style>svg{{background:#fff}}path{{fill:none;stroke:#0a5f73;'
                   'stroke-linejoin:round}text{font:5px sans-serif;text-anchor:middle}</style>'
                   + "".join(parts) + "</svg>\n")
