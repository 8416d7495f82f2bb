"""What `help(suffuse)` says, as a page: names, signatures, and their words as they stand."""

import inspect

import suffuse


def words_of(thing):
    return f"\n```\n{inspect.getdoc(thing) or ''}\n```\n"


def members(kind):
    for name in sorted(vars(kind)):
        if not name.startswith("_") and inspect.getdoc(getattr(kind, name)):
            yield name, getattr(kind, name)


print("# The Python module, name by name\n\nWhat `help(suffuse)` says. [How to use it](docs/how-to/use-from-python.md)")
print("has the same in order of a work.\n" + words_of(suffuse))
for name in suffuse.__all__:
    thing = getattr(suffuse, name)
    if inspect.ismodule(thing) or not (callable(thing) or inspect.isclass(thing)):
        continue
    print(f"\n## {name}\n{words_of(thing)}")
    if inspect.isclass(thing) and not issubclass(thing, BaseException):
        for member, value in members(thing):
            print(f"\n### {name}.{member}\n{words_of(value)}")
