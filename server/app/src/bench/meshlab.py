"""MeshLab's quadric edge collapse with its default parameters: meshlab.py MODEL (FACES OUT.ply)..."""

import sys

try:
    import pymeshlab
except ImportError:
    sys.exit(3)

model, *wanted = sys.argv[1:]
for faces, out in zip(wanted[::2], wanted[1::2]):
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(model)
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=int(faces))
    meshes.save_current_mesh(out, save_vertex_quality=False, save_vertex_color=False, save_face_color=False)
