"""Each claim of the paper that can be put to a test, with the figures and what they say."""

from experiments import CLOUD, MESH, SKIRT, TABLES
from markup import number
from results import mean, mean_error

NOT_RUN = ("not run yet", ("none", "–"))


def yes(word="confirmed"):
    return ("yes", word)


def no(word="not confirmed"):
    return ("no", word)


def partly(word):
    return ("part", word)


def cm(value, sign=False):
    return f"{number(value, 1, sign)} cm"


def pairs(results, one, two, cases):
    """Entries and garments of two variants where both were run."""
    out = []
    for stem, kind, free in cases:
        first, second = results.single(one, stem, kind, free), results.single(two, stem, kind, free)
        if first[0] and second[0]:
            out.append((stem, free, first, second))
    return out


def contact(results):
    found = pairs(results, "usual", "contact",
                  [(s, MESH, f) for s in TABLES[1] for f in SKIRT])
    if not found:
        return NOT_RUN
    off = mean([a[0]["error_cm"] for _, _, a, _ in found])
    on = mean([b[0]["error_cm"] for _, _, _, b in found])
    larger = sum(b[0]["value_cm"] > a[0]["value_cm"] for _, _, a, b in found)
    text = (f"Mean error {cm(off, True)} without, {cm(on, True)} with contact; larger with it in "
            f"{larger} of {len(found)} searches of one dimension")
    return text, yes() if on > off and larger > len(found) / 2 else no()


def contact_slows(results):
    found = pairs(results, "usual", "contact",
                  [(s, MESH, f) for s in TABLES[1] for f in SKIRT])
    if not found:
        return NOT_RUN
    off = sum(a[1]["drape_steps"] for _, _, a, _ in found)
    on = sum(b[1]["drape_steps"] for _, _, _, b in found)
    return (f"{on / off:.2f} times as many time steps to rest with contact, {len(found)} searches",
            yes() if on > 1.1 * off else no())


def normals(results):
    found = pairs(results, "normals", "closest", [(s, MESH, "sleeve_length") for s in TABLES[2]])
    if not found:
        return NOT_RUN
    by_normals = mean_error([a[0]["error_cm"] for _, _, a, _ in found])
    closest = mean_error([b[0]["error_cm"] for _, _, _, b in found])
    each = "; ".join(f"{stem} {number(a[0]['error_cm'], 1, True)} against "
                     f"{number(b[0]['error_cm'], 1, True)}" for stem, _, a, b in found)
    text = (f"Sleeve length off by {cm(by_normals)} with similar normals, {cm(closest)} with the "
            f"closest point ({each})")
    if len(found) > 1 and by_normals < closest:
        return text, yes()
    mixed = any(abs(a[0]["error_cm"]) < abs(b[0]["error_cm"]) for _, _, a, b in found)
    return text, partly("on some scans") if mixed else no()


def cap(results):
    found = pairs(results, "cap-masked", "cap-kept", [(s, MESH, "length") for s in TABLES[1]])
    if not found:
        return NOT_RUN
    each = "; ".join(f"{stem} {number(a[0]['error_cm'], 1, True)} masked, "
                     f"{number(b[0]['error_cm'], 1, True)} kept, E_dist "
                     f"{number(1000 * a[1]['error']['distance_m'], 2)} and "
                     f"{number(1000 * b[1]['error']['distance_m'], 2)} mm"
                     for stem, _, a, b in found)
    worse = any(abs(b[0]["error_cm"]) > abs(a[0]["error_cm"]) + 0.5 for _, _, a, b in found)
    return f"Error of the length, cm: {each}", yes() if worse else no("not in the length")


def border(results):
    found = pairs(results, "border-rejected", "border-attracts", [("skirt-3", MESH, "length")])
    if not found:
        return NOT_RUN
    _, _, a, b = found[0]
    text = (f"skirt-3, open: length off by {cm(a[0]['error_cm'], True)} when the border does not "
            f"attract, {cm(b[0]['error_cm'], True)} when it does")
    more = abs(b[0]["error_cm"]) > abs(a[0]["error_cm"]) + 0.3
    return text, partly("weakly, one scan") if more else no()


def upper_edge(results, effort):
    errors = []
    for stem in TABLES[1]:
        entry = results.measurements(f"annealing-{effort}.{stem}.mesh").get("length")
        if entry:
            errors.append(entry["error_cm"])
    joint = [results.measurements(f"joint.{s}.{k}").get("length") for s in TABLES[1]
             for k in (MESH, CLOUD)]
    joint = [e["error_cm"] for e in joint if e]
    if not errors:
        return NOT_RUN
    text = (f"Annealing: length off by {', '.join(number(e, 1, True) for e in errors)} cm, as in "
            "the paper (+2, +5, +8) on the long side")
    if joint:
        text += (f"; joint, which finds the edge by its step: {cm(mean_error(joint))} mean "
                 f"absolute error of {len(joint)}")
    shown = yes("the errors, not the cause") if min(errors) > 0 else partly("partly")
    return text, shown


def root(results):
    found = pairs(results, "usual", "no-root", [(s, MESH, f) for s in TABLES[1] for f in SKIRT])
    if not found:
        return NOT_RUN
    with_root = mean_error([a[0]["error_cm"] for _, _, a, _ in found])
    without = mean_error([b[0]["error_cm"] for _, _, _, b in found])
    text = (f"Mean absolute error {cm(with_root)} with the root, {cm(without)} without, "
            f"{len(found)} searches; the curve below shows the sharper valley")
    return text, yes("better with it") if with_root < without - 0.3 else partly(
        "the valley, not the sizes")


