"""The figures of the paper, one section each."""

from experiments import CLOUD, MESH, SKIRT, TABLES


def section(key, title, body):
    return f"<section id=\"{key}\"><h2>{title}</h2>{body}</section>"


def patterns(page):
    pictures = page.pictures
    shown = pictures.row([("joint.skirt-1.mesh.scan-front", "skirt-1: the scan"),
                          ("joint.skirt-1.mesh.segmentation-front", "dressed and naked parts"),
                          ("joint.tshirt-1.mesh.segmentation-front", "tshirt-1")])
    drawings = (pictures.drawing("joint.skirt-1.mesh.pattern-1.svg",
                                 "Skirt: each circumference is shared out to front and back")
                + pictures.drawing("joint.tshirt-1.mesh.pattern-1.svg",
                                   "T-shirt: the neckline is not searched, as in the paper"))
    return section(
        "patterns", "Figs. 1 to 3: segmentation, patterns, a change of length",
        "<p>The scan is taken apart by the garment that was fitted (Fig. 1), whose pattern has the "
        "paper's dimensions (Fig. 2).</p>" + shown + f"<div class=\"half\">{drawings}</div>"
        + page.length_change())


def attraction(page):
    table = page.variant_table(
        "Sleeve length by closest point and by normals",
        [("normals", "similar normals"), ("closest", "closest point")],
        [(stem, MESH, "sleeve_length") for stem in TABLES[2]])
    name = "single.{}.tshirt-1.mesh.sleeve_length.{}"
    shown = page.pictures.row(
        [(name.format("normals", "placement-front"), "Where the T-shirt starts"),
         (name.format("closest", "drape-front"), "Drawn to the closest point"),
         (name.format("normals", "drape-front"), "Drawn to similar normals")], "arms")
    return section("fig4", "Fig. 4: closest point against similar normals",
                   "<p>The sleeve's length is searched alone, all other dimensions held at their "
                   "true sizes, edges free as in the paper. Small: mean distance to the scan and "
                   "time steps of all drapes.</p>" + shown + table)


def caps(page):
    table = page.variant_table(
        "Length on closed meshes", [("cap-masked", "cap masked"), ("cap-kept", "cap kept")],
        [(stem, MESH, "length") for stem in ("skirt-1", "skirt-2")])
    open_table = page.variant_table(
        "Length on an open mesh", [("border-rejected", "border does not attract"),
                                   ("border-attracts", "border attracts")],
        [("skirt-3", MESH, "length")])
    name = "single.{}.{}.mesh.length.drape-left"
    shown = page.pictures.row(
        [(name.format("cap-kept", "skirt-1"), "Closed mesh, cap kept"),
         (name.format("cap-masked", "skirt-1"), "Cap found and masked"),
         (name.format("border-attracts", "skirt-3"), "Open mesh, border attracts"),
         (name.format("border-rejected", "skirt-3"), "Open mesh, border rejected")], "hems")
    return section("fig5", "Fig. 5: what closes a mesh under the hem",
                   "<p>The authors cut the surface between hem and legs out by hand; here it is "
                   "found and masked. Length searched alone, edges free.</p>" + shown + table
                   + open_table)


def holes(page):
    wanted = []
    for stem in TABLES[3]:
        for kind in (MESH, CLOUD):
            for view in ("front", "back"):
                wanted.append((f"joint.{stem}.{kind}.scan-{view}", f"{stem} {kind}, {view}"))
                wanted.append((f"joint.{stem}.{kind}.filled-{view}", "holes closed by the cloth"))
    kept = [(name, caption) for name, caption in wanted
            if page.pictures.exists(name.replace("scan-", "filled-"))]
    return section("fig6", "Fig. 6: holes closed by the fitted garment",
                   "<p>By the method joint. What was added is orange; it shares the border's "
                   "vertices, so nothing gapes. corrupt-2 as a mesh was closed by its "
                   "reconstruction and has no holes left.</p>" + page.pictures.row(kept))


def contact(page):
    return section("contact", "Contact on and off (section 3.2)",
                   "<p>One dimension searched, the others held at their true sizes.</p>"
                   + page.variant_table("Contact on and off",
                                        [("usual", "without contact"), ("contact", "with contact")],
                                        [(stem, MESH, free) for stem in TABLES[1]
                                         for free in SKIRT]))


def error(page):
    return section(
        "error", "The error of Eq. (1)",
        "<p>E<sub>sil</sub> divides what differs between the person's silhouette and the garment's "
        "by the garment's. The person is much larger than the garment, so what differs, N, is "
        "larger than the garment, G, and (N + a) / (G + a) falls with every added a, even where "
        "the added cloth lies outside of the person. A larger garment is rewarded.</p>"
        + page.curves() + page.variant_table(
            "With and without the square root",
            [("usual", "with the root"), ("no-root", "without")],
            [(stem, MESH, free) for stem in TABLES[1] for free in SKIRT]))


def clouds(page):
    rows = page.variant_table(
        "Mesh and cloud", [("usual", "searched alone")],
        [(stem, CLOUD, free) for stem in TABLES[1] for free in SKIRT])
    return section("clouds", "Mesh against cloud (section 3.4)",
                   "<p>The paper's search on clouds, to be read beside the column “without "
                   "contact” above, which is of the meshes of the same scans.</p>" + rows)


def figures(page):
    return (patterns(page) + attraction(page) + caps(page) + holes(page) + contact(page)
            + error(page) + clouds(page))
