"""Densest packings of spheres of many sizes from a problem in one dimension [Farr and Groot 2009]: spheres become rods,
packed greedily on a line with gaps of at least f times the shorter neighbor; the share of the line that is covered is
the solid fraction. Theirs: f = 0.7654 gives 0.6435 for equal spheres.
"""

import heapq

import numpy

GAP = 0.7654  # f: least gap between two rods / the shorter of them


def rod_lengths(diameters, volume_shares, count):
    """Lengths of `count` rods, longest first: P(L) = 2 L times the integral over d > L of n(d), the chords of spheres
    met by a line, each size by its number n. Quantiles: nothing is random."""
    number = numpy.asarray(volume_shares) / numpy.asarray(diameters) ** 3
    longest = float(numpy.max(diameters))
    length = numpy.linspace(0, longest, 200_001)
    density = 2 * length * sum(n * (length < d) for n, d in zip(number, diameters))
    share = numpy.concatenate([[0], numpy.cumsum((density[1:] + density[:-1]) / 2)])
    quantile = (numpy.arange(count) + 0.5) / count
    return numpy.interp(quantile, share / share[-1], length)[::-1]


def solid_fraction(diameters, volume_shares, count=20_000):
    """Rods go into the largest gap, longest first; where none is wide enough, the line grows by what is missing."""
    rods = rod_lengths(diameters, volume_shares, count)
    gaps = [(-GAP * rods[0], rods[0], rods[0])]  # -width, and the rods on either side of it, on a ring
    for rod in rods[1:]:
        width, left, right = heapq.heappop(gaps)
        least = GAP * min(left, rod), GAP * min(rod, right)
        rest = max(0.0, -width - rod - sum(least))  # what is left beyond the least gaps stays on one side
        heapq.heappush(gaps, (-(least[0] + rest), left, rod))
        heapq.heappush(gaps, (-least[1], rod, right))
    return rods.sum() / (rods.sum() - sum(width for width, *_ in gaps))
