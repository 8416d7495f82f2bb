"""Yade as a peer: it settles the packing once, stays alive, and goes on from window to window."""
import json
import os
import pathlib
import subprocess
import sys

INSIDE = pathlib.Path(__file__).resolve().parent / "yade" / "inside.py"


class Yade:
    name, title = "yade", "Yade"
    goes_on = True  # the strain of its windows adds up
    remarks = ["Yade: the same law, damping and time step; lateral stress held by its own servo"]

    def __init__(self, case, threads, folder):
        case_file = folder / "case.json"
        case_file.write_text(json.dumps(case))
        command = ["yade", "-n", "-x", f"-j{threads}", str(INSIDE), str(case_file)]
        environment = {**os.environ, "OMP_PROC_BIND": "true"}
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment
        )
        self.threads = threads
        self.output_lines = []

    def send(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        for line in self.process.stdout:
            if line.startswith("@"):
                return json.loads(line[1:])
            self.output_lines.append(line)
        sys.exit("Yade ended early; it said:\n" + "".join(self.output_lines[-20:]))

    def settle(self):
        return self.send("settle")

    def measure(self, steps):
        found = self.send(f"window {steps}")
        processors = found["processor_seconds"] / found["seconds"] / self.threads
        return {**found, "steps_per_second": steps / found["seconds"], "processors": processors}

    def close(self):
        self.process.stdin.close()
        self.process.wait()
