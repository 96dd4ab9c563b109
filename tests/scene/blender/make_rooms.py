"""Makes the three rooms beside this file, as a person would export them: once as .glb, once as .gltf with its buffer and
textures beside it. The Blender of Debian 12 (3.4) made those that are kept:

    blender --background --python-exit-code 1 --python tests/scene/blender/make_rooms.py

Every material is double-sided (Blender's default), lamps are in watts (the exporter writes candela and lux), emission is
of order one, names hold dots, folders spaces.
"""

import math
import os

import bpy

HERE = os.path.dirname(os.path.abspath(__file__))


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def image(name, size, pixel, file_format="PNG"):
    """A packed picture: pixel(x, y) gives red, green, blue, alpha in [0, 1], as the file will hold them."""
    made = bpy.data.images.new(name, size, size, alpha=True)
    made.pixels = [channel for y in range(size) for x in range(size) for channel in pixel(x, y)]
    made.file_format = file_format
    path = os.path.join(bpy.app.tempdir, name + (".jpg" if file_format == "JPEG" else ".png"))
    made.filepath_raw = path
    made.save()
    bpy.data.images.remove(made)
    loaded = bpy.data.images.load(path)
    loaded.name = name
    loaded.pack()
    return loaded


def material(name, colour=(0.8, 0.8, 0.8), roughness=0.5, metallic=0.0, ior=1.45, transmission=0.0, emission=None,
             strength=1.0, texture=None, scale=None, interpolation="Linear", masked=False):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    surface = nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1.0)
    surface.inputs["Roughness"].default_value = roughness
    surface.inputs["Metallic"].default_value = metallic
    surface.inputs["IOR"].default_value = ior
    surface.inputs["Transmission"].default_value = transmission
    if emission:
        surface.inputs["Emission"].default_value = (*emission, 1.0)
        surface.inputs["Emission Strength"].default_value = strength
    if texture:
        node = nodes.new("ShaderNodeTexImage")
        node.image = texture
        node.interpolation = interpolation
        links.new(node.outputs["Color"], surface.inputs["Base Color"])
        if masked:
            links.new(node.outputs["Alpha"], surface.inputs["Alpha"])
            made.blend_method = "CLIP"
            made.alpha_threshold = 0.5
        if scale:
            coordinates, mapping = nodes.new("ShaderNodeUVMap"), nodes.new("ShaderNodeMapping")
            coordinates.uv_map = "UVMap"
            mapping.inputs["Scale"].default_value = (*scale, 1.0)
            links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
            links.new(mapping.outputs["Vector"], node.inputs["Vector"])
    return made


def mesh(name, vertices, faces, surface, uvs=None):
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    layer = data.uv_layers.new(name="UVMap")
    for polygon in data.polygons:
        for k, loop in enumerate(polygon.loop_indices):
            layer.data[loop].uv = (uvs or [(0, 0), (1, 0), (1, 1), (0, 1)])[k % 4]
    data.materials.append(surface)
    made = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(made)
    return made


def quad(name, corner, along, up, surface):
    """A rectangle; its front looks along cross(along, up)."""
    add = lambda a, b: tuple(x + y for x, y in zip(a, b))
    return mesh(name, [corner, add(corner, along), add(add(corner, along), up), add(corner, up)], [(0, 1, 2, 3)], surface)


def room(width, depth, height, walls, floor, window=False):
    w, d, h = width, depth, height
    quad("floor", (0, 0, 0), (w, 0, 0), (0, d, 0), floor)
    quad("ceiling", (0, 0, h), (0, d, 0), (w, 0, 0), walls)
    quad("wall.back", (0, d, 0), (w, 0, 0), (0, 0, h), walls)
    quad("wall.front", (w, 0, 0), (-w, 0, 0), (0, 0, h), walls)
    quad("wall.left", (0, 0, 0), (0, d, 0), (0, 0, h), walls)
    if not window:
        quad("wall.right", (w, d, 0), (0, -d, 0), (0, 0, h), walls)
        return
    quad("wall.right", (w, d, 0), (0, -d, 0), (0, 0, h / 3), walls)  # below the window, above and at both sides
    quad("wall.right.001", (w, d, 2 * h / 3), (0, -d, 0), (0, 0, h / 3), walls)
    quad("wall.right.002", (w, d, h / 3), (0, -d / 4, 0), (0, 0, h / 3), walls)
    quad("wall.right.003", (w, d / 4, h / 3), (0, -d / 4, 0), (0, 0, h / 3), walls)


