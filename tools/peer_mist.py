#!/usr/bin/env python3
"""Mist by Mitsuba 3's volpath and by magichour: the processors' time that each takes to the same error.

    apt-get install -y libllvm19 && pip install mitsuba==3.9.1     # LLVM 14 to 16 do not work
    export DRJIT_LIBLLVM_PATH=/usr/lib/x86_64-linux-gnu/libLLVM-19.so
    tools/peer_mist.py [side]

Three pictures: a room with slits in mist of 0.02/m, the same with black walls, and a bowl with a matte ball in mist of 0.15/m under the sky alone. An
error is that of two seeds over the square root of two and the mean. The time is the user time of all threads, without compiling: what more samples take,
over what fewer take. It goes as one over the square of the error, and the last column is the ratio at the same error. The pictures' means are printed
too, which agree within the noise but for the sun's colour, which is taken as even here.
"""
import math
import os
import resource
import subprocess
import sys
import tempfile

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
T = mi.ScalarTransform4f
SIDE = int(sys.argv[1]) if len(sys.argv) > 1 else 128
FOLDER = tempfile.mkdtemp()
PROGRAM = os.environ.get("MAGICHOUR", "build/magichour")
COUNTS = {"magichour": (64, 576), "mitsuba": (16, 80)}

ROOM = """//@ camera eye 0.8 1.4 -4.5 target 0 1.5 0 fov 70
//@ sun elevation 25 azimuth 22.5
//@ sun-disk on
//@ mist extinction 0.02 albedo 0.95 0.95 0.95 g 0.6 sphere 0 0 0 8
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/plane.glsl"
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);
    for (int i = 0; i < 5; i++) hit_box(ray, vec3(-2.8 + 1.4 * float(i), 2.0, 3.1), vec3(0.5, 2.0, 0.1), 1, hit);
    hit_box(ray, vec3(0.0, 3.5, 3.1), vec3(3.3, 0.5, 0.1), 1, hit);
    hit_box(ray, vec3(-3.1, 2.0, 0.0), vec3(0.1, 2.0, 3.2), 1, hit);
    hit_box(ray, vec3(3.1, 2.0, 0.0), vec3(0.1, 2.0, 3.2), 1, hit);
    hit_box(ray, vec3(0.0, 4.1, 0.0), vec3(3.3, 0.1, 3.3), 1, hit);
}
Material scene_material(Hit hit) { return matte(vec3(%s)); }
"""
BOWL = """//@ camera eye 0 2 -4 target 0 0 0 fov 90
//@ sun elevation 30 azimuth 0
//@ mist extinction 0.15 albedo 0.9 0.9 0.9 g 0.6 sphere 0 0 0 8
#include "material/matte.glsl"
#include "shape/plane_minus_sphere.glsl"
#include "shape/sphere.glsl"
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane_minus_sphere(ray, vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0), 2.0, 0, hit);
    hit_sphere(ray, vec3(0.0, 0.5, 0.0), 1.0, 1, hit);
}
Material scene_material(Hit hit) { return matte(vec3(0.5)); }
"""


def matte(value):
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": value}}}


def common(eye, target, fov, sun, extinction, albedo):
    path = os.path.join(FOLDER, "sky.exr")
    subprocess.run([PROGRAM, "sky", "-o", path, "--size", "2048x1024", "--sun", sun, "--quiet"], check=True)
    medium = {
        "type": "homogeneous",
        "sigma_t": {"type": "rgb", "value": extinction},
        "albedo": {"type": "rgb", "value": albedo},
        "phase": {"type": "hg", "g": 0.6},
    }
    film = {"type": "hdrfilm", "width": SIDE, "height": SIDE, "component_format": "float32", "rfilter": {"type": "box"}}
    return {
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": -1, "rr_depth": 8},
        "mist": medium,
        "region": {"type": "sphere", "radius": 8.0, "bsdf": {"type": "null"}, "interior": {"type": "ref", "id": "mist"}},
        "sensor": {
            "type": "perspective",
            "fov": fov,
            "fov_axis": "y",
            "near_clip": 1e-3,
            "to_world": T().look_at(origin=eye, target=target, up=[0, 1, 0]),
            "film": film,
            "sampler": {"type": "independent"},
            "medium": {"type": "ref", "id": "mist"},
        },
        "sky": {"type": "envmap", "filename": path},
        "ground": {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(1e4), "bsdf": matte(0.4)},
    }


def room(black):
    scene = common([0.8, 1.4, -4.5], [0, 1.5, 0], 70, "25,22.5", 0.02, 0.95)
    elevation, azimuth, far = math.radians(25), math.radians(22.5), 1e6
    toward = [math.cos(elevation) * math.sin(azimuth), math.sin(elevation), math.cos(elevation) * math.cos(azimuth)]
    radius = math.radians(0.2666)
    disk = T().look_at(origin=[far * c for c in toward], target=[0, 0, 0], up=[0, 1, 0]).scale(far * math.tan(radius))
    lamp = {"type": "area", "radiance": {"type": "rgb", "value": [c / (math.pi * math.sin(radius) ** 2) for c in (15.5, 13.5, 9.5)]}}
    scene["sun"] = {"type": "disk", "to_world": disk, "emitter": lamp, "bsdf": matte(0.0)}
    scene["ground"]["bsdf"] = matte(0.0 if black else 0.4)
    boxes = [([-2.8 + 1.4 * i, 2, 3.1], [0.5, 2, 0.1]) for i in range(5)] + [
        ([0, 3.5, 3.1], [3.3, 0.5, 0.1]),
        ([-3.1, 2, 0], [0.1, 2, 3.2]),
        ([3.1, 2, 0], [0.1, 2, 3.2]),
        ([0, 4.1, 0], [3.3, 0.1, 3.3]),
    ]
    for i, (centre, half) in enumerate(boxes):
        scene[f"box{i}"] = {"type": "cube", "to_world": T().translate(centre).scale(half), "bsdf": matte(0.0 if black else 0.6)}
    return scene


