#!/usr/bin/env python3
"""A glass ball in the sun and a room with a window by Mitsuba 3: the error that it reaches in a time.

    apt-get install -y libllvm19 && pip install mitsuba==3.9.1     # LLVM 14 to 16 do not work
    export DRJIT_LIBLLVM_PATH=/usr/lib/x86_64-linux-gnu/libLLVM-19.so
    tools/peer_hard_light.py glass|room [samples,samples,...]

The glass ball is tests/data/glass.glsl without air: `magichour render tests/data/glass.glsl --set atmosphere.rayleigh=0 --set atmosphere.mie=0`.
The room is tests/data/window_room.glsl. Each row gives the samples of a pixel, the seconds without compiling, and the error, percent, with and without the
worst 0.1 % of the pixels: the difference of two seeds over the square root of two and the mean.
"""
import math
import sys
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
T = mi.ScalarTransform4f
SIDE = 128


def matte(color):
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": color}}


def box(centre, half, color):
    return {"type": "cube", "to_world": T().translate(centre).scale(half), "bsdf": matte(color)}


def scene(eye, target, fov, sky):
    film = {"type": "hdrfilm", "width": SIDE, "height": SIDE, "component_format": "float32", "rfilter": {"type": "box"}}
    sensor = {
        "type": "perspective",
        "fov": fov,
        "fov_axis": "y",
        "near_clip": 1e-3,
        "to_world": T().look_at(origin=eye, target=target, up=[0, 1, 0]),
        "film": film,
        "sampler": {"type": "independent"},
    }
    integrator = {"type": "path", "max_depth": -1, "rr_depth": 12}
    emitter = {"type": "constant", "radiance": {"type": "rgb", "value": sky}}
    return {"type": "scene", "integrator": integrator, "sensor": sensor, "sky": emitter}


def glass():
    """The sun is a disk of 2 degrees in radius that is far away, with an irradiance of 20 across it."""
    made = scene([0, 2.2, -3.5], [-0.3, 0.2, 0], 45, 0.5)
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
    made = scene([1.6, 1.4, -2.2], [-0.8, 1.0, 1.5], 70, 1.0)
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
    name = sys.argv[1]
    counts = [int(n) for n in (sys.argv[2] if len(sys.argv) > 2 else "16,64,256").split(",")]
    loaded = mi.load_dict({"glass": glass, "room": room}[name]())
    print("samples  seconds  error %  without the worst 0.1 %")
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
        print(f"{count:7d}  {min(seconds):7.2f}  {100 * math.sqrt(square.mean()) / mean:7.2f}  {100 * math.sqrt(best.mean()) / mean:7.2f}", flush=True)


main()
