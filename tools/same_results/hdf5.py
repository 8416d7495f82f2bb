"""What an HDF5 file holds, every array to the bit, by the library that the program is built with."""

import ctypes
import ctypes.util

from trees import Array

GROUP = 2  # of the kinds of objects
BY_NAME, INCREASING, DEFAULT, ALL = 0, 0, 0, 0
INTEGER, FLOAT, TEXT = 0, 1, 3  # of its classes of types
LETTERS = {(FLOAT, 4, 1): "f", (FLOAT, 8, 1): "d"}
for size, letter in ((1, "b"), (2, "h"), (4, "i"), (8, "q")):
    LETTERS[INTEGER, size, 1], LETTERS[INTEGER, size, 0] = letter, letter.upper()

handle, size_of, text_of, place = ctypes.c_int64, ctypes.c_uint64, ctypes.c_char_p, ctypes.c_void_p
SIGNATURES = {
    "H5Fopen": (handle, text_of, ctypes.c_uint, handle),
    "H5Fclose": (ctypes.c_int, handle),
    "H5Oopen": (handle, handle, text_of, handle),
    "H5Oclose": (ctypes.c_int, handle),
    "H5Iget_type": (ctypes.c_int, handle),
    "H5Gget_num_objs": (ctypes.c_int, handle, ctypes.POINTER(size_of)),
    "H5Gget_objname_by_idx": (ctypes.c_ssize_t, handle, size_of, place, ctypes.c_size_t),
    "H5Dget_space": (handle, handle),
    "H5Dget_type": (handle, handle),
    "H5Dread": (ctypes.c_int, handle, handle, handle, handle, handle, place),
    "H5Aget_num_attrs": (ctypes.c_int, handle),
    "H5Aopen_by_idx": (handle, handle, text_of, ctypes.c_int, ctypes.c_int, size_of, handle, handle),
    "H5Aget_name": (ctypes.c_ssize_t, handle, ctypes.c_size_t, place),
    "H5Aget_space": (handle, handle),
    "H5Aget_type": (handle, handle),
    "H5Aread": (ctypes.c_int, handle, handle, place),
    "H5Aclose": (ctypes.c_int, handle),
    "H5Sget_simple_extent_ndims": (ctypes.c_int, handle),
    "H5Sget_simple_extent_dims": (ctypes.c_int, handle, place, place),
    "H5Sclose": (ctypes.c_int, handle),
    "H5Tget_class": (ctypes.c_int, handle),
    "H5Tget_size": (ctypes.c_size_t, handle),
    "H5Tget_sign": (ctypes.c_int, handle),
    "H5Tis_variable_str": (ctypes.c_int, handle),
    "H5Tclose": (ctypes.c_int, handle),
    "H5Eset_auto2": (ctypes.c_int, handle, place, place),
}


def load_library():
    name = ctypes.util.find_library("hdf5_serial") or ctypes.util.find_library("hdf5") or "libhdf5_serial.so"
    library = ctypes.CDLL(name)
    for function, (result, *arguments) in SIGNATURES.items():
        getattr(library, function).restype = result
        getattr(library, function).argtypes = arguments
    library.H5open()
    library.H5Eset_auto2(0, None, None)
    return library


LIBRARY = load_library()


def call(function, *arguments):
    found = getattr(LIBRARY, function)(*arguments)
    if found < 0:
        raise ValueError(f"{function} refused: the file is damaged, or of a kind that is not read here")
    return found


def name_by(function, *arguments):
    """A name, by a function that takes room for it and the size of the room last."""
    buffer = ctypes.create_string_buffer(1024)
    call(function, *(buffer if argument is Ellipsis else argument for argument in arguments))
    return buffer.value.decode()


def shape_of(space):
    sizes = (size_of * max(1, call("H5Sget_simple_extent_ndims", space)))()
    rank = call("H5Sget_simple_extent_dims", space, sizes, None)
    return tuple(sizes[:rank])


def content(space, kind, read):
    """A text, or an array; `read` fills the bytes that it is given."""
    shape, group, width = shape_of(space), call("H5Tget_class", kind), LIBRARY.H5Tget_size(kind)
    count = 1
    for size in shape:
        count *= size
    buffer = ctypes.create_string_buffer(max(1, count * width))
    if count and (group != TEXT or not LIBRARY.H5Tis_variable_str(kind)):
        read(kind, buffer)
    if group == TEXT and not shape and not LIBRARY.H5Tis_variable_str(kind):
        return buffer.raw[:width].rstrip(b"\0").decode(errors="replace")
    signed = group == FLOAT or call("H5Tget_sign", kind)
    return Array(LETTERS[group, width, signed], shape, buffer.raw[:count * width])


def attributes_of(one):
    found = {}
    for index in range(call("H5Aget_num_attrs", one)):
        attribute = call("H5Aopen_by_idx", one, b".", BY_NAME, INCREASING, index, DEFAULT, DEFAULT)
        space, kind = call("H5Aget_space", attribute), call("H5Aget_type", attribute)
        name = name_by("H5Aget_name", attribute, 1024, ...)
        found["@" + name] = content(space, kind, lambda kind, buffer: call("H5Aread", attribute, kind, buffer))
        call("H5Tclose", kind), call("H5Sclose", space), call("H5Aclose", attribute)
    return found


def object_of(parent, name):
    one = call("H5Oopen", parent, name.encode(), DEFAULT)
    tree = attributes_of(one)
    if call("H5Iget_type", one) == GROUP:
        count = size_of()
        call("H5Gget_num_objs", one, ctypes.byref(count))
        for index in range(count.value):
            member = name_by("H5Gget_objname_by_idx", one, index, ..., 1024)
            tree[member] = object_of(one, member)
    else:
        space, kind = call("H5Dget_space", one), call("H5Dget_type", one)
        tree["values"] = content(space, kind, lambda kind, buffer: call("H5Dread", one, kind, ALL, ALL, DEFAULT, buffer))
        call("H5Tclose", kind), call("H5Sclose", space)
    call("H5Oclose", one)
    return tree


def read(path):
    file = call("H5Fopen", str(path).encode(), 0, DEFAULT)
    try:
        return object_of(file, "/")
    finally:
        LIBRARY.H5Fclose(file)
