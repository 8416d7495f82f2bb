"""Which code a comparison is with, by the name on the command line."""
from lammps_peer import Lammps
from yade_peer import Yade


def make_peer(name, case, threads, folder):
    folder.mkdir(parents=True, exist_ok=True)
    return {"yade": Yade, "lammps": Lammps}[name](case, threads, folder)
