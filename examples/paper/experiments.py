"""What is run: one entry per fit, by the experiment of the paper it belongs to."""

from dataclasses import dataclass, field

MESH, CLOUD = "mesh", "cloud"

# The paper's tables on scans that mirror them: (table, experiment) -> scan.
TABLES = {
    1: ["skirt-1", "skirt-2", "skirt-3"],
    2: ["tshirt-1", "tshirt-2", "tshirt-3", "tshirt-4"],
    3: ["corrupt-1", "corrupt-2"],
    4: ["layered-1", "layered-2"],
}


@dataclass
class Fit:
    """One run of `regarment fit`."""

    name: str  # of the result, a file name
    scan: str  # "skirt-1.mesh"
    garments: list
    method: str = "joint"
    options: list = field(default_factory=list)
    free: str = ""  # the one dimension that is searched, the others held at their true sizes
    pictures: list = field(default_factory=list)  # "drape-front": kept for the page


def garments_of(stem):
    if stem.startswith("layered"):
        return ["tshirt", "skirt"]
    return ["tshirt"] if stem.startswith("tshirt") else ["skirt"]


def joint_fits():
    """Every scan of the tables, mesh and cloud, by the method joint."""
    pictures = {1: ["scan-front", "segmentation-front", "pattern-1.svg"],
                2: ["segmentation-front", "pattern-1.svg"],
                3: ["scan-front", "scan-back", "filled-front", "filled-back"],
                4: ["segmentation-front"]}
    return [Fit(f"joint.{stem}.{kind}", f"{stem}.{kind}", garments_of(stem),
                pictures=pictures[table] if kind == MESH or table == 3 else [])
            for table, stems in TABLES.items() for stem in stems for kind in (MESH, CLOUD)]


def annealing_fits(runs, evaluations):
    """The same by the paper's search: meshes, Table 1 without our departures, clouds."""
    effort = ["--runs", str(runs), "--evaluations", str(evaluations)]
    tag = f"{runs}x{evaluations}"

    def search(stem, kind, name="annealing", options=(), pictures=()):
        return Fit(f"{name}-{tag}.{stem}.{kind}", f"{stem}.{kind}", garments_of(stem), "annealing",
                   effort + list(options), pictures=list(pictures))

    stems = [stem for table in TABLES.values() for stem in table]
    return ([search(stem, MESH, pictures=["segmentation-front"]) for stem in stems] +
            [search(stem, MESH, "printed", ["--as-printed"]) for stem in TABLES[1]] +
            [search(stem, CLOUD) for stem in stems])


# One dimension is searched, all others are held at their true sizes: what a variant does to it
# shows without the luck of a search in four or five dimensions, and costs twenty drapes.
SINGLE = ["--runs", "1", "--evaluations", "20", "--no-rough-search"]
SKIRT = ["length", "width", "waist", "hip"]


def single(variant, stem, kind, free, options, pictures=()):
    return Fit(f"single.{variant}.{stem}.{kind}.{free}", f"{stem}.{kind}", garments_of(stem),
               "annealing", SINGLE + options, free, list(pictures))


def contact_fits():
    """Contact on and off, every dimension of the skirts of Table 1 [sec. 3.2]."""
    return [single(variant, stem, MESH, free, options)
            for stem in TABLES[1] for free in SKIRT
            for variant, options in (("usual", []), ("contact", ["--collisions"]))]


def root_fits():
    """Without the square root of Eq. (1) [sec. 3.3]."""
    return [single("no-root", stem, MESH, free, ["--no-square-root"])
            for stem in TABLES[1] for free in SKIRT]


def attraction_fits():
    """Closest point against similar normals [sec. 3.4, Fig. 4]."""
    pictures = ["placement-front", "drape-front"]
    return [single(variant, stem, MESH, "sleeve_length", options,
                   pictures if stem == "tshirt-1" else ())
            for stem in TABLES[2]
            for variant, options in (
                ("normals", ["--free-edges"]),
                ("closest", ["--free-edges", "--attraction", "closest"]))]


def cap_fits():
    """Closed and open meshes [sec. 3.4, Fig. 5]: edges slide, as the paper's do."""
    pictures = ["drape-front", "drape-left"]
    closed = [("cap-masked", ["--free-edges"]),
              ("cap-kept", ["--free-edges", "--no-cap-detection"])]
    open_ = [("border-rejected", ["--free-edges"]),
             ("border-attracts", ["--free-edges", "--no-border-rejection"])]
    out = [single(v, stem, MESH, "length", o, pictures)
           for stem in ("skirt-1", "skirt-2") for v, o in closed]
    return out + [single(v, "skirt-3", MESH, "length", o, pictures) for v, o in open_]


def cloud_fits():
    """The same search on the point clouds [sec. 3.4]."""
    return [single("usual", stem, CLOUD, free, []) for stem in TABLES[1] for free in SKIRT]


def all_fits(runs, evaluations):
    """In order of what they cost."""
    return (attraction_fits() + cap_fits() + contact_fits() + joint_fits() + root_fits() +
            cloud_fits() + annealing_fits(runs, evaluations))
