#!/usr/bin/env python3
"""The crater, a glass ball in the sun, or a room with a window by Mitsuba 3: the error that it reaches in a time.

    apt-get install -y libllvm19 && pip install mitsuba==3.9.1     # LLVM 14 to 16 do not work
    export DRJIT_LIBLLVM_PATH=/usr/lib/x86_64-linux-gnu/libLLVM-19.so
    tools/peer_error.py crater|glass|room [samples,samples,...]

It prints rows for `magichour chart --points`: the program, the seconds without compiling, and the error, percent, as the difference of two seeds over the
square root of two and the mean. A comment behind each row gives the samples of a pixel and the error without the worst 0.1 % of the pixels.

The crater is scenes/crater.glsl, 256x256, under the sky that `magichour sky` writes (MAGICHOUR, or build/magichour). The glass ball is
tests/data/glass.glsl without air: `--set atmosphere.rayleigh=0 --set atmosphere.mie=0`. The room is tests/data/window_room.glsl. Both have 128x128 pixels.
"""
import math
import os
import subprocess
import sys
import tempfile
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
T = mi.ScalarTransform4f
SIDES = {"crater": 256, "glass": 128, "room": 128}
SIDE = SIDES[sys.argv[1]]


def matte(color):
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": color}}


def box(centre, half, color):
    return {"type": "cube", "to_world": T().translate(centre).scale(half), "bsdf": matte(color)}


def scene(eye, target, fov, sky, sampler="independent"):
    film = {"type": "hdrfilm", "width": SIDE, "height": SIDE, "component_format": "float32", "rfilter": {"type": "box"}}
    sensor = {
        "type": "perspective",
        "fov": fov,
        "fov_axis": "y",
        "near_clip": 1e-3,
        "to_world": T().look_at(origin=eye, target=target, up=[0, 1, 0]),
        "film": film,
        "sampler": {"type": sampler, "sample_count": 16},
    }
    integrator = {"type": "path", "max_depth": -1, "rr_depth": 12}
    return {"type": "scene", "integrator": integrator, "sensor": sensor, "sky": sky}


def even(radiance):
    return {"type": "constant", "radiance": {"type": "rgb", "value": radiance}}


def rings(radii, heights, columns):
    """Vertices of rings about the y axis, and the triangles between neighbours."""
    phi = np.arange(columns) / columns * 2 * math.pi
    across, up = np.array(radii)[:, None], np.array(heights)[:, None]
    vertices = np.stack([across * np.cos(phi), up + 0 * phi, across * np.sin(phi)], -1).reshape(-1, 3)
    first = np.arange(len(radii) - 1)[:, None] * columns
    a, b = first + np.arange(columns), first + (np.arange(columns) + 1) % columns
    faces = np.stack([np.stack([a, b, a + columns], -1), np.stack([b, b + columns, a + columns], -1)], 2).reshape(-1, 3)
    return vertices, faces


def mesh(radii, heights, columns=256):
    vertices, faces = rings(radii, heights, columns)
    made = mi.Mesh("rings", len(vertices), len(faces), has_vertex_texcoords=True)
    values = mi.traverse(made)
    values["vertex_positions"] = vertices.astype(np.float32).ravel()
    values["faces"] = faces.astype(np.uint32).ravel()
    values["vertex_texcoords"] = (0.5 * vertices[:, [0, 2]]).astype(np.float32).ravel()
    values.update()
    path = os.path.join(tempfile.mkdtemp(), "rings.ply")
    made.write_ply(path)
    return {"type": "ply", "filename": path, "face_normals": True, "bsdf": {"type": "ref", "id": "checker"}}


def crater():
    """A plane with a bowl of 2 m, checkered, and a mirror ball above it. Rows of the sky's map are half a row off, which does not matter here."""
    path = os.path.join(tempfile.mkdtemp(), "sky.exr")
    subprocess.run([os.environ.get("MAGICHOUR", "build/magichour"), "sky", "-o", path, "--size", "2048x1024", "--sun", "30", "--quiet"], check=True)
    made = scene([0, 2, -4], [0, 0, 0], 90, {"type": "envmap", "filename": path}, "multijitter")
    squares = {"type": "checkerboard", "color0": {"type": "rgb", "value": 0.8}, "color1": {"type": "rgb", "value": 0.1}}
    made["checker"] = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": squares}}
    angles = np.linspace(0.5 * math.pi, 1e-3, 64)
    made["bowl"] = mesh(2 * np.sin(angles), -2 * np.cos(angles))
    radii = np.concatenate([[2.0], 2 + np.geomspace(0.02, 1e5, 24)])
    made["plane"] = mesh(radii, 0 * radii)
    made["ball"] = {"type": "sphere", "center": [0, 0.5, 0], "radius": 1.0, "bsdf": {"type": "conductor", "material": "none"}}
    return made


