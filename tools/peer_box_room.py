#!/usr/bin/env python3
"""scenes/box-room.glsl by Mitsuba 3: tests/data/box_room.exr, and the standard errors of its pixels' means in box_room_se.exr.

    pip install mitsuba==3.9.1        # llvm_ad_rgb also needs an LLVM: DRJIT_LIBLLVM_PATH=.../libLLVM.so
    tools/peer_box_room.py tests/data/box_room [side] [seeds] [samples of each]
"""
import sys
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
T = mi.ScalarTransform4f


def matte(color):
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": color}}


def wall(centre, toward, half, color):
    """A rectangle about `centre` that faces `toward`; `half` is half its size along the two axes that are left, in order."""
    axis = [abs(t) for t in toward].index(1)
    others = [i for i in range(3) if i != axis]
    matrix = np.zeros((4, 4))
    matrix[others[0], 0] = half[0]
    matrix[others[1], 1] = half[1]
    matrix[:3, 2] = toward
    matrix[:3, 3] = centre
    matrix[3, 3] = 1
    return {"type": "rectangle", "to_world": T(matrix), "bsdf": {"type": "twosided", "bsdf": matte(color)}}


def sphere(centre, radius, bsdf, **more):
    return {"type": "sphere", "center": centre, "radius": radius, "bsdf": bsdf, **more}


def room(side):
    white = [0.7, 0.7, 0.7]
    lamp = {"type": "area", "radiance": {"type": "rgb", "value": [10.0, 8.5, 7.0]}}
    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": -1, "rr_depth": 12},
        "sensor": {
            "type": "perspective",
            "fov": 60,
            "fov_axis": "y",
            "near_clip": 1e-3,
            "to_world": T().look_at(origin=[0, 1.5, -2.9], target=[0, 1.3, 0], up=[0, 1, 0]),
            "film": {
                "type": "hdrfilm",
                "width": side,
                "height": side,
                "component_format": "float32",
                "rfilter": {"type": "box"},
            },
            "sampler": {"type": "independent"},
        },
        "floor": wall([0, 0, 0], [0, 1, 0], [2, 3], white),
        "ceiling": wall([0, 3, 0], [0, -1, 0], [2, 3], white),
        "back": wall([0, 1.5, 3], [0, 0, -1], [2, 1.5], white),
        "front": wall([0, 1.5, -3], [0, 0, 1], [2, 1.5], white),
        "red": wall([-2, 1.5, 0], [1, 0, 0], [1.5, 3], [0.65, 0.1, 0.08]),
        "green": wall([2, 1.5, 0], [-1, 0, 0], [1.5, 3], [0.12, 0.45, 0.15]),
        "lamp": sphere([0.2, 2.2, 0.5], 0.4, matte(0.0), emitter=lamp),
        "mirror": sphere(
            [-1, 0.7, 1.2], 0.7, {"type": "conductor", "material": "none", "specular_reflectance": {"type": "rgb", "value": 0.9}}
        ),
        "glass": sphere([0.9, 0.7, 0.2], 0.7, {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}),
    }


def main():
    name = sys.argv[1]
    side, seeds, samples = (int(a) for a in (sys.argv[2:] + ["128", "64", "128"][len(sys.argv) - 2 :]))
    scene = mi.load_dict(room(side))
    total = np.zeros((side, side, 3))
    squares = np.zeros((side, side, 3))
    start = time.time()
    for seed in range(seeds):
        picture = np.array(mi.render(scene, spp=samples, seed=seed), dtype=np.float64)[:, :, :3]
        total += picture
        squares += picture**2
    mean = total / seeds
    error = np.sqrt(np.maximum(squares / seeds - mean**2, 0) / (seeds - 1))
    for suffix, values in (("", mean), ("_se", error)):
        half = mi.Bitmap(values.astype(np.float32)).convert(component_format=mi.Struct.Type.Float16)
        half.write(f"{name}{suffix}.exr")
    print(f"{seeds} x {samples} samples in {time.time() - start:.0f} s; mean {mean.mean((0, 1))}")
    print(f"standard error {100 * np.sqrt((error**2).mean()) / mean.mean():.2f} % of the mean")


main()
