#!/usr/bin/python3
"""Static roofline of a vectorized loop: what the processor's ports allow, before caches and memory.

Takes the vectorized inner loops of a symbol out of a built object, lets llvm-mca simulate each on a processor's model, and
prints cycles per item, the port that is busiest and the bound that it sets. The functions that the compiler cloned for
several processors (`target_clones`) are distinguished by the clone's suffix. What lies outside those loops is not counted.
"""
import argparse
import pathlib
import re
import subprocess
import sys

# Suffix of a clone, title, and the models that know its instructions. LLVM 14 has no model of Zen 4; Zen 3's knows no AVX-512.
CLONES = [
    ("arch_x86_64_v3", "AVX2", ["znver3", "icelake-server"]),
    ("arch_x86_64_v4", "AVX-512", ["icelake-server"]),
]
FEATURES = "+avx512f,+avx512vl,+avx512dq,+avx512bw,+avx512cd,+fma,+bmi,+bmi2,+lzcnt"


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--object", required=True, type=pathlib.Path, help="object file or archive")
    parser.add_argument("--symbol", required=True, help="regular expression in the function's demangled name, as press_plain")
    parser.add_argument("--items", type=int, help="items an iteration works on; by default what the widest registers hold")
    parser.add_argument("--clock", type=float, default=4.0, help="GHz, to turn cycles into nanoseconds")
    parser.add_argument("--mca", default="llvm-mca-14")
    parser.add_argument("--cpu", action="append", help="model of llvm-mca instead of those known for the clone")
    parser.add_argument("--least", type=int, default=24, help="vector instructions that make a loop worth a row")
    parser.add_argument("--show", action="store_true", help="print the loop and the whole of llvm-mca's answer")
    return parser.parse_args()


def output_of(command, text=None):
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr[-2000:]}")
    return done.stdout


def functions(object_file, symbol):
    """Name -> rows (address, instruction) of the functions whose demangled name has the expression `symbol` in it."""
    found, rows = {}, None
    for line in output_of(["objdump", "-d", "-C", "--no-show-raw-insn", object_file]).splitlines():
        begins = re.match(r"[0-9a-f]+ <(.*)>:$", line)
        if begins:
            name = begins.group(1)
            wanted = re.search(symbol, name) and "resolver" not in name and ".cold" not in name
            rows = found.setdefault(name, []) if wanted else None
        instruction = re.match(r"\s*([0-9a-f]+):\s+(.*)$", line)
        if rows is not None and instruction:
            rows.append((int(instruction.group(1), 16), instruction.group(2).split("#")[0].strip()))
    return found


def is_vector(text):
    return re.search(r"%[yz]mm", text) is not None


def hot_loops(rows, least):
    """Innermost loops with at least `least` vector instructions: a jump back, and what lies between it and its target."""
    place = {address: k for k, (address, _) in enumerate(rows)}
    loops = []
    for end, (address, text) in enumerate(rows):
        jump = re.match(r"j[a-z]+\s+([0-9a-f]+)\b", text)
        begin = place.get(int(jump.group(1), 16)) if jump else None
        if begin is not None and begin <= end:
            loops.append((begin, end))
    inner = [a for a in loops if not any(b != a and a[0] <= b[0] and b[1] <= a[1] for b in loops)]
    bodies = [[text for _, text in rows[begin : end + 1]] for begin, end in inner]
    return [body for body in bodies if sum(map(is_vector, body)) >= least]


def items_of(body):
    """Items an iteration works on: the lanes of the widest register, of floats where the loop computes with them or turns
    a column of them into doubles or back. A loop that turns whole rows (four lanes of one item) does neither."""
    doubles = 8 if any("%zmm" in text for text in body) else 4
    all_of_it = "\n".join(body)
    computes = re.search(r"v(add|sub|mul|div|sqrt|fn?m\w+)ps\s.*%[yz]mm", all_of_it)
    turns = re.search(r"vcvt(pd2ps|ps2pd)", all_of_it) and re.search(r"vpaddq|vsqrtpd", all_of_it)
    return 2 * doubles if computes or turns else doubles


def as_assembly(body):
    """What objdump prints, as an assembler reads it: jumps inside the loop are not taken, the last one closes it."""
    lines = []
    for text in body:
        text = re.sub(r"^(cs |data16 |notrack |bnd )+", "", text)
        if text.startswith("nop"):
            continue
        text = re.sub(r"^(j[a-z]+)\s+.*", r"\1 .Lloop", text)
        lines.append("    " + re.sub(r"\s*<.*>$", "", text))
    return ".Lloop:\n" + "\n".join(lines) + "\n"


def simulate(options, assembly, cpu):
    attributes = [f"-mattr={FEATURES}"] if "znver" not in cpu else []
    return output_of([options.mca, "-mtriple=x86_64", f"-mcpu={cpu}", *attributes, "-iterations=200", "-"], assembly)


def number(answer, title):
    return float(re.search(rf"{title}:\s+([0-9.]+)", answer).group(1))


def busiest_port(answer):
    """Of the resources by their pressure per iteration: the name and the cycles of the greatest."""
    names = re.findall(r"^\[([0-9.]+)\]\s+- (\S+)", answer, re.MULTILINE)
    table = answer.split("Resource pressure per iteration:")[1].splitlines()
    pressure = [float(x) if x != "-" else 0.0 for x in table[2].split()]
    return max(zip(pressure, (name for _, name in names)))


def print_row(options, title, cpu, body):
    assembly = as_assembly(body)
    items = options.items or items_of(body)
    answer = simulate(options, assembly, cpu)
    cycles = number(answer, "Total Cycles") / number(answer, "Iterations") / items
    pressure, port = busiest_port(answer)
    bound = max(number(answer, "Block RThroughput"), pressure) / items
    by = f"{port} ({pressure / items:.1f})" if pressure / items >= bound else f"dispatch; {port} {pressure / items:.1f}"
    count = len(assembly.splitlines()) - 1
    times = f"{cycles / options.clock:>8.2f}{bound / options.clock:>7.2f}"
    print(f"{title:9}{cpu:16}{count:>13}{items:>6}{cycles:>13.1f}{bound:>8.1f}  {by:28}{times}")
    if options.show:
        print(assembly + answer)
    return cycles, bound


def main():
    options = read_arguments()
    found = functions(options.object, options.symbol)
    if not found:
        sys.exit(f"{options.object}: no function with {options.symbol} in its name")
    print(f"{'clone':9}{'model':16}{'instructions':>13}{'items':>6}{'cycles/item':>13}{'bound':>8}  {'set by':28}{'ns/item':>8}{'bound':>7}")
    shown = 0
    for suffix, title, cpus in CLONES:
        bodies = [body for name, rows in found.items() if suffix in name for body in hot_loops(rows, options.least)]
        for cpu in options.cpu or cpus:
            both = [print_row(options, title, cpu, body) for body in bodies]
            if len(both) > 1:
                cycles, bound = (sum(values) for values in zip(*both))
                times = f"{cycles / options.clock:>8.2f}{bound / options.clock:>7.2f}"
                print(f"{title:9}{cpu:16}{'all loops':>13}{'':6}{cycles:>13.1f}{bound:>8.1f}  {'once an item each':28}{times}\n")
            shown += len(both)
    if shown == 0:
        sys.exit(f"{options.symbol}: none of its clones has a vectorized loop; found: {', '.join(found)}")
    print(f"\nns at {options.clock} GHz; Zen 4 takes a 512-bit instruction in two halves: its AVX-512 is bound as its AVX2 is")


if __name__ == "__main__":
    main()
