"""The results of a run as its finished stages record them, without how they were computed."""

import json

HOW = {"wall_seconds", "particle_steps_per_second", "seconds", "from_cache"}


def results_of(run):
    """Every finished stage's results, by its folder; None where stage.json cannot be read."""
    results = {}
    for path in sorted(run.glob("studies/**/stage.json")):
        try:
            numbers = json.loads(path.read_text(encoding="utf-8"))
        except ValueError:
            numbers = None
        results[str(path.parent.relative_to(run))] = results_alone(numbers)
    return results


def results_alone(value):
    if isinstance(value, dict):
        return {key: results_alone(one) for key, one in value.items() if key not in HOW}
    return [results_alone(one) for one in value] if isinstance(value, list) else value


def last_line(ended):
    """The last line that an ended program said."""
    lines = ended.stdout.strip().splitlines()
    return lines[-1] if lines else "no word"
