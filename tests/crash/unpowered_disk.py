"""What a disk may hold after a power cut, from the calls that record_writes.c wrote down.

A write is safe once its file was synced after it; a name that came, went or was exchanged is safe once its folder was. Of all
else the disk keeps what it likes: each 4 KiB block of a write, each length, each name on its own. A block that it did not
keep holds what was there before, zeros or noise where there was nothing. A rename is kept whole or not at all.
"""

import dataclasses
import random

BLOCK = 4096
# What becomes of what is not yet safe: all of it kept, nothing, names alone, contents alone, or each as chance has it.
WAYS = ("kept", "lost", "names", "contents", "chance")
FIELDS = {"write": 3, "cut": 2, "sync": 2, "file": 3, "folder": 3, "rename": 3, "remove": 2}  # of a record


@dataclasses.dataclass
class Call:
    kind: str
    node: str  # the file or folder that it makes, changes, syncs or names
    at: int = 0  # where a write begins, or the length that is left
    data: bytes = b""
    entries: tuple = ()  # (folder, name) of what changes there
    safe_from: float = float("inf")  # the number of the call that makes it safe


class Node:
    """A file (content) or a folder (entries)."""

    def __init__(self, is_folder):
        self.is_folder = is_folder
        self.content = bytearray()
        self.entries = {}


def read_calls(log, root, lying=False):
    """The calls below `root` ("device:inode"), each with the moment from which it is safe; a lying disk syncs nothing."""
    nodes = {root: "root"}  # of inodes: a number that was given anew is another node
    named = {}  # node of each folder and name, as the program saw it
    calls, at = [], 0
    while at < len(log):
        end = log.index(b"\n", at)
        line = log[at:end].decode("utf-8", "surrogateescape")
        kind = line.split(" ", 1)[0]
        _, first, *more = line.split(" ", FIELDS[kind])
        at = end + 1
        data = b""
        if kind == "write":
            data = log[at:at + int(more[1])]
            at += len(data)
        if first not in nodes or (kind == "rename" and more[0] not in nodes):
            continue  # elsewhere
        if kind in ("write", "cut", "sync"):
            calls.append(Call(kind, nodes[first], at=int(more[0]), data=data))
            continue
        folder = nodes[first]
        if kind == "rename":
            old, new = more[1].split("/")
            entries = ((folder, old), (nodes[more[0]], new))
            named[entries[1]] = named.pop(entries[0])
            calls.append(Call(kind, named[entries[1]], entries=entries))
        elif kind == "remove":
            calls.append(Call(kind, named.pop((folder, more[0])), entries=((folder, more[0]),)))
        else:
            nodes[more[0]] = named[folder, more[1]] = f"{kind} {len(calls)}"
            calls.append(Call(kind, nodes[more[0]], entries=((folder, more[1]),)))
    if not lying:
        mark_safe(calls)
    return calls


def mark_safe(calls):
    synced = {}
    for number in range(len(calls) - 1, -1, -1):
        call = calls[number]
        if call.kind == "sync":
            synced[call.node] = number
        elif call.kind in ("write", "cut"):
            call.safe_from = synced.get(call.node, float("inf"))
        else:
            call.safe_from = max(synced.get(folder, float("inf")) for folder, _ in call.entries)


def disk_after(calls, moment, way, chance):
    """The root of what the disk holds when the power goes after the call of number `moment`."""
    root = Node(True)
    nodes = {"root": root}

    def keeps(call, kind_kept):
        if call.safe_from <= moment or way == "kept":
            return True
        return chance.random() < 0.5 if way == "chance" else way == kind_kept

    for call in calls[:moment + 1]:
        if call.kind in ("file", "folder"):
            nodes[call.node] = Node(call.kind == "folder")
        if call.kind == "write":
            keep_write(nodes[call.node].content, call, moment, way, chance)
        elif call.kind == "cut":
            if keeps(call, "contents"):
                resize(nodes[call.node].content, call.at)
        elif call.kind != "sync" and keeps(call, "names"):
            change_entries(nodes, call)
    return root


def keep_write(content, call, moment, way, chance):
    if call.safe_from <= moment or way in ("kept", "contents"):
        resize(content, max(len(content), call.at + len(call.data)))
        content[call.at:call.at + len(call.data)] = call.data
        return
    if way == "lost" or (way == "names" and chance.random() < 0.5):  # the length is neither name nor content
        return
    before = len(content)
    if chance.random() < 0.7:
        resize(content, max(before, call.at + len(call.data)))
    for start in range(call.at - call.at % BLOCK, call.at + len(call.data), BLOCK):
        first, last = max(start, call.at), min(start + BLOCK, call.at + len(call.data))
        if way == "chance" and chance.random() < 0.5:
            if len(content) >= last:
                content[first:last] = call.data[first - call.at:last - call.at]
        elif first >= before and len(content) >= last and chance.random() < 0.3:
            content[first:last] = chance.randbytes(last - first)


def resize(content, size):
    if size < len(content):
        del content[size:]
    else:
        content.extend(bytes(size - len(content)))


def change_entries(nodes, call):
    for folder, name in call.entries:
        nodes[folder].entries.pop(name, None)
    if call.kind != "remove":
        folder, name = call.entries[-1]
        nodes[folder].entries[name] = nodes[call.node]


def lay_out(node, place):
    """Writes what the disk holds into the folder `place`."""
    place.mkdir(parents=True)
    for name, entry in node.entries.items():
        if entry.is_folder:
            lay_out(entry, place / name)
        else:
            (place / name).write_bytes(entry.content)