def glass():
    """The sun is a disk of 2 degrees in radius that is far away, with an irradiance of 20 across it."""
    made = scene([0, 2.2, -3.5], [-0.3, 0.2, 0], 45, even(0.5))
    elevation, radius, far = math.radians(50), math.radians(2), 1000.0
    toward = [math.cos(elevation), math.sin(elevation), 0]
    place = [far * c for c in toward]
    lamp = {"type": "area", "radiance": {"type": "rgb", "value": 20 / (math.pi * math.sin(radius) ** 2)}}
    disk = T().look_at(origin=place, target=[0, 0, 0], up=[0, 0, 1]).scale(far * math.tan(radius))
    made["sun"] = {"type": "disk", "to_world": disk, "emitter": lamp, "bsdf": matte(0.0)}
    made["ground"] = {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(500), "bsdf": matte([0.6, 0.55, 0.5])}
    ball = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}
    made["ball"] = {"type": "sphere", "center": [0, 0.75, 0], "radius": 0.6, "bsdf": ball}
    return made


def room():
    made = scene([1.6, 1.4, -2.2], [-0.8, 1.0, 1.5], 70, even(1.0))
    width, low, high, white = 0.7, 0.9, 2.1, [0.7, 0.7, 0.7]
    side = 0.5 * (3.2 - width)
    boxes = [
        ([0, -0.1, 0], [2.2, 0.1, 3.2], [0.45, 0.4, 0.35]),
        ([0, 2.7, 0], [2.2, 0.1, 3.2], white),
        ([2.1, 1.3, 0], [0.1, 1.4, 3.2], white),
        ([0, 1.3, -3.1], [2.2, 1.4, 0.1], white),
        ([0, 1.3, 3.1], [2.2, 1.4, 0.1], [0.7, 0.2, 0.15]),
        ([-2.1, 0.5 * (low - 0.1), 0], [0.1, 0.5 * (low + 0.1), 3.2], white),
        ([-2.1, 0.5 * (high + 2.7), 0], [0.1, 0.5 * (2.7 - high), 3.2], white),
        ([-2.1, 1.3, -3.2 + side], [0.1, 1.4, side], white),
        ([-2.1, 1.3, 3.2 - side], [0.1, 1.4, side], white),
        ([-0.3, 0.375, 1.0], [0.5, 0.425, 0.5], [0.2, 0.35, 0.7]),
    ]
    for i, (centre, half, color) in enumerate(boxes):
        made[f"box{i}"] = box(centre, half, color)
    return made


def main():
    counts = [int(n) for n in (sys.argv[2] if len(sys.argv) > 2 else "4,16,64,256").split(",")]
    loaded = mi.load_dict({"crater": crater, "glass": glass, "room": room}[sys.argv[1]]())
    print("program,seconds,percent")
    for count in counts:
        np.array(mi.render(loaded, spp=count, seed=999))  # compiles
        pictures, seconds = [], []
        for seed in (1, 2):
            start = time.time()
            pictures.append(np.array(mi.render(loaded, spp=count, seed=seed)))
            seconds.append(time.time() - start)
        square = ((pictures[0] - pictures[1]) ** 2).mean(axis=2).ravel() / 2
        mean = 0.5 * (pictures[0] + pictures[1]).mean()
        best = np.sort(square)[: -max(1, square.size // 1000)]
        print(f"Mitsuba {mi.__version__} path,{min(seconds):.4g},{100 * math.sqrt(square.mean()) / mean:.4g}")
        print(f"# {count} samples; without the worst 0.1 %: {100 * math.sqrt(best.mean()) / mean:.4g} %; the mean is {mean:.6g}", flush=True)


main()