def bowl():
    """A plane with a hole, as a ring of triangles, and the bowl's mesh below it."""
    scene = common([0, 2, -4], [0, 0, 0], 90, "30,0", 0.15, 0.9)
    angles = np.linspace(0.5 * math.pi, 1e-3, 64)
    radii = np.concatenate([2 + np.geomspace(0.02, 1e4, 24)[::-1], 2 * np.sin(angles)])
    heights = np.concatenate([np.zeros(24), -2 * np.cos(angles)])
    phi = np.arange(256) / 256 * 2 * math.pi
    across, up = radii[:, None], heights[:, None]
    vertices = np.stack([across * np.cos(phi), up + 0 * phi, across * np.sin(phi)], -1).reshape(-1, 3)
    first = np.arange(len(radii) - 1)[:, None] * 256
    a, b = first + np.arange(256), first + (np.arange(256) + 1) % 256
    faces = np.stack([np.stack([a, b, a + 256], -1), np.stack([b, b + 256, a + 256], -1)], 2).reshape(-1, 3)
    made = mi.Mesh("bowl", len(vertices), len(faces))
    values = mi.traverse(made)
    values["vertex_positions"] = vertices.astype(np.float32).ravel()
    values["faces"] = faces.astype(np.uint32).ravel()
    values.update()
    path = os.path.join(FOLDER, "bowl.ply")
    made.write_ply(path)
    scene["ground"] = {"type": "ply", "filename": path, "face_normals": True, "bsdf": matte(0.5)}
    scene["ball"] = {"type": "sphere", "center": [0, 0.5, 0], "radius": 1.0, "bsdf": matte(0.5)}
    return scene


def user_seconds(who):
    return resource.getrusage(who).ru_utime


def by_magichour(text, samples, seed):
    scene, picture = os.path.join(FOLDER, "scene.glsl"), os.path.join(FOLDER, "picture.pfm")
    with open(scene, "w") as file:
        file.write(text)
    before = user_seconds(resource.RUSAGE_CHILDREN)
    command = [PROGRAM, "render", scene, "--size", f"{SIDE}x{SIDE}", "--light", "cosine", "--spp", str(samples), "--seed", str(seed)]
    subprocess.run(command + ["--atmosphere", "simmons2017", "--quiet", "-o", picture], check=True)
    seconds = user_seconds(resource.RUSAGE_CHILDREN) - before
    with open(picture, "rb") as file:
        for _ in range(3):
            file.readline()
        return seconds, np.frombuffer(file.read(), "<f4").reshape(SIDE, SIDE, 3).astype(float)


def by_mitsuba(scene, samples, seed):
    before = user_seconds(resource.RUSAGE_SELF)
    picture = np.array(mi.render(scene, spp=samples, seed=seed)).astype(float)
    return user_seconds(resource.RUSAGE_SELF) - before, picture


def measure(render, counts):
    """The error of the larger number of samples, and the time of as many more samples."""
    few, many = counts
    render(few, 1)
    short = min(render(few, seed)[0] for seed in (2, 3))
    runs = [render(many, seed) for seed in (4, 5)]
    seconds = (min(run[0] for run in runs) - short) * many / (many - few)
    a, b = runs[0][1], runs[1][1]
    mean = 0.5 * (a + b).mean()
    return 100 * math.sqrt(((a - b) ** 2).mean() / 2) / mean, seconds, mean


def main():
    print("| picture | program | samples | error, % | user time, s | mean | time to the same error |\n|---|---|---|---|---|---|---|")
    cases = [
        ("room with slits", ROOM % "hit.object == 0 ? 0.4 : 0.6", room(False)),
        ("the same, black walls", ROOM % "0.0", room(True)),
        ("bowl, sky alone", BOWL, bowl()),
    ]
    for name, text, described in cases:
        scene = mi.load_dict(described)
        own = measure(lambda n, s: by_magichour(text, n, s), COUNTS["magichour"])
        peer = measure(lambda n, s: by_mitsuba(scene, n, s), COUNTS["mitsuba"])
        ratio = own[0] ** 2 * own[1] / (peer[0] ** 2 * peer[1])
        for program, result, last in (("magichour", own, f"{ratio:.3f}"), ("Mitsuba", peer, "1")):
            samples = COUNTS[program.lower()][1]
            print(f"| {name} | {program} | {samples} | {result[0]:.2f} | {result[1]:.2f} | {result[2]:.4f} | {last} |", flush=True)


main()
