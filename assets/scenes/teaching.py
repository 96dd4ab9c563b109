#!/usr/bin/env python3
"""Writes the scenes that teach as glTF beside this file: assets/scenes/teaching.py

Metres, y up. Walls are rectangles that face into their room: from a corner, one edge, the other, counter-clockwise as
seen from their front. The standard library is enough.
"""
import base64
import json
import math
import pathlib
import struct

IRON = {"n": [2.9, 2.9, 2.9], "k": [3.0, 3.0, 3.0]}  # round numbers; polarizes more than gold
GOLD = {"n": [0.221, 0.428, 1.332], "k": [3.215, 2.460, 1.869]}  # Johnson and Christy 1972, 612, 549, 465 nm


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def scaled(s, a):
    return [s * x for x in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return scaled(1 / math.sqrt(sum(x * x for x in a)), a)


def sheet_turned(degrees_about_y):
    """Edges of length 1 of an upright sheet that faces +z, turned about the vertical."""
    t = math.radians(degrees_about_y)
    return [math.cos(t), 0, -math.sin(t)], [0, 1, 0]


class Writer:
    def __init__(self, name, sentence):
        self.name, self.bytes, self.meshes, self.materials = name, bytearray(), {}, {}
        self.gltf = {"asset": {"version": "2.0", "generator": "teaching.py"}, "scene": 0, "nodes": [], "cameras": [],
                     "scenes": [{"name": name, "nodes": [], "extras": {"note": sentence}}], "meshes": [],
                     "materials": [], "accessors": [], "bufferViews": []}

    # Materials --------------------------------------------------------------------------------------------------------

    def material(self, name, color=(0, 0, 0), roughness=0.0, **more):
        """Lambert; with `ior` a plastic, with `clear` a pane ("pane") or a body ("body"), with `metal` a conductor, with
        `light` a lamp of that radiance, with `filter` a sheet; `two_sided` where both sides are looked at."""
        extensions = {}
        look = {"baseColorFactor": [*color, 1], "metallicFactor": 0, "roughnessFactor": roughness}
        material = {"name": name, "pbrMetallicRoughness": look}
        if "ior" in more:
            extensions["KHR_materials_ior"] = {"ior": more["ior"]}
        elif "metal" in more:
            look["metallicFactor"] = 1
            extensions["BREWSTER_surface"] = {"complexIor": more["metal"]}
        else:
            extensions["KHR_materials_specular"] = {"specularFactor": 0}
        if "clear" in more:
            look["baseColorFactor"] = [1, 1, 1, 1]
            extensions["KHR_materials_transmission"] = {"transmissionFactor": 1}
            if more["clear"] == "body":
                extensions["KHR_materials_volume"] = {"thicknessFactor": 1}
        if "light" in more:
            material["emissiveFactor"] = [1, 1, 1]
            extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": more["light"]}
        if "filter" in more:
            extensions = {"BREWSTER_surface": more["filter"]}
            material["doubleSided"] = True
        if more.get("two_sided"):
            material["doubleSided"] = True
        material["extensions"] = extensions
        self.materials[name] = len(self.gltf["materials"])
        self.gltf["materials"].append(material)
        return name

    def lambert(self, name, *color):
        return self.material(name, color)

    # Shapes -----------------------------------------------------------------------------------------------------------

    def _accessor(self, values, kind):
        whole = kind == "SCALAR"
        width = 1 if whole else 3
        self.gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": 4 * width * len(values)})
        accessor = {"bufferView": len(self.gltf["bufferViews"]) - 1, "componentType": 5125 if whole else 5126,
                    "count": len(values), "type": kind}
        for value in values:
            self.bytes += struct.pack("<I", value) if whole else struct.pack("<3f", *value)
        if not whole:  # the bounds of what is stored, in single precision
            stored = [struct.unpack("<3f", struct.pack("<3f", *value)) for value in values]
            accessor |= {"min": [min(v[k] for v in stored) for k in range(3)], "max": [max(v[k] for v in stored) for k in range(3)]}
        self.gltf["accessors"].append(accessor)
        return len(self.gltf["accessors"]) - 1

    def mesh(self, name, material, positions, indices, normals=None, shape=None):
        """A node of its own. Meshes of one `shape` share their numbers."""
        accessors = self.meshes.get(shape)
        if accessors is None:
            accessors = {"attributes": {"POSITION": self._accessor(positions, "VEC3")},
                         "indices": self._accessor(indices, "SCALAR")}
            if normals:
                accessors["attributes"]["NORMAL"] = self._accessor(normals, "VEC3")
            if shape:
                self.meshes[shape] = accessors
        self.gltf["meshes"].append({"name": name, "primitives": [accessors | {"material": self.materials[material]}]})
        self.gltf["nodes"].append({"name": name, "mesh": len(self.gltf["meshes"]) - 1})
        return self.gltf["nodes"][-1]

    def polygons(self, name, material, polygons):
        """Flat convex polygons, each counter-clockwise from its front."""
        positions, indices = [], []
        for polygon in polygons:
            first = len(positions)
            positions += polygon
            for k in range(2, len(polygon)):
                indices += [first, first + k - 1, first + k]
        self.mesh(name, material, positions, indices)

    def rectangle(self, name, material, corner, edge, other):
        self.polygons(name, material, [[corner, add(corner, edge), add(add(corner, edge), other), add(corner, other)]])

    def prism(self, name, material, outline, low, high):
        """An upright prism over a convex outline of (x, z), counter-clockwise seen from above."""
        top = [[x, high, z] for x, z in outline]
        bottom = [[x, low, z] for x, z in outline]
        sides = [[bottom[k - 1], bottom[k], top[k], top[k - 1]] for k in range(len(outline))]
        self.polygons(name, material, [top, bottom[::-1], *sides])

    def box(self, name, material, low, high):
        outline = [(low[0], high[2]), (high[0], high[2]), (high[0], low[2]), (low[0], low[2])]
        self.prism(name, material, outline, low[1], high[1])

    def sphere(self, name, material, centre, radius, rings=16, sectors=32):
        points, indices = [], []
        for ring in range(rings + 1):
            for sector in range(sectors + 1):
                t, p = math.pi * ring / rings, 2 * math.pi * sector / sectors
                points.append([math.sin(t) * math.sin(p), math.cos(t), math.sin(t) * math.cos(p)])
        for ring in range(rings):
            for sector in range(sectors):
                a = ring * (sectors + 1) + sector
                b = a + sectors + 1
                if ring > 0:
                    indices += [a, b, a + 1]
                if ring < rings - 1:
                    indices += [a + 1, b, b + 1]
        node = self.mesh(name, material, points, indices, points, shape="sphere")
        node |= {"translation": centre, "scale": [radius] * 3}

    def room(self, low, high, floor="wall", walls="wall", ceiling="wall", leave_out=()):
        """Six rectangles that face inwards."""
        (x, y, z), (u, v, w) = low, [h - l for l, h in zip(low, high)]
        for name, material, corner, edge, other in [
                ("floor", floor, [x, y, z + w], [u, 0, 0], [0, 0, -w]), ("ceiling", ceiling, [x, y + v, z], [u, 0, 0], [0, 0, w]),
                ("back", walls, [x, y, z], [u, 0, 0], [0, v, 0]), ("front", walls, [x + u, y, z + w], [-u, 0, 0], [0, v, 0]),
                ("left", walls, [x, y, z + w], [0, 0, -w], [0, v, 0]), ("right", walls, [x + u, y, z], [0, 0, w], [0, v, 0])]:
            if name not in leave_out:
                self.rectangle(name, material, corner, edge, other)

    def camera(self, name, eye, target, field_of_view=45):
        backwards = unit([e - t for e, t in zip(eye, target)])
        right = unit(cross([0, 1, 0], backwards))
        up = cross(backwards, right)
        self.gltf["cameras"].append({"name": name, "type": "perspective", "perspective": {
            "yfov": math.radians(field_of_view), "aspectRatio": 4 / 3, "znear": 0.01}})
        self.gltf["nodes"].append({"name": name, "camera": len(self.gltf["cameras"]) - 1,
                                   "matrix": [*right, 0, *up, 0, *backwards, 0, *eye, 1]})

    def write(self):
        used = sorted({key for material in self.gltf["materials"] for key in material["extensions"]})
        self.gltf["extensionsUsed"] = used
        self.gltf["scenes"][0]["nodes"] = list(range(len(self.gltf["nodes"])))
        data = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        self.gltf["buffers"] = [{"byteLength": len(self.bytes), "uri": data}]
        path = pathlib.Path(__file__).with_name(self.name + ".gltf")
        path.write_text(json.dumps(self.gltf, separators=(",", ":")) + "\n")


def light_box(scene):
    """A dark room with a luminous panel, 1.6 m x 1.2 m, that faces +z from z = 0."""
    scene.lambert("wall", 0.25, 0.25, 0.25)
    scene.material("panel", light=10)
    scene.room([-2, 0, -0.5], [2, 2.6, 4])
    scene.rectangle("panel", "panel", [-0.8, 0.7, 0], [1.6, 0, 0], [0, 1.2, 0])
    scene.camera("front", [0, 1.3, 2.0], [0, 1.3, 0], 36)
    scene.camera("aside", [1.4, 1.6, 2.4], [0, 1.25, 0.3], 42)


def sheet(scene, name, material, left, low, width, height, z):
    scene.rectangle(name, material, [left, low, z], [width, 0, 0], [0, height, 0])


def three_polarizers():
    scene = Writer("three-polarizers", "Two crossed polarizers are dark; a third between them, turned by 45 degrees, lets an "
                   "eighth of the light through again.")
    light_box(scene)
    for angle in (0, 45, 90):
        scene.material(f"polarizer {angle}", filter={"polarizer": {"angle": angle}})
    sheet(scene, "first", "polarizer 0", -0.65, 0.85, 0.85, 0.9, 0.3)
    sheet(scene, "third", "polarizer 45", -0.12, 1.1, 0.24, 0.3, 0.5)
    sheet(scene, "second", "polarizer 90", -0.2, 0.85, 0.85, 0.9, 0.7)
    scene.write()


def waveplates():
    scene = Writer("waveplates", "Quartz plates of growing thickness between crossed polarizers: black without a plate, then "
                   "the interference colours.")
    light_box(scene)
    scene.material("polarizer 0", filter={"polarizer": {"angle": 0}})
    scene.material("polarizer 90", filter={"polarizer": {"angle": 90}})
    sheet(scene, "polarizer", "polarizer 0", -0.75, 0.75, 1.5, 1.1, 0.2)
    for k in range(12):
        micrometres = 15 * (k + 1)
        name = f"quartz {micrometres} um"
        scene.material(name, filter={"retarder": {"angle": 45, "thickness": micrometres, "birefringence": 0.0091}})
        sheet(scene, name, name, -0.60 + 0.31 * (k % 4), 1.42 - 0.29 * (k // 4), 0.27, 0.25, 0.3)
    sheet(scene, "analyzer", "polarizer 90", -0.7, 0.79, 1.4, 1.02, 0.4)
    scene.write()


def shop_window():
    scene = Writer("shop-window", "A bright street hides what the shop shows; seen at Brewster's angle, a horizontal analyzer "
                   "takes the reflection away.")
    scene.lambert("wall", 0.6, 0.58, 0.55)
    scene.lambert("street", 0.3, 0.3, 0.32)
    scene.lambert("red", 0.6, 0.08, 0.06)
    scene.lambert("blue", 0.08, 0.15, 0.5)
    scene.lambert("wood", 0.45, 0.3, 0.15)
    scene.material("front", (0.5, 0.45, 0.4), two_sided=True)
    scene.material("pane", ior=1.5, clear="pane")
    scene.material("shop lamp", light=4)
    scene.material("facade", light=20)
    # The shop behind the plane z = 0, its front wall around the pane; the street before it.
    scene.room([0, 0, -2.5], [3, 2.6, 0], leave_out=("front",))
    scene.room([-3, 0, 0], [7, 4, 5], floor="street", walls="street", ceiling="street", leave_out=("back",))
    front = [[[-3, 0], [0.2, 4]], [[2.8, 0], [7, 4]], [[0.2, 0], [2.8, 0.5]], [[0.2, 2.3], [2.8, 4]]]
    quads = [[[a, b, 0.0], [c, b, 0.0], [c, d, 0.0], [a, d, 0.0]] for (a, b), (c, d) in front]
    scene.polygons("front", "front", quads)
    scene.rectangle("pane", "pane", [0.2, 0.5, 0], [2.6, 0, 0], [0, 1.8, 0])
    scene.rectangle("shop lamp", "shop lamp", [0.8, 2.59, -1.6], [1.2, 0, 0], [0, 0, 0.8])
    for k in range(4):  # a facade of bright windows across the street
        scene.rectangle(f"facade {k}", "facade", [6.99, 0.3, 1.0 + k], [0, 0, 0.7], [0, 2.6, 0])
    scene.box("shelf", "wood", [0.4, 0, -1.6], [2.6, 0.7, -0.9])
    scene.box("parcel", "red", [0.7, 0.7, -1.5], [1.1, 1.2, -1.1])
    scene.sphere("globe", "blue", [1.9, 1.0, -1.25], 0.3)
    scene.camera("brewster", [-0.7, 1.5, 1.5], [1.5, 1.3, 0], 50)
    scene.camera("straight", [1.5, 1.5, 2.5], [1.5, 1.3, 0], 50)
    scene.write()


def water_glare():
    scene = Writer("water-glare", "The sky glares from a pool and hides its floor; a vertical analyzer, as in sunglasses, opens "
                   "the view.")
    scene.lambert("wall", 0.5, 0.5, 0.5)
    scene.lambert("stone", 0.45, 0.42, 0.38)
    scene.lambert("blue tile", 0.1, 0.3, 0.5)
    scene.lambert("orange tile", 0.7, 0.3, 0.05)
    scene.lambert("yellow tile", 0.7, 0.6, 0.1)
    scene.material("water", ior=1.333, clear="body")
    scene.material("sky", light=8)
    scene.room([-2.5, -0.6, -3], [2.5, 3, 3], floor="stone")
    scene.rectangle("sky", "sky", [-2, 0.5, -2.99], [4, 0, 0], [0, 2.2, 0])
    scene.rectangle("sky above", "sky", [-1, 2.99, -1], [2, 0, 0], [0, 0, 2])
    basin = [([-1.6, -0.59, -2], [-1.5, 0.12, 1.2]), ([1.5, -0.59, -2], [1.6, 0.12, 1.2]),
             ([-1.5, -0.59, -2], [1.5, 0.12, -1.9]), ([-1.5, -0.59, 1.1], [1.5, 0.12, 1.2])]
    for k, (low, high) in enumerate(basin):
        scene.box(f"edge {k}", "stone", low, high)
    for k, colour in enumerate(("blue tile", "orange tile", "yellow tile")):
        scene.box(colour, colour, [-1.2 + 0.85 * k, -0.59, -1.1], [-0.5 + 0.85 * k, -0.45, 0.5])
    scene.box("water", "water", [-1.499, -0.58, -1.899], [1.499, 0.0, 1.099])
    scene.camera("bank", [0, 1.5, 1.6], [0, 0, -0.4], 50)
    scene.camera("low", [1.2, 0.7, 1.6], [0, 0, -0.6], 50)
    scene.write()


def two_mirrors():
    scene = Writer("two-mirrors", "Light that two iron mirrors reflect in different planes has become circular in part: S3, "
                   "which one mirror alone never makes.")
    scene.lambert("wall", 0.5, 0.5, 0.5)
    scene.lambert("dark", 0.1, 0.1, 0.1)
    scene.material("lamp", light=15)
    scene.material("iron", (0.6, 0.6, 0.6), metal=IRON)
    scene.room([-1.5, 0, -1.5], [1.5, 2.4, 1.5], floor="dark", walls="wall", ceiling="dark")
    scene.rectangle("lamp", "lamp", [-1.49, 0.9, 0.3], [0, 0, -1.2], [0, 1.0, 0])
    scene.rectangle("lying mirror", "iron", [-1.1, 0.02, 0.9], [2.2, 0, 0], [0, 0, -1.8])
    across, upwards = sheet_turned(-35)
    corner = add([0.1, 0.03, -0.6], scaled(-0.6, across))
    leaning = unit(add(upwards, scaled(-0.6, cross(across, upwards))))
    scene.rectangle("leaning mirror", "iron", corner, scaled(1.2, across), scaled(1.3, leaning))
    scene.sphere("ball", "wall", [0.55, 0.27, 0.25], 0.25)
    scene.camera("entry", [0.5, 1.3, 1.4], [0, 0.5, -0.3], 50)
    scene.camera("low", [-0.9, 0.45, 1.3], [0.2, 0.4, -0.4], 50)
    scene.write()


def sphere_lab():
    scene = Writer("sphere-lab", "Six spheres, one light: every angle of reflection at once on water, plastic, diamond, gold, "
                   "satin and clear glass.")
    scene.lambert("table", 0.35, 0.33, 0.3)
    scene.lambert("wall", 0.55, 0.55, 0.6)
    scene.material("lamp", light=20)
    scene.material("black water", ior=1.333)
    scene.material("white plastic", (0.8, 0.8, 0.8), ior=1.5)
    scene.material("diamond", ior=2.42)
    scene.material("gold", (0.94, 0.79, 0.4), metal=GOLD)
    scene.material("red satin", (0.6, 0.1, 0.08), math.sqrt(0.2), ior=1.5)
    scene.material("glass", ior=1.5, clear="body")
    scene.room([-2, 0, -1.6], [2, 2.6, 2.2], floor="table")
    scene.rectangle("lamp", "lamp", [-0.6, 2.59, -0.4], [1.2, 0, 0], [0, 0, 0.8])
    for k, material in enumerate(("black water", "white plastic", "diamond", "gold", "red satin", "glass")):
        scene.sphere(material, material, [-0.95 + 0.95 * (k % 3), 0.36, -0.55 + 0.95 * (k // 3)], 0.35)
    scene.camera("front", [0, 1.2, 2.1], [0, 0.35, -0.1], 50)
    scene.camera("side", [-1.8, 0.8, 1.4], [0, 0.35, -0.1], 50)
    scene.write()


def legs(scene, name, material, places, thickness, height):
    for k, (x, z) in enumerate(places):
        scene.box(f"{name} leg {k}", material, [x, 0, z], [x + thickness, height, z + thickness])


def harpsichord_room():
    scene = Writer("harpsichord-room", "A furnished room of about a hundred polygons with a harpsichord, after figure 5.2 of "
                   "the thesis: lacquer, waxed boards, a mirror, and light from a window.")
    scene.lambert("wall", 0.72, 0.68, 0.6)
    scene.lambert("ceiling", 0.8, 0.8, 0.78)
    scene.lambert("rug", 0.35, 0.08, 0.08)
    scene.lambert("ivory", 0.75, 0.72, 0.62)
    scene.lambert("painting", 0.15, 0.25, 0.3)
    scene.lambert("frame", 0.4, 0.28, 0.08)
    scene.material("boards", (0.35, 0.2, 0.1), math.sqrt(0.15), ior=1.5)
    scene.material("lacquer", (0.05, 0.12, 0.08), math.sqrt(0.1), ior=1.5)
    scene.material("walnut", (0.25, 0.13, 0.06), math.sqrt(0.25), ior=1.5)
    scene.material("mirror", (0.95, 0.93, 0.88), metal={"n": [0.059, 0.06, 0.047], "k": [4.111, 3.589, 2.803]})
    scene.material("window", light=9)
    scene.material("lamp", light=12)
    scene.room([0, 0, -4], [5, 2.9, 0], floor="boards", ceiling="ceiling")
    scene.rectangle("window", "window", [0.01, 0.9, -1.2], [0, 0, -1.6], [0, 1.5, 0])
    scene.rectangle("lamp", "lamp", [3.4, 2.89, -2.4], [0.6, 0, 0], [0, 0, 0.6])
    scene.rectangle("rug", "rug", [1.2, 0.012, -0.9], [2.4, 0, 0], [0, 0, -1.9])
    scene.rectangle("painting", "painting", [2.9, 1.2, -3.97], [1.1, 0, 0], [0, 0.8, 0])
    scene.box("frame", "frame", [2.85, 1.15, -3.995], [4.05, 2.05, -3.98])
    scene.rectangle("mirror", "mirror", [4.99, 0.9, -2.6], [0, 0, 1.0], [0, 1.3, 0])
    # The harpsichord: a wing that narrows away from its keys, its lid propped open, on three legs.
    wing = [(1.7, -1.5), (2.65, -1.5), (2.65, -2.1), (2.45, -2.7), (2.2, -3.2), (1.95, -3.5), (1.7, -3.5)]
    scene.prism("case", "lacquer", wing, 0.62, 0.86)
    scene.box("key bed", "lacquer", [1.7, 0.62, -1.5], [2.65, 0.72, -1.28])
    scene.box("keys", "ivory", [1.78, 0.72, -1.49], [2.57, 0.745, -1.31])
    lid = [[x, 0.9 + 0.9 * (x - 1.7), z - 0.05] for x, z in wing]  # hinged along the straight side
    down = [add(corner, [0.012, -0.02, 0]) for corner in lid]
    edges = [[down[k - 1], down[k], lid[k], lid[k - 1]] for k in range(len(lid))]
    scene.polygons("lid", "lacquer", [lid, down[::-1], *edges])
    legs(scene, "harpsichord", "walnut", [(1.72, -1.45), (2.55, -1.45), (1.75, -3.35)], 0.07, 0.62)
    scene.box("bench", "walnut", [1.85, 0.42, -1.0], [2.5, 0.47, -0.65])
    legs(scene, "bench", "walnut", [(1.87, -0.98), (2.42, -0.98), (1.87, -0.73), (2.42, -0.73)], 0.05, 0.42)
    scene.box("table", "walnut", [3.5, 0.7, -3.5], [4.6, 0.74, -2.9])
    legs(scene, "table", "walnut", [(3.53, -3.47), (4.5, -3.47), (3.53, -3.0), (4.5, -3.0)], 0.06, 0.7)
    scene.box("music", "ivory", [3.8, 0.741, -3.35], [4.1, 0.77, -3.05])
    scene.camera("door", [4.6, 1.6, -0.3], [2.0, 0.8, -2.3], 52)
    scene.camera("window", [0.4, 1.5, -0.4], [2.7, 0.8, -2.6], 52)
    scene.camera("keys", [2.2, 1.35, -0.35], [2.1, 0.75, -2.0], 50)
    scene.write()


if __name__ == "__main__":
    for make in (three_polarizers, waveplates, shop_window, water_glare, two_mirrors, sphere_lab, harpsichord_room):
        make()
