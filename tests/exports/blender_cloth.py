"""A garment as exported is cloth to Blender, which runs this:

  blender --background --factory-startup --python-exit-code 1 --python blender_cloth.py -- FOLDER

FOLDER is a result of `regarment fit`. garment-1.obj and garment-1.glb are read by Blender's own
importers, get its cloth modifier, hang by their upper edge and fall for some frames. The edges must
stay near the lengths that the flat coordinates (UV, metres) give them, which Blender does not know:
it takes its rest lengths from the mesh as it lies on the body."""
import os
import statistics
import sys

import bmesh
import bpy
import numpy

# The glTF importer of Blender 3.4 uses a name that Debian 12's numpy no longer has.
if not hasattr(numpy, "bool"):
    numpy.bool = bool

FRAMES = 8
DENSITY = 0.2        # kg/m^2, as the exports say
PINNED = 0.04        # m below the highest point: what holds the garment
DRAPED = (0.03, 0.12)  # median and 95 % of |length / flat - 1|: worn cloth is stretched, and folds
                       # of a drape that has come to rest are no shorter
FALLEN = (0.03, 0.15)  # the same after the fall: springs give a little under the weight
folder = sys.argv[sys.argv.index("--") + 1]
failures = []


def imported(name):
    """The one mesh of a file, sewn: vertices of one place are one."""
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    path = os.path.join(folder, name)
    if name.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    if len(meshes) != 1:
        sys.exit(f"FAILED: {name} has {len(meshes)} meshes")
    garment = meshes[0]
    bpy.context.view_layer.objects.active = garment
    sewn = bmesh.new()
    sewn.from_mesh(garment.data)
    bmesh.ops.remove_doubles(sewn, verts=sewn.verts, dist=1e-6)
    sewn.to_mesh(garment.data)
    sewn.free()
    return garment


def flat_lengths(mesh):
    """Length of each edge in the flat coordinates, by its two vertices."""
    uv = mesh.uv_layers.active.data
    out = {}
    for face in mesh.polygons:
        corners = list(face.loop_indices)
        for a, b in zip(corners, corners[1:] + corners[:1]):
            ends = tuple(sorted((mesh.loops[a].vertex_index, mesh.loops[b].vertex_index)))
            out[ends] = (uv[a].uv - uv[b].uv).length
    return out


def strains(points, lengths):
    return sorted(abs((points[a] - points[b]).length / flat - 1)
                  for (a, b), flat in lengths.items())


def check_strains(what, points, lengths, limits):
    all_strains = strains(points, lengths)
    median, most = statistics.median(all_strains), all_strains[int(0.95 * len(all_strains))]
    print(f"{what}: {len(points)} vertices, median strain {median:.4f}, 95 % below {most:.4f}")
    if not (median < limits[0] and most < limits[1]):
        failures.append(f"{what}: edges are not as long as their flat coordinates say")


def hang(garment):
    """Makes it cloth that its highest vertices hold."""
    points = [garment.matrix_world @ v.co for v in garment.data.vertices]
    top = max(p.z for p in points)
    held = garment.vertex_groups.new(name="held")
    held.add([i for i, p in enumerate(points) if p.z > top - PINNED], 1.0, "REPLACE")
    cloth = garment.modifiers.new("cloth", "CLOTH")
    area = sum(face.area for face in garment.data.polygons)
    cloth.settings.mass = DENSITY * area / len(points)
    cloth.settings.quality = 8
    cloth.settings.tension_stiffness = cloth.settings.compression_stiffness = 80
    cloth.settings.shear_stiffness = 80
    cloth.settings.vertex_group_mass = "held"
    cloth.collision_settings.use_collision = False
    return points


def fallen(garment):
    """Where the vertices are after the last frame."""
    scene = bpy.context.scene
    for frame in range(1, FRAMES + 1):
        scene.frame_set(frame)
    now = garment.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [now.matrix_world @ v.co for v in now.data.vertices]


counts = []
for name in ("garment-1.obj", "garment-1.glb"):
    garment = imported(name)
    lengths = flat_lengths(garment.data)
    before = hang(garment)
    counts.append((len(before), len(lengths)))
    check_strains(f"{name} as worn", before, lengths, DRAPED)
    after = fallen(garment)
    check_strains(f"{name} after {FRAMES} frames", after, lengths, FALLEN)
    moved = [(a - b).length for a, b in zip(before, after)]
    print(f"{name}: moved {max(moved):.3f} m at most")
    # It is simulated, and what holds it does.
    if not 0.001 < max(moved) < 0.5:
        failures.append(f"{name}: moved {max(moved)} m")
    lowest = min(after, key=lambda p: p.z).z
    if not lowest < min(p.z for p in before) + 0.05:
        failures.append(f"{name}: does not hang down, but ends at {lowest} m")
if counts[0] != counts[1]:
    failures.append(f"OBJ and GLB are different cloth: {counts}")
for failure in failures:
    print("FAILED:", failure)
sys.exit(1 if failures else 0)
