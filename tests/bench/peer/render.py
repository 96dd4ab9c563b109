"""Renders a camera of a glTF file with Mitsuba 3, in the layout of tests/images/peer: S0.R .. S3.B, their variances
V0.R .. V3.B, and R G B (= S0), 32-bit floats, row 0 on top.

  render.py SCENE.gltf --camera NAME --size WxH --seconds S --out FILE.exr [--off] [--seed K]

One band at a time, `path` inside `stokes`, independent samples, box filter; the variance is that of the mean of passes
with seeds of their own. --off: without polarization, and by `ptracer` (light tracing) where the lamp is a sun.
Reads what the scenes of assets/scenes need: Lambert, gloss over black, metal, area lamps, suns.
"""

import argparse
import base64
import json
import math
import os
import tempfile
import time

import numpy as np

BANDS = "RGB"


def transform_of(node):
    if "matrix" in node:
        return np.array(node["matrix"], dtype=float).reshape(4, 4).T
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.array(node.get("scale", [1, 1, 1]))
    matrix[:3, 3] = node.get("translation", [0, 0, 0])
    return matrix


class File:
    """A glTF file with its nodes' transforms worked out."""

    def __init__(self, path):
        self.gltf = json.load(open(path))
        folder = os.path.dirname(path)
        self.buffers = [self.bytes_of(buffer["uri"], folder) for buffer in self.gltf["buffers"]]
        self.placed = []  # (node, world transform)
        for root in self.gltf["scenes"][self.gltf.get("scene", 0)].get("nodes", range(len(self.gltf["nodes"]))):
            self.place(root, np.eye(4))

    @staticmethod
    def bytes_of(uri, folder):
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return open(os.path.join(folder, uri), "rb").read()

    def place(self, index, parent):
        node = self.gltf["nodes"][index]
        world = parent @ transform_of(node)
        self.placed.append((node, world))
        for child in node.get("children", []):
            self.place(child, world)

    def array(self, index):
        accessor = self.gltf["accessors"][index]
        view = self.gltf["bufferViews"][accessor["bufferView"]]
        kind = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        values = np.frombuffer(self.buffers[view["buffer"]], kind, accessor["count"] * width, start)
        return values.reshape(-1, width)


def bsdf_of(material, band):
    """Roughness r means slope m = r^2 (Beckmann), metals have n and k of their own (BREWSTER_surface)."""
    surface = material.get("pbrMetallicRoughness", {})
    extensions = material.get("extensions", {})
    base = surface.get("baseColorFactor", [1, 1, 1, 1])[band]
    slope = surface.get("roughnessFactor", 1.0) ** 2
    if surface.get("metallicFactor", 1.0) >= 0.5:
        index = extensions["BREWSTER_surface"]["complexIor"]
        return {"type": "roughconductor", "distribution": "beckmann", "alpha": slope,
                "eta": {"type": "uniform", "value": index["n"][band]},
                "k": {"type": "uniform", "value": index["k"][band]}}
    if extensions.get("KHR_materials_specular", {}).get("specularFactor", 1.0) == 0:
        return {"type": "diffuse", "reflectance": {"type": "uniform", "value": base}}
    if base != 0:
        raise SystemExit("a base under gloss: the peer's model differs, leave it out")
    return {"type": "pplastic", "distribution": "beckmann", "alpha": slope, "int_ior": ior_of(extensions),
            "diffuse_reflectance": {"type": "uniform", "value": 0.0}}


def ior_of(extensions):
    return extensions.get("KHR_materials_ior", {}).get("ior", 1.5)