def silhouette(results):
    slopes = []
    for stem in TABLES[1]:
        for free in ("length", "width"):
            found, garment = results.single("usual", stem, MESH, free)
            if found:
                tried = garment["evaluations"]
                order = sorted(zip(tried[free + "_cm"], tried["silhouette"]))
                least = min(order, key=lambda p: p[1])[0]
                slopes.append((stem, free, found["truth_cm"], least, order[-1][0]))
    if not slopes:
        return NOT_RUN
    each = "; ".join(f"{stem} {free}: smallest at {number(least)} cm (true {number(truth)}, tried "
                     f"up to {number(top)})" for stem, free, truth, least, top in slopes)
    larger = sum(least > truth for _, _, truth, least, _ in slopes)
    return (f"E_sil by itself: {each}",
            partly("it favours larger garments") if larger > len(slopes) / 2 else yes())


def table_claim(results, effort, key, paper):
    template = "tshirt" if key == 2 else "skirt"
    found = {}
    for method, kinds in ((f"annealing-{effort}", (MESH,)), ("joint", (MESH, CLOUD))):
        errors = [m["error_cm"] for s in TABLES[key] for k in kinds
                  for m in results.measurements(f"{method}.{s}.{k}", template).values()
                  if m["observable"]]
        if errors:
            found[method.split("-")[0]] = (mean_error(errors), len(errors))
    words = "; ".join(f"{name} {cm(error)} of {count}" for name, (error, count) in found.items())
    return f"Mean absolute error: paper {cm(paper)}; {words or 'not run yet'}", found


def corruption(results, effort):
    text, found = table_claim(results, effort, 3, 5.3)
    if not found:
        return NOT_RUN
    if found.get("annealing", (99, 0))[0] <= 5.3:
        return text, yes()
    return text, partly("by joint; not by so short a search") if found.get(
        "joint", (99, 0))[0] <= 5.3 else no()


def layers(results, effort):
    hidden, visible = [], []
    for stem in TABLES[4]:
        for kind in (MESH, CLOUD):
            for m in results.measurements(f"joint.{stem}.{kind}", "skirt").values():
                (visible if m["observable"] else hidden).append(m)
    if not visible and not hidden:
        return NOT_RUN
    by_name = sorted({m["name"] for m in hidden})
    errors = mean_error([m["error_cm"] for m in visible])
    return (f"Joint calls {', '.join(by_name) or 'nothing'} hidden; what it calls visible is off "
            f"by {cm(errors)} (paper, all: 19.4 cm)", yes())


def segmentation(results, effort):
    by_distance = mean([results.mean_iou(f"annealing-{effort}.{s}.mesh")
                        for t in (1, 2) for s in TABLES[t]])
    by_cut = mean([results.mean_iou(f"joint.{s}.{k}") for t in (1, 2) for s in TABLES[t]
                   for k in (MESH, CLOUD)])
    if by_distance is None:
        return NOT_RUN
    text = f"Mean IoU of the labels {by_distance:.3f} by distance"
    if by_cut is not None:
        text += f", {by_cut:.3f} by a minimum cut after the joint fit"
    return text, yes("nearly") if by_distance > 0.9 else no()


def clouds(results):
    found = []
    for stem in TABLES[1]:
        for free in SKIRT:
            mesh = results.single("usual", stem, MESH, free)[0]
            cloud = results.single("usual", stem, CLOUD, free)[0]
            if mesh and cloud:
                found.append((mesh["error_cm"], cloud["error_cm"]))
    if not found:
        return NOT_RUN
    of_mesh, of_cloud = mean_error([m for m, _ in found]), mean_error([c for _, c in found])
    return (f"Mean absolute error {cm(of_mesh)} on meshes, {cm(of_cloud)} on clouds, "
            f"{len(found)} searches of one dimension",
            yes() if of_mesh < of_cloud - 0.3 else no("no difference in the sizes")
            if abs(of_mesh - of_cloud) <= 0.3 else no())


def claims(results, effort):
    """(where, claim, figures, (class, word)) in the paper's order."""
    def row(where, claim, found):
        return (where, claim, *found)

    return [
        row("sec. 3.2", "Collisions make the dimensions too large", contact(results)),
        row("sec. 3.2", "Collisions slow the simulation", contact_slows(results)),
        row("sec. 3.3", "The square root emphasises the valleys of the error", root(results)),
        row("sec. 3.3", "E_sil measures the difference in the silhouettes", silhouette(results)),
        row("sec. 3.4, Fig. 4", "Attraction to similar normals expands the sleeve",
            normals(results)),
        row("sec. 3.4", "On meshes cloth slides more easily than on clouds", clouds(results)),
        row("sec. 3.4, Fig. 5", "A hem folds onto the surface that closes a mesh", cap(results)),
        row("sec. 3.4", "Without that surface the hem is pushed to the scan's border",
            border(results)),
        row("sec. 3.5", "A threshold of distance segments the scan",
            segmentation(results, effort)),
        row("Table 1", "Lengths come out too long, for the upper edge cannot be told",
            upper_edge(results, effort)),
        row("Table 3", "Sizes are found in spite of severe corruption",
            corruption(results, effort)),
        row("Table 4", "Length and waist of a covered skirt cannot be found",
            layers(results, effort)),
    ]
