// The criteria of internal stability as suffuse/stability computes them, for the page of `suffuse assess --page`. Names,
// measures, fixed limits and senses are the program's (criterion_guide.cpp). page/check_assess.py compares every number with
// the program's. A grading: d [m] rising, f from 0 to 1, linear in
// log d between its points.
"use strict";

const Criteria = (() => {
  const defined = (id) => ({ id, ...pageData.criteria[id] });

  const passing = (g, size) => {
    const { d, f } = g, n = d.length;
    if (size <= d[0]) return f[0];
    if (size >= d[n - 1]) return f[n - 1];
    let k = 0;
    while (d[k + 1] <= size) ++k;
    return f[k] + (f[k + 1] - f[k]) * (Math.log(size / d[k]) / Math.log(d[k + 1] / d[k]));
  };

  const sizeAt = (g, share) => {
    const { d, f } = g, n = d.length;
    const above = f.findIndex((value) => value >= share);
    if (above === 0) {
      let last = 0;
      while (last + 1 < n && f[last + 1] <= f[0]) ++last;
      return d[last];
    }
    if (above < 0) return d[n - 1];
    const k = above - 1;
    return d[k] * (d[k + 1] / d[k]) ** ((share - f[k]) / (f[k + 1] - f[k]));
  };

  // The coarse end of a gap, where sizeAt gives its fine end.
  const coarseEndAt = (g, share) => {
    const above = g.f.findIndex((value) => value > share);
    return above > 0 && g.f[above - 1] === share ? g.d[above - 1] : sizeAt(g, share);
  };

  const uniformity = (g) => sizeAt(g, 0.6) / sizeAt(g, 0.1);

  const shapeCurve = (g, from, to) => {
    const first = sizeAt(g, from), last = coarseEndAt(g, to);
    const sizes = [first, last];
    for (const d of g.d) sizes.push(...[d, d / 4].filter((size) => size > first && size < last));
    sizes.sort((a, b) => a - b);
    return [...new Set(sizes)].map((d) => ({ d, finer: passing(g, d), more: passing(g, 4 * d) - passing(g, d) }));
  };

  // The least H/min(F, cap) where F and F(4d) are known; undefined where they are nowhere.
  const leastRatio = (g, limit, cap) => {
    const n = g.f.length, from = g.f[0], end = Math.min(limit, g.f[n - 1]);
    let least;
    for (const [low, high] of [[from, Math.min(cap, end)], [Math.max(from, cap), end]]) {
      for (const p of low <= high ? shapeCurve(g, low, high) : []) {
        const isKnown = g.f[n - 1] >= 1 || 4 * p.d <= g.d[n - 1], ratio = p.more / Math.min(p.finer, cap);
        if (isKnown && p.finer > 0 && (least === undefined || ratio < least)) least = ratio;
      }
    }
    return least;
  };

  const findGap = (g) => {
    const { d, f } = g, segments = d.length - 1;
    const isFlat = (k) => f[k + 1] - f[k] < 0.1 * Math.log10(d[k + 1] / d[k]);
    let found = null;
    for (let first = 0; first < segments; ++first) {
      if (!isFlat(first)) continue;
      let end = first;
      while (end < segments && isFlat(end)) ++end;
      const gap = { fine: d[first], coarse: d[end], finer: f[first] };
      const isSteeperBelow = first > 0 || f[0] > 0.2; // else it may be the tail of the curve
      const counts = isSteeperBelow && gap.coarse / gap.fine >= 1.5 && gap.finer >= 0.05 && f[end] <= 0.95;
      if (counts && (!found || gap.coarse / gap.fine > found.coarse / found.fine)) found = gap;
      first = end;
    }
    return found;
  };

  const split = (g) => {
    const margin = (size) => passing(g, 4 * size) - 2 * passing(g, size);
    const limit = uniformity(g) > 3 ? 0.2 : 0.3;
    const sizes = [...g.d, ...g.d.map((d) => d / 4)].sort((a, b) => a - b);
    let begin = null;
    for (let k = 0; k + 1 < sizes.length; ++k) {
      const m0 = margin(sizes[k]), m1 = margin(sizes[k + 1]);
      const falls = m0 >= 0 && m1 < 0, rises = m0 < 0 && m1 >= 0;
      if (!falls && !rises) continue;
      const crossing = sizes[k] * (sizes[k + 1] / sizes[k]) ** (m0 / (m0 - m1));
      if (falls && begin === null && passing(g, crossing) <= limit) begin = crossing;
      if (rises && begin !== null) return crossing;
    }
    return begin;
  };

  const fineFraction = (g) => {
    const gap = findGap(g);
    if (gap) return { size: gap.fine, content: gap.finer };
    const size = split(g);
    const content = size === null ? 0 : passing(g, size);
    return content > 0 && content < 1 ? { size, content } : null;
  };

  const judged = (c) => {
    const reaches = c.value >= c.limit * (1 - 1e-9), stays = c.value <= c.limit * (1 + 1e-9);
    const isStable = c.sense === "at-least" ? reaches : c.sense === "at-most" ? stays
      : reaches && c.value <= c.upper * (1 + 1e-9);
    return { ...c, verdict: isStable ? "stable" : "unstable" };
  };

  const onShape = (id, g, limit) => judged({ ...defined(id), value: leastRatio(g, limit, 1) });

  const liFannin = (g, limit) => judged({ ...defined("li-fannin-2008"), value: leastRatio(g, limit, 0.15) });

  // 15 % of the mass lie between d85 of the fine and D15 of the coarse part, wherever the split is.
  const kezdi = (g) => {
    const between = 0.15, part = 0.05;
    const first = part * (1 - between), last = (1 - part) * (1 - between);
    const below = [first, last];
    for (const f of g.f) below.push(f, f - between);
    let value = 0;
    for (const f of below) {
      if (f >= first && f <= last) value = Math.max(value, coarseEndAt(g, f + between) / sizeAt(g, f));
    }
    return judged({ ...defined("kezdi-1979"), value });
  };

  const slopes = (g) => {
    const d90 = sizeAt(g, 0.9), whole = d90 / sizeAt(g, 0.15);
    return { coarse: d90 / sizeAt(g, 0.6), whole, lower: 0.76 * Math.log10(whole) + 1, upper: 1.86 * Math.log10(whole) + 1 };
  };

  const burenkova = (g) => {
    const s = slopes(g);
    const c = { ...defined("burenkova-1993"), value: s.coarse, limit: s.lower, upper: s.upper };
    const isTested = sizeAt(g, 1) <= 0.1 && uniformity(g) <= 200;
    return isTested ? judged(c) : { ...c, verdict: "cannot say", why: "outside of what was tested" };
  };

  const wanFell = (g, fines) => {
    const s = slopes(g), hasSilt = passing(g, 0.075e-3) > 0.1, log = Math.log10(s.whole);
    const z = hasSilt ? 2.378 * log - 3.648 * s.coarse + 3.701 : 3.875 * log - 3.591 * s.coarse + 2.436;
    const c = { ...defined("wan-fell-logistic"), value: 1 / (1 + Math.exp(-z)) };
    const why = !(passing(g, 2e-3) < 1) ? "no gravel" : s.coarse > s.upper ? "beyond what was tested"
      : hasSilt && passing(g, 0.002e-3) > 0.1 ? "clay above 10 %"
      : hasSilt && fines && fines.content < 0.15 ? "fine fraction below 15 %" : "";
    return why ? { ...c, verdict: "cannot say", why } : judged(c);
  };

  const changZhang = (g, limit) => {
    const c = { ...defined("chang-zhang-2013"), strict: true };
    const percent = 100 * passing(g, 0.063e-3), gap = findGap(g);
    if (gap) {
      const value = gap.coarse / gap.fine;
      if (percent > 35) return { ...c, measure: "gap ratio Gr", sense: "at-most", value, verdict: "stable" };
      const most = percent < 10 ? 3 : 0.3 * percent;
      return { ...c, measure: "gap ratio Gr", sense: "at-most", value, limit: most, verified: percent < 10, verdict: value < most ? "stable" : "unstable" };
    }
    const value = leastRatio(g, limit, 1);
    if (percent >= 20) return { ...c, measure: "(H/F)min", sense: "at-least", value, verdict: "stable" };
    const least = percent < 5 ? 1 : 4 / 3 - percent / 15;
    return { ...c, measure: "(H/F)min", sense: "at-least", value, limit: least, verified: percent < 5, verdict: value > least ? "stable" : "unstable" };
  };

  const finerLimit = (g) => (uniformity(g) > 3 ? 0.2 : 0.3);

  const assessClosed = (g) => {
    const fines = fineFraction(g), limit = finerLimit(g);
    return [
      onShape("kenney-lau-1985", g, limit), onShape("kenney-lau-1986", g, limit), liFannin(g, limit), kezdi(g), burenkova(g),
      wanFell(g, fines), changZhang(g, limit),
    ];
  };

  // Ends that were not measured: cut sharply, tapering off, beyond a gap, or as much of it as is judged.
  const completions = (g) => {
    const sharp = 1e-3, first = g.d[0], missing = g.f[0], finest = first / 100;
    const begun = (sizes, shares) => ({ d: [...sizes, ...g.d], f: [...shares, ...g.f] });
    const fine = missing <= 0 ? [g]
      : [begun([first * (1 - sharp)], [0]), begun([finest], [0]), begun([finest * (1 - sharp), finest], [0, missing]),
        ...(missing > 0.2 ? [begun([finest * (1 - sharp), finest, first * (1 - sharp)], [0, 0.2, 0.2])] : [])];
    return fine.flatMap((b) => {
      const n = b.d.length, last = b.d[n - 1], share = b.f[n - 1], coarsest = 4 * last;
      const ended = (sizes, shares) => ({ d: [...b.d, ...sizes], f: [...b.f, ...shares] });
      return share >= 1 ? [b]
        : [ended([last * (1 + sharp)], [1]), ended([coarsest], [1]), ended([coarsest, coarsest * (1 + sharp)], [share, 1])];
    });
  };

  const same = (a, b) => a === b || (a !== undefined && b !== undefined && Math.abs(a - b) <= 1e-3 * Math.abs(a));

  const assess = (g) => {
    const completed = completions(g), all = completed.map(assessClosed), limit = Math.min(...completed.map(finerLimit));
    return all[0].map((sharp, k) => {
      const others = all.map((list) => list[k]), isOne = (key) => others.every((c) => same(c[key], sharp[key]));
      const sameMeasure = others.every((c) => c.measure === sharp.measure), sameLimit = isOne("limit") && isOne("upper");
      const first = { ...sharp, verified: others.every((c) => c.verified) };
      const sameVerdict = others.every((c) => c.verdict === first.verdict);
      const sameValue = others.every((c) => same(c.value, first.value));
      if (sameVerdict && sameValue) return first;
      const doAgree = sameVerdict && first.verdict !== "cannot say";
      if (!sameMeasure && (doAgree || first.measure !== "(H/F)min")) {
        first.measure = defined(first.id).measure;
        first.limit = undefined;
      }
      if (doAgree && !sameLimit) first.limit = first.upper = undefined;
      const cap = { "(H/F)min": 1, "min H/min(F, 15 %)": 0.15 }[first.measure];
      const ratio = cap && leastRatio(g, limit, cap); // of what was measured
      if (doAgree) {
        const values = others.map((c) => c.value);
        return { ...first, value: ratio, measured: ratio, range: sameMeasure ? [Math.min(...values), Math.max(...values)] : undefined };
      }
      const measured = cap ? ratio : sameMeasure ? first.value : undefined;
      return { ...first, value: ratio, measured, verdict: "cannot say", why: "depends on what was not measured" };
    });
  };

  /** The gradient of upward seepage that carries all grains. @param density of the grains [kg/m^3] */
  const heaveAt = (density, porosity) => (density / 1000 - 1) * (1 - porosity);

  // Upward seepage: what carries all grains, and what carries the fines.
  const gradients = ({ gradient, porosity, density, alpha }, criteria) => {
    const heave = heaveAt(density, porosity);
    const allCarry = criteria[0].verdict === "stable";
    const share = alpha ?? (allCarry ? 1 : undefined);
    return { heave, fines: share === undefined ? undefined : share * heave, share, needed: gradient / heave };
  };

  const tally = (criteria) => {
    const counted = criteria.filter((c) => c.verified && c.verdict !== "cannot say");
    return { counted: counted.length, unstable: counted.filter((c) => c.verdict === "unstable").length };
  };

  return { assess, gradients, heaveAt, passing, sizeAt, shapeCurve, tally, uniformity, findGap, fineFraction };
})();
