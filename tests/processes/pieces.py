"""Checks with VTK that the pieces which several processes have saved are the whole mesh:  pieces.py FOLDER MPIRUN... PROGRAM"""

import glob
import os
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "vtk"))
from compare import pieces_agree, read


def main(folder, command):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    subprocess.run(command + [folder], check=True)
    paths, wrong = sorted(glob.glob(os.path.join(folder, "*.pvtu"))), 0
    for path in paths:
        difference = pieces_agree(path) or ("" if read(path).GetNumberOfCells() > 0 else "no cells")
        wrong += difference != ""
        if difference:
            print(f"{path}: {difference}")
    print(f"{len(paths)} files compared, {wrong} differences")
    return 1 if wrong or len(paths) < 10 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