def primitive(add, name, surface, smooth=True, **arguments):
    add(**arguments)
    made = bpy.context.object
    made.name = name
    made.data.name = name + " mesh"
    made.data.materials.append(surface)
    if smooth:
        bpy.ops.object.shade_smooth()
    return made


def camera(name, position, target):
    data = bpy.data.cameras.new("Camera")
    data.angle = math.radians(85)
    made = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(made)
    made.location = position
    focus = bpy.data.objects.new(name + ".target", None)
    focus.location = target
    bpy.context.collection.objects.link(focus)
    made.constraints.new("TRACK_TO").target = focus
    bpy.context.view_layer.update()
    made.matrix_world = made.matrix_world.copy()
    made.constraints.clear()
    bpy.data.objects.remove(focus)
    return made


def lamp(name, kind, watts, position, colour=(1, 1, 1), turn=(0, 0, 0)):
    data = bpy.data.lights.new(name, kind)
    data.energy = watts
    data.color = colour
    made = bpy.data.objects.new(name, data)
    made.location = position
    made.rotation_euler = turn
    bpy.context.collection.objects.link(made)
    return made


def checker(x, y):
    dark = (x // 4 + y // 4) % 2
    return (0.35, 0.2, 0.12, 1) if dark else (0.85, 0.8, 0.7, 1)


def planks(x, y):
    seam = y % 8 == 0
    grain = 0.04 * math.sin(0.9 * x + 3 * (y // 8))
    return (0.25, 0.15, 0.08, 1) if seam else (0.6 + grain, 0.42 + grain, 0.26 + grain, 1)


def lattice(x, y):
    return (0.2, 0.45, 0.3, 1) if x % 16 < 5 or y % 16 < 5 else (0.2, 0.45, 0.3, 0)


def export(folder, name):
    for form, ending in (("GLB", ".glb"), ("GLTF_SEPARATE", ".gltf")):
        target = os.path.join(HERE, folder) if ending == ".gltf" else HERE
        os.makedirs(target, exist_ok=True)
        bpy.ops.export_scene.gltf(filepath=os.path.join(target, name + ending), export_format=form,
                                  export_cameras=True, export_lights=True, export_apply=True, export_yup=True)


def glass_and_brass():
    """A glass ball and a brass ring on a chequered floor; a lamp of 40 W and a glowing panel of order one."""
    clear()
    room(3, 3, 2.4, material("Wall", (0.75, 0.72, 0.65), roughness=0.85),
         material("Floor.tiles", texture=image("tiles", 16, checker), interpolation="Closest", roughness=0.7,
                  scale=(2, 2)))
    sphere = bpy.ops.mesh.primitive_uv_sphere_add
    primitive(sphere, "Ball.glass", material("Glass", (1, 1, 1), roughness=0, transmission=1, ior=1.5),
              segments=32, ring_count=16, radius=0.35, location=(1.1, 1.6, 0.351))
    primitive(bpy.ops.mesh.primitive_torus_add, "Ring.brass",
              material("Brass", (0.887, 0.789, 0.434), roughness=0.25, metallic=1),
              major_segments=48, minor_segments=16, major_radius=0.3, minor_radius=0.08, location=(2.0, 1.8, 0.081))
    quad("Panel", (1.2, 1.2, 2.39), (0, 0.6, 0), (0.6, 0, 0),
         material("Panel.glow", (0, 0, 0), emission=(1, 0.9, 0.7), strength=2))
    lamp("Lamp.bulb", "POINT", 40, (0.5, 0.6, 2.0), (1, 0.85, 0.6))
    camera("Camera.main", (1.5, 0.15, 1.5), (1.5, 2.0, 0.6))
    camera("Camera.low", (0.3, 0.4, 0.5), (1.6, 1.8, 0.35))
    export("glass and brass", "glass and brass")


def sculpture():
    """A head (Suzanne, subdivided) on a wooden table by a window that the sun shines through."""
    clear()
    room(4, 3, 2.7, material("Plaster", (0.8, 0.8, 0.78), roughness=0.85),
         material("Floor.wood", texture=image("planks", 32, planks, "JPEG"), roughness=0.6), window=True)
    head = primitive(bpy.ops.mesh.primitive_monkey_add, "Head", material("Clay", (0.62, 0.36, 0.25), roughness=0.8),
                     size=0.7, location=(2.0, 1.7, 1.1), rotation=(-0.3, 0, 0.4))
    subdivision = head.modifiers.new("Subdivision", "SUBSURF")
    subdivision.levels = subdivision.render_levels = 1
    primitive(bpy.ops.mesh.primitive_cylinder_add, "Plinth", material("Stone", (0.5, 0.5, 0.52), roughness=0.7),
              smooth=False, vertices=24, radius=0.3, depth=0.75, location=(2.0, 1.7, 0.375))
    lamp("Sun", "SUN", 3, (6, 2, 4), turn=(0, math.radians(55), math.radians(10)))
    quad("Lightbox", (0.02, 0.8, 1.0), (0, 0.8, 0), (0, 0, 0.6),
         material("Lightbox.glow", (0.1, 0.1, 0.1), emission=(0.8, 0.9, 1), strength=1))
    camera("Camera.main", (2.2, 0.15, 1.5), (2.0, 1.8, 1.0))
    export("a head by the window", "sculpture")


def gallery():
    """A lattice cut out by its alpha, painted corners, mirrored twins under a turned parent, a spot lamp."""
    clear()
    room(4, 4, 3, material("Wall.white", (0.82, 0.82, 0.82), roughness=0.8), material("Floor.grey", (0.3, 0.3, 0.32)))
    quad("Screen", (1.0, 2.0, 0.2), (2.0, 0, 0), (0, 0, 1.8),
         material("Screen.lattice", texture=image("lattice", 64, lattice), roughness=0.85, masked=True))
    painted = bpy.data.materials.new("Painted")
    painted.use_nodes = True
    colours = painted.node_tree.nodes.new("ShaderNodeVertexColor")
    colours.layer_name = "Colour"
    painted.node_tree.links.new(colours.outputs["Color"], painted.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
    panel = quad("Painting", (0.02, 1.2, 0.8), (0, 1.6, 0), (0, 0, 1.2), painted)
    layer = panel.data.color_attributes.new("Colour", "BYTE_COLOR", "CORNER")
    for k, colour in enumerate([(1, 0.1, 0.1, 1), (0.1, 0.8, 0.1, 1), (0.1, 0.2, 1, 1), (0.9, 0.8, 0.1, 1)]):
        layer.data[k].color = colour
    stand = bpy.data.objects.new("Stand.pair", None)
    stand.location = (2.6, 3.0, 0.0)
    stand.rotation_euler = (0, 0, 0.6)
    bpy.context.collection.objects.link(stand)
    one = primitive(bpy.ops.mesh.primitive_cone_add, "Cone", material("Cone.gloss", (0.7, 0.15, 0.1), roughness=0.3),
                    vertices=24, radius1=0.35, depth=0.8, location=(-0.5, 0, 0.401))
    one.parent = stand
    twin = bpy.data.objects.new("Cone.001", one.data)
    twin.location = (0.5, 0, 0.401)
    twin.scale = (-1, 1, 1)
    twin.parent = stand
    bpy.context.collection.objects.link(twin)
    spot = lamp("Spot.track", "SPOT", 60, (2, 0.8, 2.9), (1, 0.95, 0.85), (math.radians(35), 0, 0))
    spot.data.spot_size, spot.data.spot_blend = math.radians(70), 0.3
    lamp("Lamp.fill", "POINT", 15, (3.4, 0.6, 2.2))
    camera("Camera.main", (3.5, 0.3, 1.8), (1.6, 3.0, 0.9))
    export("gallery room", "gallery")


glass_and_brass()
sculpture()
gallery()
