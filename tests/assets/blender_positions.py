"""Compares where Blender places the joints of exported clips with where Deixis does.

    python3 blender_positions.py FOLDER

FOLDER holds clip.glb, clip.bvh (30 fps) and positions.txt with lines "FRAME JOINT X Y Z": metres, y up, frames from 0.
Runs itself inside Blender (written for 3.4), headless; exits with 77, saying so, where Blender is not installed, and with
1 where a joint is off by more than 1 mm.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys

TOLERANCE_M = 0.001


def expected_positions(folder):
    table = {}
    for line in (folder / "positions.txt").read_text().splitlines():
        frame, joint, *xyz = line.split()
        table[int(frame), joint] = tuple(map(float, xyz))
    return table


def inside_blender(folder):
    """Prints "FORMAT FRAME JOINT X Y Z" for the frames of positions.txt."""
    import bpy

    frames = sorted({frame for frame, _ in expected_positions(folder)})
    for kind in ("glb", "bvh"):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        scene = bpy.context.scene
        scene.render.fps = 30
        path = str(folder / f"clip.{kind}")
        if kind == "glb":
            bpy.ops.import_scene.gltf(filepath=path)
            first = 0  # its importer multiplies times by the frame rate
        else:
            # Blender 3.4 opens the file in mode "rU", which Debian's Python 3.11 no longer knows.
            from io_anim_bvh import import_bvh
            import_bvh.open = lambda name, mode: open(name, mode.replace("U", ""))
            bpy.ops.import_anim.bvh(filepath=path, axis_forward="-Z", axis_up="Y", frame_start=1)
            first = 1
        armatures = [thing for thing in scene.objects if thing.type == "ARMATURE"]
        print("armatures", kind, len(armatures))
        for frame in frames:
            scene.frame_set(first + frame)
            for bone in armatures[0].pose.bones:
                x, y, z = armatures[0].matrix_world @ bone.head
                print("place", kind, frame, bone.name, x, z, -y)  # Blender is z up


def main():
    folder = pathlib.Path(sys.argv[-1])
    blender = shutil.which("blender")
    if not blender:
        print("skipped: Blender is not installed")
        return 77
    # Blender looks for its Python's library along PATH: only the system's own must be there.
    run = subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code", "3", "--python",
                          __file__, "--", str(folder)], capture_output=True, text=True, env=os.environ | {"PATH": os.defpath})
    if "No module named 'numpy'" in run.stderr:
        print("skipped: Blender's glTF importer needs numpy (apt-get install python3-numpy)")
        return 77
    if run.returncode != 0:
        print(run.stdout[-2000:], run.stderr[-4000:], sep="\n")
        return 1
    expected = expected_positions(folder)
    failed = False
    for kind in ("glb", "bvh"):
        places = [line.split()[2:] for line in run.stdout.splitlines() if line.startswith(f"place {kind} ")]
        found = {(int(frame), joint): tuple(map(float, xyz)) for frame, joint, *xyz in places}
        missing = [key for key in expected if key not in found]
        worst, where = max((math.dist(found[key], expected[key]), key) for key in expected if key in found)
        print(f"{kind}: {len(expected) - len(missing)} positions, worst {worst * 1000:.6f} mm (frame and joint {where}), "
              f"{len(missing)} missing")
        failed |= bool(missing) or worst > TOLERANCE_M
    print(run.stdout.splitlines()[0])
    return 1 if failed else 0


if "bpy" in sys.modules or "--" in sys.argv:
    inside_blender(pathlib.Path(sys.argv[-1]))
else:
    sys.exit(main())