def write_ply(path, points, normals, faces):
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
              + "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
              + f"element face {len(faces)}\nproperty list uchar int vertex_index\nend_header\n")
    rows = np.zeros(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(np.hstack([points, normals]).astype("<f4").tobytes())
        file.write(rows.tobytes())


def shapes_of(file, band, folder):
    for number, (node, world) in enumerate(file.placed):
        if "mesh" not in node:
            continue
        for part, primitive in enumerate(file.gltf["meshes"][node["mesh"]]["primitives"]):
            points = file.array(primitive["attributes"]["POSITION"]) @ world[:3, :3].T + world[:3, 3]
            normals = file.array(primitive["attributes"]["NORMAL"]) @ np.linalg.inv(world[:3, :3])
            path = os.path.join(folder, f"{number}-{part}.ply")
            write_ply(path, points, normals, file.array(primitive["indices"]).reshape(-1, 3))
            material = file.gltf["materials"][primitive["material"]]
            shape = {"type": "ply", "filename": path, "bsdf": bsdf_of(material, band)}
            strength = material.get("extensions", {}).get("KHR_materials_emissive_strength", {})
            radiance = material.get("emissiveFactor", [0, 0, 0])[band] * strength.get("emissiveStrength", 1.0)
            if radiance > 0:
                shape["emitter"] = {"type": "area", "radiance": {"type": "uniform", "value": radiance}}
            yield f"shape-{number}-{part}", shape


def suns_of(file, band):
    for number, (node, world) in enumerate(file.placed):
        lamp = node.get("extensions", {}).get("KHR_lights_punctual")
        if lamp is None:
            continue
        light = file.gltf["extensions"]["KHR_lights_punctual"]["lights"][lamp["light"]]
        if light["type"] != "directional":
            raise SystemExit("of lamps without extent only suns are read")
        strength = light.get("intensity", 1.0) * light.get("color", [1, 1, 1])[band]
        yield f"sun-{number}", {"type": "directional", "direction": list(-world[:3, 2]),
                                "irradiance": {"type": "uniform", "value": strength}}


def sensor_of(mi, file, name, width, height):
    for node, world in file.placed:
        if "camera" in node and node["name"] == name:
            angle = math.degrees(file.gltf["cameras"][node["camera"]]["perspective"]["yfov"])
            # glTF looks along -z, Mitsuba along +z: half a turn around y.
            return {"type": "perspective", "fov": angle, "fov_axis": "y", "near_clip": 1e-3, "far_clip": 1e4,
                    "to_world": mi.ScalarTransform4f((world @ np.diag([-1.0, 1, -1, 1])).tolist()),
                    "sampler": {"type": "independent"},
                    "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "luminance",
                             "component_format": "float32", "rfilter": {"type": "box"}}}
    raise SystemExit(f"there is no camera {name}")


def components_of(picture, polarized):
    """[row, column, component]; `stokes` ends with S0 to S3, each three times, as if there were three colours."""
    values = np.array(picture)
    return values[:, :, -12::3] if polarized else values[:, :, :1]


def passes(mi, scene, seconds, seed, polarized, samples):
    """Mean and its variance over passes of so many samples each; at least two passes."""
    start, count, sums, squares = time.time(), 0, 0.0, 0.0
    while count < 2 or time.time() - start < seconds:
        values = components_of(mi.render(scene, spp=samples, seed=seed + count), polarized).astype(float)
        sums, squares, count = sums + values, squares + values * values, count + 1
    mean = sums / count
    return mean, (squares / count - mean * mean) / (count - 1), count * samples


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--camera", required=True)
    parser.add_argument("--size", default="128x96")
    parser.add_argument("--seconds", type=float, default=30, help="for all bands together")
    parser.add_argument("--pass-samples", type=int, default=32)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--off", action="store_true")
    parser.add_argument("--out", required=True)
    options = parser.parse_args()

    import mitsuba as mi
    mi.set_variant("llvm_ad_mono" if options.off else "llvm_ad_mono_polarized")
    file = File(options.scene)
    width, height = map(int, options.size.split("x"))
    channels, samples = {}, []
    with tempfile.TemporaryDirectory() as folder:
        for band, letter in enumerate(BANDS):
            suns = dict(suns_of(file, band))
            if options.off:
                integrator = {"type": "ptracer", "max_depth": 24} if suns else {"type": "path"}
            else:
                integrator = {"type": "stokes", "nested": {"type": "path"}}
            scene = mi.load_dict({"type": "scene", "integrator": integrator,
                                  "sensor": sensor_of(mi, file, options.camera, width, height),
                                  **dict(shapes_of(file, band, folder)), **suns})
            mean, variance, count = passes(mi, scene, options.seconds / 3, options.seed + 100000 * band,
                                           not options.off, options.pass_samples)
            samples.append(count)
            channels[letter] = mean[:, :, 0]
            for component in range(mean.shape[2]):
                channels[f"S{component}.{letter}"] = mean[:, :, component]
                channels[f"V{component}.{letter}"] = variance[:, :, component]
            error = math.sqrt(variance[:, :, 0].sum()) / mean[:, :, 0].size
            print(f"{letter}: mean {mean[:, :, 0].mean():.6g} +- {error:.2g}, {count} samples a pixel", flush=True)
    names = sorted(channels)
    pixels = np.stack([channels[name] for name in names], axis=-1).astype(np.float32)
    mi.Bitmap(pixels, pixel_format=mi.Bitmap.PixelFormat.MultiChannel, channel_names=names).write(options.out)


if __name__ == "__main__":
    main()
